// SPDX-License-Identifier: Apache-2.0
// Where results wait to be asked for again.
#pragma once

#include <optional>
#include <string>

#include "reports/model/results.hpp"

namespace polhode::report {

/// Keeps results by the whole text of their key. A store that fails forgets: it never throws and never hands out what
/// was not saved under exactly this key.
class result_store {
 public:
  virtual ~result_store() = default;
  virtual std::optional<results> load(const std::string& key) = 0;
  /// Whether it is worth to load; what is there may prove to be damaged.
  virtual bool may_hold(const std::string& key) const = 0;
  virtual void save(const std::string& key, const results&) = 0;
};

}  // namespace polhode::report
