// The report as one page that needs nothing else: no network, no script, readable without colour and on paper.
#pragma once

#include <string>

#include "reports/model/results.hpp"

namespace polhode::report {

std::string to_html(const results&);

}  // namespace polhode::report
