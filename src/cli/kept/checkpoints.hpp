// SPDX-License-Identifier: Apache-2.0
// Unfinished simulations, kept beside the cached results.
#pragma once

#include <filesystem>
#include <string>
#include <utility>

#include "run/checkpoint_store.hpp"

namespace polhode::cli {

/// One file a key: a line with the length of the key, the key, the state, and the CRC-64 of all that. It appears in one
/// step; one that is damaged, cut short or of another key counts as absent.
class checkpoint_folder final : public checkpoint_store {
 public:
  enum class access { use, rewrite };  ///< rewrite: what is there is not read, but replaced

  /// Nothing is created before the first save. `when_there`: a state was loaded or saved.
  explicit checkpoint_folder(
      std::filesystem::path folder, access how = access::use, std::function<void()> when_there = [] {})
      : folder_(std::move(folder)), access_(how), when_there_(std::move(when_there)) {}

  bool load(const std::string& key, const std::function<void(const byte_source&)>& read) override;
  void save(const std::string& key, const std::function<void(const byte_sink&)>& write) override;

  /// What was loaded or saved: the run it is of has ended well.
  void forget();

  /// What the system said when something could not be saved, the first time; empty while all is well.
  const std::string& trouble() const { return trouble_; }

 private:
  std::filesystem::path file_of(const std::string& key) const;
  void found(std::filesystem::path);

  std::filesystem::path folder_, used_;
  access access_;
  std::function<void()> when_there_;
  std::string trouble_;
};

}  // namespace polhode::cli
