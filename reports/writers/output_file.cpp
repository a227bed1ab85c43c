// SPDX-License-Identifier: Apache-2.0
#include "reports/writers/output_file.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <system_error>

#include "reports/model/errors.hpp"
#include "reports/writers/disk.hpp"
#include "reports/writers/output_folder.hpp"

namespace polhode::report {

namespace fs = std::filesystem;

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
