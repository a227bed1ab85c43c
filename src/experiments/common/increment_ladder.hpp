// The former name of the coupled increments.
#pragma once

#include "experiments/common/coupled_increments.hpp"

namespace polhode {

using increment_ladder = coupled_increments;

}  // namespace polhode
