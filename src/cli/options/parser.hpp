// SPDX-License-Identifier: Apache-2.0
// The command line as options and commands. The parser's library costs seconds for each source that reads it: it stays
// behind these.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace CLI {
class App;
}

namespace polhode::cli {

/// A command registers itself with the parser; `run` does its work and returns the exit code.
struct command {
  CLI::App* parser;
  std::function<int()> run;
  bool shared = false;  ///< processes that are started together share its work; else the first one does it all
};
using add_commands = std::function<std::vector<command>(CLI::App& root)>;

/// Runs the command that is asked for, or prints help or version, and returns the exit code. Throws input_error of one
/// line for what is not known, with the nearest that is.
int run_command(int argc, char** argv, const add_commands&);

CLI::App& add_command(CLI::App& root, const std::string& name, const std::string& help);
void add_option(CLI::App&, const std::string& name, std::string&, const std::string& help, const std::string& type);
void add_option(CLI::App&, const std::string& name, std::optional<std::string>&, const std::string& help,
                const std::string& type);
void add_option(CLI::App&, const std::string& name, std::vector<std::string>&, const std::string& help,
                const std::string& type);
void add_flag(CLI::App&, const std::string& name, bool&, const std::string& help);

}  // namespace polhode::cli
