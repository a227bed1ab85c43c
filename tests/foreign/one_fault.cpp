// SPDX-License-Identifier: Apache-2.0
// A library that does one thing wrong, which the environment names.
#include <polhode/abi.h>

#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <stdexcept>

namespace {

bool is(const char* fault) {
  const char* chosen = std::getenv("POLHODE_ONE_FAULT");
  return chosen != nullptr && std::strcmp(chosen, fault) == 0;
}

void may_throw(const char* with_words, const char* without) {
  if (is(with_words)) throw std::runtime_error("no licence");
  if (is(without)) throw 7;
}

int open_it(const polhode_scene*, void**, char* why, size_t bytes) {
  may_throw("open throws words", "open throws a number");
  if (is("refuses")) std::strncpy(why, "knows spins\nalone", bytes);
  if (is("refuses without end")) std::memset(why, 'x', bytes);
  return is("refuses") || is("refuses without end") || is("refuses in silence") ? 3 : 0;
}

int advance(void*, const polhode_batch*) {
  may_throw("advance throws words", "advance throws a number");
  return 0;
}

}  // namespace

const polhode_integrator* polhode_integrators(uint32_t, int32_t* count) {
  may_throw("entry throws words", "entry throws a number");
  static polhode_integrator one{
      sizeof(polhode_integrator), 0, 0, "mine", nullptr, nullptr, {}, open_it, advance, nullptr, nullptr, 0};
  static constexpr polhode_variable two_points{POLHODE_TWO_POINT, 3};
  if (is("small")) one.size = 8;
  if (is("draws") || is("of old")) one.draws = &two_points, one.drawn = 1;
  if (is("of old")) one.size = offsetof(polhode_integrator, draws);  // what comes after is not its own
  if (is("nameless")) one.name = nullptr;
  if (is("spaced")) one.name = "my heun";
  if (is("long")) one.name = "a_name_of_more_than_thirty_two_letters";
  if (is("ours")) one.name = "heun";
  if (is("takes")) one.takes = 9;
  if (is("order")) one.claims.strong_general = -2;
  if (is("nan")) one.claims.weak_general = NAN;
  if (is("casimir")) one.claims.casimir = 21;
  if (is("half")) one.claims.deterministic = 1.5;
  if (is("no open")) one.open = nullptr;
  if (is("no advance")) one.advance = nullptr;
  *count = is("empty") ? 0 : 1;
  return is("none") ? nullptr : &one;
}
