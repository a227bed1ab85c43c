// Arguments of the command line: commands and the checks that they share. Every fault is an input_error of one line.
#pragma once

#include <cstdint>
#include <functional>
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
};
command add_verify(CLI::App&);
command add_simulate(CLI::App&);
command add_reference(CLI::App&);
command add_select(CLI::App&);
command add_compare(CLI::App&);
command add_list(CLI::App&);

/// Refuses what the parser did not recognise, and names the nearest that it knows.
void refuse_unknown(const CLI::App&, std::span<const command>);

/// "all processors", within what is accepted.
std::string default_threads();
int threads_option(std::string_view text);
/// A finite number above zero, or from zero on.
double positive_option(std::string_view option, std::string_view text);
double nonnegative_option(std::string_view option, std::string_view text);
std::uint64_t integer_option(std::string_view option, std::string_view text, std::uint64_t low, std::uint64_t high);
/// The index of the value in the list of those accepted.
std::size_t choice_option(std::string_view option, std::string_view text, std::span<const std::string> accepted);
/// "a,b" -> {a, b}, each once.
std::vector<std::string> list_option(std::string_view option, std::string_view text);

enum class format { text, json };
format format_option(std::string_view text);

}  // namespace polhode::cli
