// SPDX-License-Identifier: Apache-2.0
// Where an unfinished simulation waits to be taken up again.
#pragma once

#include <functional>
#include <string>

#include "ensemble/ensemble_progress.hpp"

namespace polhode {

/// Keeps one state a key, the latest. A store that fails forgets: it never throws and never hands out what was not
/// saved whole under exactly this key.
class checkpoint_store {
 public:
  virtual ~checkpoint_store() = default;
  /// False where there is none.
  virtual bool load(const std::string& key, const std::function<void(const byte_source&)>& read) = 0;
  virtual void save(const std::string& key, const std::function<void(const byte_sink&)>& write) = 0;
};

}  // namespace polhode
