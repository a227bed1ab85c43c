// SPDX-License-Identifier: Apache-2.0
#include "reports/writers/result_folder.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <boost/crc.hpp>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <fstream>
#include <new>
#include <sstream>
#include <vector>

#include "reports/writers/json.hpp"

namespace polhode::report {
namespace {

namespace fs = std::filesystem;
constexpr std::string_view format_name = "polhode-cache 1", ending = ".result", unfinished_ending = ".unfinished";
constexpr std::chrono::hours longest_writing{1};

std::string crc64(std::string_view text) {
  boost::crc_optimal<64, 0x42F0E1EBA9EA3693, ~0ULL, ~0ULL, true, true> crc;
  crc.process_bytes(text.data(), text.size());
  return fmt::format("{:016x}", crc.checksum());
}

/// First line: format, CRC-64 of all that follows, length of the key. Then the key, then the document.
std::string packed(const std::string& key, const std::string& document) {
  const auto content = key + document;
  return fmt::format("{} {} {}\n{}", format_name, crc64(content), key.size(), content);
}

/// The document in the file, if the file is whole and of this key.
std::optional<std::string> unpacked(const std::string& file, const std::string& key) {
  const auto line = file.find('\n');
  if (line == std::string::npos) return std::nullopt;
  const std::string_view content = std::string_view(file).substr(line + 1);
  const auto expected = fmt::format("{} {} {}", format_name, crc64(content), key.size());
  if (file.compare(0, line, expected) != 0 || !content.starts_with(key)) return std::nullopt;
  return std::string(content.substr(key.size()));
}

struct kept_file {
  fs::path path;
  fs::file_time_type used;
  std::uintmax_t size;
};

/// The finished files of ours, longest unused first. Removes what dead processes did not finish.
std::vector<kept_file> files_in(const fs::path& folder) {
  std::vector<kept_file> files;
  std::error_code error;
  const auto now = fs::file_time_type::clock::now();
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
    std::error_code gone;  // by another process: not ours to count
    const kept_file file{entry->path(), entry->last_write_time(gone), entry->file_size(gone)};
    if (gone || !fs::is_regular_file(entry->symlink_status(gone))) continue;
    if (file.path.extension() == ending) files.push_back(file);
    if (file.path.extension() == unfinished_ending && now - file.used > longest_writing) fs::remove(file.path, gone);
  }
  std::ranges::sort(files, {}, &kept_file::used);
  return files;
}

}  // namespace

result_folder::result_folder(fs::path folder, access how, std::uintmax_t most_bytes)
    : folder_(std::move(folder)), access_(how), most_bytes_(most_bytes) {}

result_folder::~result_folder() {
  if (saved_) remove_oldest();
}

fs::path result_folder::file_of(const std::string& key) const { return folder_ / (crc64(key) + std::string(ending)); }

std::optional<results> result_folder::load(const std::string& key) try {
  if (access_ == access::rewrite) return std::nullopt;
  const auto path = file_of(key);
  std::ostringstream text;
  if (std::ifstream file(path, std::ios::binary); !file || !(text << file.rdbuf())) return std::nullopt;
  const auto document = unpacked(text.str(), key);
  if (!document) return std::nullopt;
  auto found = from_json(*document);
  std::error_code read_only;
  fs::last_write_time(path, fs::file_time_type::clock::now(), read_only);  // used just now
  return found;
} catch (const std::exception&) {  // whole, but not as this build reads it; or there is no memory for it
  return std::nullopt;
}

bool result_folder::may_hold(const std::string& key) const {
  std::error_code error;
  return access_ == access::use && fs::exists(file_of(key), error);
}

void result_folder::save(const std::string& key, const results& r) try {
  static std::atomic<unsigned> count = 0;
  const auto content = packed(key, to_json(r));
  std::error_code error;
  fs::create_directories(folder_, error);
  const auto path = file_of(key);
  const auto partial =
      folder_ / fmt::format(".{}-{}-{}{}", path.stem().string(), ::getpid(), ++count, unfinished_ending);
  errno = 0;
  if (!error) {
    std::ofstream file(partial, std::ios::binary);
    file << content;
    file.close();
    if (!file) error = {errno != 0 ? errno : EIO, std::generic_category()};
  }
  if (!error) fs::rename(partial, path, error);
  if (!error) {
    saved_ = true;
    return;
  }
  if (trouble_.empty()) trouble_ = error.message();
  std::error_code ignored;
  fs::remove(partial, ignored);
} catch (const std::bad_alloc&) {
  if (trouble_.empty()) trouble_ = "out of memory";
}

void result_folder::remove_oldest() const noexcept try {
  const auto files = files_in(folder_);
  std::uintmax_t bytes = 0;
  for (const auto& file : files) bytes += file.size;
  for (const auto& file : files) {
    if (bytes <= most_bytes_) return;
    std::error_code gone;
    fs::remove(file.path, gone);
    bytes -= file.size;
  }
} catch (const std::exception&) {  // a cache that is too large harms nobody
}

}  // namespace polhode::report
