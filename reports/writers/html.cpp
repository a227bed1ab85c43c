#include "reports/writers/html.hpp"

#include "reports/writers/heat_map.hpp"
#include "reports/writers/html_parts.hpp"
#include "reports/writers/svg_plot.hpp"
#include "reports/writers/text.hpp"

namespace polhode::report {

std::string to_html(const results& r) {
  std::string out;
  const auto name = escape_html(r.scene.name);
  html::put(out,
            "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
            "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
            "<meta name=\"color-scheme\" content=\"light dark\">\n"
            "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; style-src 'unsafe-inline'\">\n"
            "<title>{} · polhode</title>\n<style>\n{}{}{}</style>\n</head>\n<body>\n<main>\n",
            name, html::page_style(), plot_style(), heat_map_style());
  html::put_header(out, r);
  html::put_board(out, r);
  const auto experiments = experiment_names(r);
  for (std::size_t i = 0; i < experiments.size(); ++i) html::put_experiment(out, r, experiments[i], i);
  html::put_schemes(out, r);
  html::put_left_out(out, r);
  html::put_provenance(out, r.provenance);
  return out + "</main>\n</body>\n</html>\n";
}

}  // namespace polhode::report
