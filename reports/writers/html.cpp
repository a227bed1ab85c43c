// SPDX-License-Identifier: Apache-2.0
#include "reports/writers/html.hpp"

#include <algorithm>
#include <array>
#include <span>
#include <stdexcept>
#include <string_view>
#include <utility>
#include <vector>

#include "reports/writers/comparison_json.hpp"
#include "reports/writers/json.hpp"
#include "reports/writers/packed.hpp"
#include "reports/writers/page_template.hpp"
#include "reports/writers/text.hpp"

namespace polhode::report {
namespace {

// A place stands once in the template; what is put there is not searched.
std::size_t place_in(std::string_view page, std::string_view place) {
  const auto at = page.find(place);
  if (at == page.npos || page.find(place, at + 1) != page.npos)
    throw std::logic_error("the template of the report page does not name " + std::string(place) + " once");
  return at;
}

struct filling {
  std::string_view place;
  std::string text;
};

// In the order of the template: from the last place to the first, so that none moves before it is filled.
std::string filled(std::span<const filling> all) {
  std::string page;
  for (const auto piece : page_template()) page += piece;
  std::vector<std::size_t> at;
  for (const auto& one : all) at.push_back(place_in(page, one.place));
  if (!std::ranges::is_sorted(at)) throw std::logic_error("the template of the report page has its places in disorder");
  for (auto i = all.size(); i-- > 0;) page.replace(at[i], all[i].place.size(), all[i].text);
  return page;
}

std::string page_of(const results& r, std::string before, std::string changes) {
  return filled(std::array<filling, 4>{
      {{title_place, escape_html(r.scene.name) + (r.to_come.empty() ? "" : " (unfinished)") + " · polhode"},
       {results_place, packed(to_json(r))},
       {before_place, std::move(before)},
       {comparison_place, std::move(changes)}}});
}

}  // namespace

std::string to_html(const results& r) { return page_of(r, {}, {}); }

std::string to_html(const results& before, const results& after, const comparison& changes) {
  auto drawn = before;
  drawn.densities.clear();  // the page turns those of `after` alone
  return page_of(after, packed(to_json(drawn)), packed(to_json(std::span(&changes, 1))));
}

}  // namespace polhode::report
