// SPDX-License-Identifier: Apache-2.0
// Results kept in a folder, one file a key, so that a second run need not compute them again.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "reports/model/result_store.hpp"

namespace polhode::report {

/// The file of a key is named by the key's CRC-64 and holds a checksum, the whole key and the results as JSON. A file
/// that is damaged, cut short, or of another key counts as absent. A file appears in one step, so any number of
/// processes may share the folder. When this goes, the files that were longest unused are removed until the rest takes
/// at most `most_bytes`; files of other names are left alone.
class result_folder final : public result_store {
 public:
  enum class access { use, rewrite };  ///< rewrite: what is there is not read, but replaced
  static constexpr std::uintmax_t default_bytes = std::uintmax_t{256} << 20U;

  /// Nothing is created before the first save.
  explicit result_folder(std::filesystem::path, access = access::use, std::uintmax_t most_bytes = default_bytes);
  ~result_folder() override;
  result_folder(const result_folder&) = delete;
  result_folder& operator=(const result_folder&) = delete;

  std::optional<results> load(const std::string& key) override;
  bool may_hold(const std::string& key) const override;
  void save(const std::string& key, const results&) override;

  /// What the system said when something could not be saved, the first time; empty while all is well.
  const std::string& trouble() const { return trouble_; }

 private:
  std::filesystem::path file_of(const std::string& key) const;
  void remove_oldest() const noexcept;

  std::filesystem::path folder_;
  access access_;
  std::uintmax_t most_bytes_;
  std::string trouble_;
  bool saved_ = false;
};

}  // namespace polhode::report
