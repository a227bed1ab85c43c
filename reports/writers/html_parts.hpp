// The parts of the page, each appended to the text so far. Inside: whatever came from outside goes through escape_html.
#pragma once

#include <fmt/format.h>

#include <iterator>
#include <string>
#include <string_view>
#include <utility>

#include "reports/model/results.hpp"
#include "reports/writers/board.hpp"

namespace polhode::report::html {

template <class... Values>
void put(std::string& out, fmt::format_string<Values...> text, Values&&... values) {
  fmt::format_to(std::back_inserter(out), text, std::forward<Values>(values)...);
}

/// Symbol and word; the class only adds a colour.
std::string chip(verdict_kind, std::size_t times = 1);

/// The style sheet of the page.
std::string_view page_style();

void put_header(std::string& out, const results&);
void put_board(std::string& out, const results&);
void put_experiment(std::string& out, const results&, const std::string& name, std::size_t index);
void put_maps(std::string& out, const results&, const std::string& experiment);
/// Schemes × observables, for each quantity that has an interval but no step size.
void put_tables(std::string& out, const results&, const std::string& experiment);
/// The cheapest scheme for each accuracy, where that was asked.
void put_cost_table(std::string& out, const results&, const std::string& experiment);
void put_schemes(std::string& out, const results&);
void put_left_out(std::string& out, const results&);
void put_provenance(std::string& out, const provenance&);

}  // namespace polhode::report::html
