// SPDX-License-Identifier: Apache-2.0
// How a published number and ours read beside each other: as many digits as the interval has.
#pragma once

#include <string>

#include "reports/model/reproduction.hpp"

namespace polhode::report {

/// "0.589 ± 0.03", "at most 0.05", "1 to 2".
std::string shown_published(const reproduced_number&);
/// "0.5912 ± 0.0008"; the whole interval where it is not even, none where it is next to nothing.
std::string shown_ours(const reproduced_number&);
/// "by 0.081": how far ours lies from the published number or bound; empty where it agrees.
std::string shown_difference(const reproduced_number&);
/// "3 of 7 agree, 1 differs for the reason stated".
std::string sentence(const reproduction&);

}  // namespace polhode::report
