#include "reports/writers/html.hpp"

#include <stdexcept>
#include <string_view>

#include "reports/writers/json.hpp"
#include "reports/writers/page_template.hpp"
#include "reports/writers/text.hpp"

namespace polhode::report {
namespace {

// Inside a script element nothing but "<" can end it or begin a comment; JSON has another name for it.
std::string inert(std::string_view json) {
  std::string out;
  out.reserve(json.size());
  for (const char c : json)
    if (c == '<')
      out += "\\u003c";
    else
      out += c;
  return out;
}

// A place stands once in the template; what is put there is not searched.
std::size_t place_in(std::string_view page, std::string_view place) {
  const auto at = page.find(place);
  if (at == page.npos || page.find(place, at + 1) != page.npos)
    throw std::logic_error("the template of the report page does not name " + std::string(place) + " once");
  return at;
}

}  // namespace

std::string to_html(const results& r) {
  std::string page;
  for (const auto piece : page_template()) page += piece;
  const auto title = place_in(page, title_place), data = place_in(page, results_place);
  if (title > data) throw std::logic_error("the template of the report page has its title below its results");
  page.replace(data, results_place.size(), inert(to_json(r)));
  page.replace(title, title_place.size(), escape_html(r.scene.name) + " · polhode");
  return page;
}

}  // namespace polhode::report
