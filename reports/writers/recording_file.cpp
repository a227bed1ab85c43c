// SPDX-License-Identifier: Apache-2.0
#include "reports/writers/recording_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <bit>
#include <cerrno>
#include <fstream>
#include <string_view>
#include <utility>

#include "reports/writers/disk.hpp"
#include "reports/writers/npy.hpp"
#include "reports/writers/numbers.hpp"

namespace polhode::report {
namespace {

static_assert(std::endian::native == std::endian::little, "arrays are written as they are stored");

void write_at(int descriptor, std::string_view bytes, std::uint64_t at, const std::filesystem::path& known_as) {
  while (!bytes.empty()) {
    const auto written = ::pwrite(descriptor, bytes.data(), bytes.size(), static_cast<off_t>(at));
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) disk::fail(known_as, errno);
    bytes.remove_prefix(static_cast<std::size_t>(written));
    at += static_cast<std::uint64_t>(written);
  }
}

int created(const std::filesystem::path& file, const std::filesystem::path& known_as) {
  const int descriptor = ::open(file.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666);
  if (descriptor < 0) disk::fail(known_as, errno);
  return descriptor;
}

/// All of it is on the disk.
void finish(int& descriptor, const std::filesystem::path& known_as) {
  if (::fsync(descriptor) != 0 && errno != EINVAL && errno != ENOSYS && errno != ENOTSUP) disk::fail(known_as, errno);
  if (::close(std::exchange(descriptor, -1)) != 0 && errno != EINTR) disk::fail(known_as, errno);
}

struct text_file {
  const std::filesystem::path& known_as;
  int descriptor;
  std::uint64_t size = 0;
  text_file(const std::filesystem::path& file, const std::filesystem::path& name)
      : known_as(name), descriptor(created(file, name)) {}
  text_file(const text_file&) = delete;
  text_file& operator=(const text_file&) = delete;
  ~text_file() {
    if (descriptor >= 0) ::close(descriptor);
  }
  void append(std::string_view text) {
    write_at(descriptor, text, size, known_as);
    size += text.size();
  }
};

}  // namespace

recording_file::recording_file(std::filesystem::path file, shape s, std::filesystem::path known_as)
    : file_(std::move(file)), known_as_(std::move(known_as)), shape_(s), descriptor_(created(file_, known_as_)) {
  const auto header = npy_header_of_doubles({s.paths, s.records, s.components});
  header_ = header.size();
  write_at(descriptor_, header, 0, known_as_);
}

recording_file::~recording_file() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

void recording_file::write(std::uint64_t path, std::uint64_t first_record, std::span<const double> values) const {
  const auto place = (path * shape_.records + first_record) * shape_.components * sizeof(double);
  write_at(descriptor_, {reinterpret_cast<const char*>(values.data()), values.size_bytes()}, header_ + place,
           known_as_);
}

void recording_file::close() { finish(descriptor_, known_as_); }

void write_recording_csv(const std::filesystem::path& npy, recording_file::shape s, double dt,
                         std::span<const std::string> names, const std::filesystem::path& csv,
                         const std::filesystem::path& known_as) {
  std::ifstream in(npy, std::ios::binary);
  in.seekg(static_cast<std::streamoff>(npy_header_of_doubles({s.paths, s.records, s.components}).size()));
  text_file out(csv, known_as);
  std::string text = "path,t";
  for (const auto& name : names) text += ',' + name;
  text += '\n';
  std::vector<double> values(s.components);
  for (std::uint64_t path = 0; path < s.paths; ++path) {
    for (std::uint64_t record = 0; record < s.records; ++record) {
      in.read(reinterpret_cast<char*>(values.data()), static_cast<std::streamsize>(values.size() * sizeof(double)));
      text += fmt::format("{},{}", path, shortest(static_cast<double>(record) * dt));
      for (const double x : values) text += ',' + shortest(x);
      text += '\n';
      if (text.size() > 1 << 16) out.append(std::exchange(text, {}));
    }
  }
  if (!in) disk::fail(known_as, EIO);
  out.append(text);
  finish(out.descriptor, known_as);
}

}  // namespace polhode::report
