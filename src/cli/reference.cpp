// SPDX-License-Identifier: Apache-2.0
// polhode reference: exact answers about a scene, with how certain they are.
#include <fmt/format.h>

#include <memory>
#include <optional>

#include "cli/answers/json.hpp"
#include "cli/commands.hpp"
#include "cli/options/arguments.hpp"
#include "cli/terminal/terminal.hpp"
#include "run/reference.hpp"
#include "scene/scene.hpp"

namespace polhode::cli {
namespace {

constexpr int inconclusive = 3;

struct reference_arguments {
  std::string scene = "paper", quantity, format = "text";
  std::optional<std::string> observable, time, degree;
};

std::string shown_answer(const reference_answer& a) {
  const std::string what = a.quantity == "expectation" ? fmt::format("E[{}] at time {:g}", a.observable, *a.time)
                           : a.quantity == "gibbs"     ? fmt::format("stationary E[{}]", a.observable)
                           : a.quantity == "gap"       ? "spectral gap"
                                                       : "lambda_1";
  std::string out = fmt::format("{} = {:.12g} +- {:.1e}\n", what, a.value, a.uncertainty);
  if (a.sum) out += fmt::format("lambda_1 + lambda_2 = {:.12g}\n", *a.sum);
  if (a.dimension) out += fmt::format("dimension of the random attractor (Kaplan-Yorke) = {:.6g}\n", *a.dimension);
  out += a.degree > 0 ? fmt::format("{}, degree {}\n", a.method, a.degree) : a.method + '\n';
  return a.reason.empty() ? out : out + a.reason + '\n';
}

int run_reference(const reference_arguments& given) {
  const auto output = format_option(given.format);
  reference_options options{given.quantity, given.observable, {}, 0};
  if (given.time) options.time = nonnegative_option("--time", *given.time);
  if (given.degree)
    options.degree = static_cast<int>(integer_option("--degree", *given.degree, 1, most_reference_degree));
  const auto answer = reference(load_scene(given.scene), options);
  print(output == format::json ? to_json(answer) : shown_answer(answer));
  return answer.reason.empty() ? 0 : inconclusive;
}

}  // namespace

command add_reference(CLI::App& app) {
  const auto given = std::make_shared<reference_arguments>();
  auto& parser = add_command(app, "reference", "Exact expectations, stationary law, exponents; no sampling");
  add_option(parser, "SCENE", given->scene, "A built-in name or a TOML file [paper]", "");
  add_option(parser, "--quantity", given->quantity, "expectation, gibbs, lyapunov, gap", "Q");
  add_option(parser, "--observable", given->observable, "See polhode list observables [energy]", "NAME");
  add_option(parser, "--time", given->time, "Of the expectation [the horizon]", "T");
  add_option(parser, "--degree", given->degree, "Of the harmonics, 1 to 128 [chosen]", "L");
  add_option(parser, "--format", given->format, "text, json [text]", "F");
  return {&parser, [given] { return run_reference(*given); }};
}

}  // namespace polhode::cli
