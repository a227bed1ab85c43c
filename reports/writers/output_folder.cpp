// SPDX-License-Identifier: Apache-2.0
#include "reports/writers/output_folder.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <fstream>
#include <system_error>

#include "reports/model/errors.hpp"
#include "reports/model/text.hpp"
#include "reports/writers/disk.hpp"

namespace polhode::report {

namespace fs = std::filesystem;

std::string quoted(const fs::path& path) { return "'" + one_line(path.string()) + "'"; }

bool stands(const fs::path& path) {
  std::error_code error;
  const auto status = fs::status(path, error);
  if (error && status.type() != fs::file_type::not_found) disk::fail(path, error.value());
  return fs::exists(status);
}

fs::path settled(const fs::path& out) {
  if (out.empty()) throw input_error("output folder: the name is empty; give the name of a folder");
  std::error_code error;
  if (fs::is_symlink(out, error) && !fs::exists(out, error))
    throw input_error(fmt::format("output folder {}: is a link to nowhere; give a folder or a new name", quoted(out)));
  fs::path path = fs::weakly_canonical(fs::absolute(out), error);
  if (error) disk::fail(out, error.value());
  return path.has_filename() ? path : path.parent_path();
}

fs::path nearest_folder(const fs::path& path, const fs::path& out) {
  fs::path nearest = path;
  while (!stands(nearest)) nearest = nearest.parent_path();
  if (!fs::is_directory(nearest))
    throw input_error(
        fmt::format("output folder {}: {} is not a folder; give a folder or a new name", quoted(out), quoted(nearest)));
  return nearest;
}

std::string beginning_of(const fs::path& file, const fs::path& known_as) {
  std::ifstream in(file, std::ios::binary);
  if (!in && errno != ENOENT) disk::fail(known_as, errno);
  std::string bytes(256, '\0');
  in.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  bytes.resize(static_cast<std::size_t>(in.gcount()));
  return bytes;
}

void require_writable(const fs::path& folder, const fs::path& known_as) {
  if (::faccessat(AT_FDCWD, folder.c_str(), W_OK | X_OK, AT_EACCESS) != 0) disk::fail(known_as, errno);
}

made_parents::made_parents(const fs::path& folder) {
  std::vector<fs::path> missing;
  for (fs::path one = folder; !stands(one); one = one.parent_path()) missing.push_back(one);
  for (; !missing.empty(); missing.pop_back()) {
    disk::make_directory(missing.back(), missing.back());
    made_.push_back(missing.back());
  }
}

made_parents::~made_parents() {
  for (; !made_.empty(); made_.pop_back()) ::rmdir(made_.back().c_str());
}

fs::path settled_file(const fs::path& out) {
  if (out.empty()) throw input_error("output file: the name is empty; give the name of a file");
  std::error_code error;
  const fs::path path = fs::weakly_canonical(fs::absolute(out), error);
  if (error) disk::fail(out, error.value());
  if (!path.has_filename() || (stands(path) && !fs::is_regular_file(path)))
    throw input_error(fmt::format("output file {}: is not a file; give a file or a new name", quoted(out)));
  const auto folder = path.parent_path();
  if (!stands(folder)) disk::fail(out, ENOENT);
  if (!fs::is_directory(folder)) disk::fail(out, ENOTDIR);
  require_writable(folder, out);
  return path;
}

}  // namespace polhode::report
