# SPDX-License-Identifier: Apache-2.0
# What nearly every source reads, read once: two thirds of their compile time were spent on it. A target has them and further
# ones of its own (polhode_read_common_headers(target [HEADER…])), or AS another target whose flags are the same.
# Switched off as any other project's: -D CMAKE_DISABLE_PRECOMPILE_HEADERS=ON.
function(polhode_read_common_headers target)
  cmake_parse_arguments(PARSE_ARGV 1 given "" "AS" "")
  if(given_AS)
    target_precompile_headers(${target} REUSE_FROM ${given_AS})
  else()
    target_precompile_headers(${target} PRIVATE ${POLHODE_COMMON_HEADERS} ${given_UNPARSED_ARGUMENTS})
  endif()
  # g++ 12 forgets which of them are the system's, and what it suspects in std::string it then says.
  target_compile_options(${target} PRIVATE
    "$<$<CXX_COMPILER_ID:GNU>:-Wno-array-bounds;-Wno-stringop-overflow;-Wno-stringop-overread;-Wno-restrict>")
endfunction()

set(POLHODE_COMMON_HEADERS
  <algorithm> <array> <atomic> <cmath> <complex> <cstdint> <functional> <limits> <map> <memory> <mutex> <numbers>
  <optional> <span> <string> <string_view> <utility> <vector>
  <fmt/format.h> <fmt/ranges.h> ${PROJECT_SOURCE_DIR}/reports/model/results.hpp)
set(POLHODE_NUMERICAL_HEADERS <Eigen/Dense> <polhode/simd.hpp>)

# For what runs once: nothing there is worth a second of the compiler's. Such a target needs headers of its own, or those
# of one like it: without a word g++ compiles a source as its precompiled headers were compiled, whatever its own -O says.
set(POLHODE_RUNS_ONCE $<$<CONFIG:Release>:-O1>)
