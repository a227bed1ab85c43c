// SPDX-License-Identifier: Apache-2.0
// Recorded paths as a file of their own, streamed: written in pieces by several threads while the run goes on.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace polhode::report {

/// An array of doubles [path][record][component]: NPY, or at the end CSV, a row a state: path,t,names.
class recording_file {
 public:
  struct shape {
    std::uint64_t paths, records, components;
  };
  /// Creates the file. Throws output_error, which names it as `known_as`.
  recording_file(std::filesystem::path file, shape, std::filesystem::path known_as);
  ~recording_file();
  recording_file(const recording_file&) = delete;
  recording_file& operator=(const recording_file&) = delete;

  /// Successive records of one path.
  void write(std::uint64_t path, std::uint64_t first_record, std::span<const double> values) const;
  /// All of it is on the disk.
  void close();

 private:
  std::filesystem::path file_, known_as_;
  shape shape_;
  std::uint64_t header_ = 0;
  int descriptor_ = -1;
};

/// The same as text, read a path at a time; `dt`: the time from record to record.
void write_recording_csv(const std::filesystem::path& npy, recording_file::shape, double dt,
                         std::span<const std::string> names, const std::filesystem::path& csv,
                         const std::filesystem::path& known_as);

}  // namespace polhode::report
