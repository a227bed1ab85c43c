// SPDX-License-Identifier: Apache-2.0
// The arguments of a command, one a line of the input, given to options of each kind.
#include <sstream>

#include "cli/options/parser.hpp"
#include "fuzz.hpp"
#include "run/provenance.hpp"

// In place of src/run, for --version.
namespace polhode {
report::provenance build_provenance() { return {}; }
}  // namespace polhode

namespace {

using namespace polhode;

struct given {
  std::string scheme = "heun";
  std::optional<std::string> dt;
  std::vector<std::string> scenes, with;
  bool quiet = false;
};

std::vector<cli::command> commands(CLI::App& root, given& to) {
  auto& verify = cli::add_command(root, "verify", "Verify");
  cli::add_option(verify, "SCENE", to.scenes, "Scenes", "");
  cli::add_option(verify, "--with", to.with, "Integrators", "FILE");
  cli::add_option(verify, "--dt", to.dt, "Step size", "H");
  cli::add_flag(verify, "-q,--quiet", to.quiet, "No summary");
  auto& list = cli::add_command(root, "list", "List");
  cli::add_option(list, "--scheme", to.scheme, "Scheme", "NAME");
  return {{&verify, [] { return 0; }}, {&list, [] { return 0; }}};
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::vector<std::string> words{"polhode"};
  std::istringstream lines{std::string(fuzz::text_of(data, size))};
  for (std::string word; std::getline(lines, word);) words.emplace_back(word.c_str());  // none holds a zero byte
  std::vector<char*> arguments;
  for (auto& word : words) arguments.push_back(word.data());
  fuzz::taken([&] {
    given to;
    return cli::run_command(static_cast<int>(arguments.size()), arguments.data(),
                            [&](CLI::App& root) { return commands(root, to); });
  });
  return 0;
}
