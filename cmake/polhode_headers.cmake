# What nearly every source of the laboratory reads, read once: two thirds of their compile time were spent on it.
# Switched off as any other project's: -D CMAKE_DISABLE_PRECOMPILE_HEADERS=ON.
function(polhode_read_common_headers target)
  target_precompile_headers(${target} PRIVATE ${POLHODE_COMMON_HEADERS} ${ARGN})
  # g++ 12 forgets which of them are the system's, and what it suspects in std::string it then says.
  target_compile_options(${target} PRIVATE
    "$<$<CXX_COMPILER_ID:GNU>:-Wno-array-bounds;-Wno-stringop-overflow;-Wno-stringop-overread;-Wno-restrict>")
endfunction()

set(POLHODE_COMMON_HEADERS
  <algorithm> <array> <atomic> <cmath> <complex> <cstdint> <functional> <limits> <map> <memory> <mutex> <numbers>
  <optional> <span> <string> <string_view> <utility> <vector>
  <Eigen/Dense> <fmt/format.h> <fmt/ranges.h> <polhode/scalar.hpp>)
