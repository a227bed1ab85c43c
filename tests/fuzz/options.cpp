// SPDX-License-Identifier: Apache-2.0
// Values given on the command line: each kind of option is given the same text.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <limits>

#include "cli/options/arguments.hpp"
#include "fuzz.hpp"
#include "reports/writers/numbers.hpp"
#include "scene/nearest.hpp"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace polhode;
  static const std::vector<std::string> known{"heun", "strang", "lie_heun", "heun_projected", "pi1"};
  const auto text = fuzz::text_of(data, size);
  const auto number = fuzz::taken([&] { return cli::positive_option("--dt", text); });
  if (number) fuzz::demand(cli::nonnegative_option("--dt", report::shortest(number)) == *number, "a number stays");
  fuzz::taken([&] { return cli::nonnegative_option("--time", text); });
  constexpr auto most = std::numeric_limits<std::uint64_t>::max();
  const auto seed = fuzz::taken([&] { return cli::integer_option("--seed", text, 0, most); });
  if (seed) fuzz::demand(cli::integer_option("--seed", std::to_string(*seed), 0, most) == *seed, "a seed stays");
  const auto threads = fuzz::taken([&] { return cli::threads_option(text); });
  if (threads) fuzz::demand(*threads >= 1 && *threads <= 1024, "threads are from 1 to 1024");
  const auto names = fuzz::taken([&] { return cli::list_option("--schemes", text); });
  if (names)
    fuzz::demand(cli::list_option("--schemes", fmt::format("{}", fmt::join(*names, ","))) == *names, "a list stays");
  fuzz::taken([&] { return cli::format_option(text); });
  fuzz::taken([&] { return choose("--scheme", text, known); });
  return 0;
}
