// SPDX-License-Identifier: Apache-2.0
#include "cli/kept/checkpoints.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <boost/crc.hpp>
#include <cerrno>
#include <fstream>
#include <stdexcept>
#include <system_error>

namespace polhode::cli {
namespace {

namespace fs = std::filesystem;
using crc64 = boost::crc_optimal<64, 0x42F0E1EBA9EA3693, ~0ULL, ~0ULL, true, true>;
using sum_type = crc64::value_type;

std::string head_of(const std::string& key) { return fmt::format("polhode-checkpoint 1 {}\n{}", key.size(), key); }

/// Whether the file begins with the head and ends with its own sum.
bool is_whole(std::ifstream& file, const std::string& head) {
  crc64 crc;
  std::array<char, 1 << 16> piece;
  const auto size = file.seekg(0, std::ios::end).tellg();
  auto left = static_cast<std::int64_t>(size) - static_cast<std::int64_t>(sizeof(sum_type));
  if (left < static_cast<std::int64_t>(head.size())) return false;
  file.seekg(0);
  for (bool first = true; left > 0; first = false) {
    const auto n = std::min<std::int64_t>(left, piece.size());
    if (!file.read(piece.data(), n)) return false;
    const auto known = std::min(head.size(), static_cast<std::size_t>(n));
    if (first && !std::equal(head.begin(), head.begin() + static_cast<std::ptrdiff_t>(known), piece.begin()))
      return false;
    crc.process_bytes(piece.data(), static_cast<std::size_t>(n));
    left -= n;
  }
  sum_type sum = 0;
  file.read(reinterpret_cast<char*>(&sum), sizeof sum);
  return file && sum == crc.checksum();
}

void write_whole(const fs::path& path, const std::string& head, const std::function<void(const byte_sink&)>& write) {
  std::ofstream file(path, std::ios::binary);
  crc64 crc;
  const byte_sink sink = [&](const void* bytes, std::size_t count) {
    crc.process_bytes(bytes, count);
    file.write(static_cast<const char*>(bytes), static_cast<std::streamsize>(count));
    if (!file) throw std::system_error(errno != 0 ? errno : EIO, std::generic_category());
  };
  errno = 0;
  sink(head.data(), head.size());
  write(sink);
  const sum_type sum = crc.checksum();
  file.write(reinterpret_cast<const char*>(&sum), sizeof sum);
  file.close();
  if (!file) throw std::system_error(errno != 0 ? errno : EIO, std::generic_category());
}

}  // namespace

fs::path checkpoint_folder::file_of(const std::string& key) const {
  crc64 crc;
  crc.process_bytes(key.data(), key.size());
  return folder_ / fmt::format("{:016x}.checkpoint", crc.checksum());
}

void checkpoint_folder::found(fs::path file) {
  used_ = std::move(file);
  when_there_();
}

bool checkpoint_folder::load(const std::string& key, const std::function<void(const byte_source&)>& read) {
  if (access_ == access::rewrite) return false;
  std::ifstream file(file_of(key), std::ios::binary);
  const auto head = head_of(key);
  if (!file || !is_whole(file, head)) return false;
  file.seekg(static_cast<std::streamoff>(head.size()));
  read([&](void* bytes, std::size_t count) {
    if (!file.read(static_cast<char*>(bytes), static_cast<std::streamsize>(count)))
      throw std::runtime_error("cut short");
  });
  found(file_of(key));
  return true;
}

void checkpoint_folder::save(const std::string& key, const std::function<void(const byte_sink&)>& write) {
  std::error_code error;
  fs::create_directories(folder_, error);
  const auto path = file_of(key);
  // Of the cache's unfinished files by its name: whoever cleans up there removes this one, too, once its maker is dead.
  const auto partial = folder_ / fmt::format(".{}-{}.unfinished", path.filename().string(), ::getpid());
  if (!error) try {
      write_whole(partial, head_of(key), write);
      fs::rename(partial, path, error);
    } catch (const std::system_error& e) {
      error = e.code();
    }
  if (!error) return found(path);
  if (trouble_.empty()) trouble_ = error.message();
  std::error_code ignored;
  fs::remove(partial, ignored);
}

void checkpoint_folder::forget() {
  std::error_code ignored;
  if (!used_.empty()) fs::remove(used_, ignored);
}

}  // namespace polhode::cli
