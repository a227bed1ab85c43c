// SPDX-License-Identifier: Apache-2.0
#include "reports/writers/latex.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "reports/model/text.hpp"
#include "reports/writers/board.hpp"
#include "reports/writers/cost_error.hpp"
#include "reports/writers/numbers.hpp"
#include "reports/writers/series.hpp"
#include "reports/writers/text.hpp"

namespace polhode::report {
namespace {

constexpr std::string_view preamble = R"(\documentclass[a4paper,10pt]{article}
\usepackage[margin=22mm]{geometry}
\usepackage{booktabs,longtable,pgfplots}
\setcounter{LTchunksize}{1000} % tables are right after one run
\pgfplotsset{compat=1.17, width=0.92\textwidth, height=0.55\textwidth,
  legend style={font=\scriptsize, at={(1.02,1)}, anchor=north west, draw=none, cells={anchor=west}},
  tick label style={font=\scriptsize}, label style={font=\small}, every axis plot/.append style={mark size=1.5pt}}
% Okabe and Ito's colours, which readers of all kinds of colour vision tell apart; marks and dashes say the same.
\definecolor{c0}{HTML}{0072B2}\definecolor{c1}{HTML}{D55E00}\definecolor{c2}{HTML}{009E73}\definecolor{c3}{HTML}{CC79A7}
\definecolor{c4}{HTML}{E69F00}\definecolor{c5}{HTML}{56B4E9}\definecolor{c6}{HTML}{000000}
)";

constexpr std::size_t colours = 7;
constexpr std::array<std::string_view, 5> marks{"*", "square*", "triangle*", "diamond*", "x"};
constexpr std::array<std::string_view, 3> dashes{"solid", "densely dashed", "densely dotted"};

std::string style_of(std::size_t i) {
  return fmt::format("c{},mark={},{}", i % colours, marks[i % marks.size()], dashes[i / colours % dashes.size()]);
}

/// Numbers as pgfplots reads them.
std::string number_of(double x) { return fmt::format("{:.10g}", x); }

bool is_drawn(const plot& p, const plot_point& at) {
  return std::isfinite(at.x) && std::isfinite(at.y) && (!p.log_x || at.x > 0) && (!p.log_y || at.y != 0);
}

/// x, y and how far the interval reaches up and down; on a logarithmic axis not to zero.
std::string coordinates_of(const plot& p, const plot_point& at) {
  const double y = p.log_y ? std::fabs(at.y) : at.y;
  const auto reach = [&](std::optional<double> end) {
    const double length = end && std::isfinite(*end) ? std::fabs(*end - at.y) : 0;
    return number_of(length);
  };
  const bool to_zero = p.log_y && at.low && *at.low <= 0;
  return fmt::format("{} {} {} {}\\\\\n", number_of(at.x), number_of(y), reach(at.high), to_zero ? "0" : reach(at.low));
}

std::string series_source(const plot& p, const plot_series& s) {
  std::string rows;
  for (const auto& at : s.points)
    if (is_drawn(p, at)) rows += coordinates_of(p, at);
  if (rows.empty()) return "";
  const auto style = style_of(s.style);
  std::string out = fmt::format(
      "\\addplot[{},{}error bars/.cd,y dir=both,y explicit] table[x=x,y=y,y error plus=p,y error minus=m,"
      "row sep=\\\\]{{\nx y p m\\\\\n{}}};\n\\addlegendentry{{{}}}\n",
      style, s.fitted ? "only marks," : "", rows, escape_latex(s.name));
  if (!s.fitted) return out;
  double low = INFINITY, high = 0;
  for (const auto& at : s.points)
    if (at.fitted && is_drawn(p, at)) {
      low = std::min(low, at.x);
      high = std::max(high, at.x);
    }
  if (low < high)
    out += fmt::format("\\addplot[{},mark=none,forget plot,domain={}:{},samples=2] {{{}*x^({})}};\n", style,
                       number_of(low), number_of(high), number_of(s.fitted->prefactor), number_of(s.fitted->order));
  return out;
}

std::string plot_source(const plot& p) {
  std::string series;
  for (const auto& s : p.series) series += series_source(p, s);
  if (series.empty()) return "";
  const char* axis = p.log_x && p.log_y ? "loglogaxis" : p.log_x ? "semilogxaxis" : p.log_y ? "semilogyaxis" : "axis";
  return fmt::format(
      "\\begin{{figure}}[htbp]\\centering\n\\begin{{tikzpicture}}\n\\begin{{{0}}}[width=0.72\\textwidth,xlabel={{{1}}},"
      "ylabel={{{2}}}]\n{3}\\end{{{0}}}\n\\end{{tikzpicture}}\n\\caption{{{4}}}\n\\end{{figure}}\n\n",
      axis, escape_latex(p.x_title), escape_latex(p.y_title), series, escape_latex(p.title));
}

std::string table_of(const std::vector<const verdict*>& rows) {
  std::string out =
      "\\begin{longtable}{@{}llrrll@{}}\n\\toprule\nscheme & claim & claimed & found & 95\\,\\% interval & "
      "verdict\\\\\n"
      "\\midrule\n";
  for (const auto* v : rows)
    out += fmt::format("{} & {} & {} & {} & {} & {}\\\\\n", escape_latex(v->scheme), escape_latex(v->claim),
                       escape_latex(shown(v->expected)), escape_latex(shown(v->estimate)),
                       escape_latex(shown_interval(v->low, v->high)), name_of(v->kind));
  return out + "\\bottomrule\n\\end{longtable}\n\n";
}

std::string cost_table_source(const results& r, const std::string& experiment) {
  const auto lines = cost_table_of(r, experiment);
  if (lines.empty()) return "";
  std::string out =
      "\\begin{longtable}{@{}llrrr@{}}\n\\toprule\nto reach & cheapest & $dt$ & ns a path and unit of time & times to "
      "the "
      "next\\\\\n\\midrule\n";
  for (const auto& [what, cost, next] : lines)
    out += fmt::format("{} & {} & {} & {} & {}\\\\\n", escape_latex(what), escape_latex(cost->scheme),
                       escape_latex(shown(cost->dt())), escape_latex(shown(cost->value)),
                       next != nullptr ? escape_latex(shown(next->value)) : "--");
  return out + "\\bottomrule\n\\end{longtable}\n\n";
}

std::string section_of_experiment(const results& r, const std::string& name) {
  std::string out = fmt::format("\\section*{{{}}}\n", escape_latex(name));
  if (const auto* e = find_experiment(r, name)) out += escape_latex(e->question) + "\n\n";
  if (const auto rows = verdicts_of(r, name); !rows.empty()) out += table_of(rows);
  out += cost_table_source(r, name);
  for (const auto& p : drawable_plots(r, name)) out += plot_source(p);
  return out + "\\clearpage\n";
}

struct letter {
  std::string_view text, command;
};
constexpr letter letters[] = {{"Π", "$\\Pi$"},     {"Ω", "$\\Omega$"},
                              {"θ", "$\\theta$"},  {"σ", "$\\sigma$"},
                              {"λ", "$\\lambda$"}, {"μ", "$\\mu$"},
                              {"−", "$-$"},        {"±", "$\\pm$"},
                              {"×", "$\\times$"},  {"·", "$\\cdot$"},
                              {"–", "--"},         {"…", "\\ldots{}"},
                              {"₁", "$_1$"},       {"₂", "$_2$"},
                              {"²", "$^2$"},       {"³", "$^3$"},
                              {"√", "$\\sqrt{}$"}, {"≤", "$\\leq$"},
                              {"≥", "$\\geq$"},    {"∝", "$\\propto$"},
                              {"|", "$|$"},        {"<", "$<$"},
                              {">", "$>$"},        {"^", "\\^{}"},
                              {"~", "\\~{}"},      {"\\", "\\textbackslash{}"},
                              {"&", "\\&"},        {"%", "\\%"},
                              {"$", "\\$"},        {"#", "\\#"},
                              {"_", "\\_"},        {"{", "\\{"},
                              {"}", "\\}"},        {"[", "{[}"},
                              {"]", "{]}"},        {"\"", "''"}};

}  // namespace

std::string escape_latex(std::string_view text) {
  const std::string plain = one_line(printable(text), text.npos);
  std::string out;
  for (std::string_view rest = plain; !rest.empty();) {
    const auto one = take_character(rest).bytes;
    const auto* known = std::ranges::find(letters, one, &letter::text);
    out += known != std::end(letters) ? known->command : one.size() == 1 ? one : "?";
  }
  return out;
}

std::string to_latex(const results& r) {
  std::string out =
      fmt::format("% polhode {} ({}), seed {}, effort {}\n", escape_latex(r.provenance.version),
                  escape_latex(r.provenance.commit), r.provenance.seed, escape_latex(r.provenance.effort));
  out += preamble;
  out += fmt::format("\\begin{{document}}\n\\section*{{Scene {}}}\n{}\n\n", escape_latex(r.scene.name),
                     escape_latex(sentence(count(r.verdicts))));
  for (const auto& name : experiment_names(r)) out += section_of_experiment(r, name);
  return out + "\\end{document}\n";
}

}  // namespace polhode::report
