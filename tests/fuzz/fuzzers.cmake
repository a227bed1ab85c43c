# SPDX-License-Identifier: Apache-2.0
# The fuzzers, and with them what they read of the laboratory: instrumented, and without the inner loops.
if(NOT CMAKE_CXX_COMPILER_ID STREQUAL Clang)
  message(FATAL_ERROR "POLHODE_FUZZ needs clang, and ${CMAKE_CXX_COMPILER} is ${CMAKE_CXX_COMPILER_ID}; accepted: -D CMAKE_CXX_COMPILER=clang++-19")
endif()

set(src ${PROJECT_SOURCE_DIR}/src)
set(writers ${PROJECT_SOURCE_DIR}/reports/writers)
file(GLOB systems CONFIGURE_DEPENDS ${src}/systems/*.cpp ${src}/systems/*/*.cpp)
file(GLOB fuzzed CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/reports/model/*.cpp ${PROJECT_SOURCE_DIR}/reports/plots/*.cpp
  ${src}/comparison/*.cpp ${src}/sphere/closed_forms/*gibbs*.cpp ${src}/sphere/harmonics/*.cpp)
file(GLOB tapes CONFIGURE_DEPENDS ${src}/ensemble/tapes/*.cpp)
list(APPEND fuzzed ${systems} ${tapes} ${src}/ensemble/chen.cpp ${src}/platform/isa.cpp ${src}/problem/parameters.cpp ${src}/references/free_rotation.cpp
  ${src}/algebra/decompositions.cpp ${src}/sphere/sphere_problem.cpp ${src}/sphere/equilibria.cpp ${src}/sphere/site_observable.cpp
  ${src}/scene/scene_parse.cpp ${src}/scene/toml_table.cpp ${src}/scene/nearest.cpp
  ${src}/recorded/recording.cpp ${src}/recorded/recording_csv.cpp ${src}/recorded/recording_npy.cpp
  ${src}/recorded/transitions.cpp
  ${src}/foreign/greeting.cpp ${src}/foreign/frames.cpp ${src}/foreign/dialogue.cpp ${src}/foreign/naming.cpp
  ${writers}/json.cpp ${writers}/json_read.cpp ${writers}/json_rows.cpp ${writers}/json_values.cpp
  ${writers}/digest.cpp ${writers}/digest_read.cpp ${writers}/numbers.cpp ${writers}/npy.cpp
  ${writers}/comparison_text.cpp)

# Faces and what plays tapes on them are most of the compiler's time, and stay out: no harness binds.
set(unbound "")
foreach(entry tape_kernel tape_tangent_kernel coarsen)
  list(APPEND unbound "-Wl,--defsym=polhode_${entry}_portable=0")
endforeach()
foreach(source IN LISTS systems)
  file(READ ${source} text)
  string(REGEX MATCHALL "BOUND_TO_SCHEMES[(][a-z0-9_]*[a-z0-9]" bound "${text}")
  list(TRANSFORM bound REPLACE "BOUND_TO_SCHEMES[(]" "-Wl,--defsym=polhode_faces_")
  list(TRANSFORM bound APPEND "_portable=0")
  list(APPEND unbound ${bound})
endforeach()
list(REMOVE_DUPLICATES unbound)

set(sanitizers address,undefined)
add_library(polhode_fuzzed STATIC EXCLUDE_FROM_ALL ${fuzzed})
target_link_libraries(polhode_fuzzed PUBLIC polhode_options polhode::integrators Boost::headers fmt::fmt
  GSL::gsl nlohmann_json::nlohmann_json tomlplusplus::tomlplusplus CLI11::CLI11)
target_compile_options(polhode_fuzzed PUBLIC -fsanitize=fuzzer-no-link,${sanitizers} -fno-sanitize-recover=all)
polhode_read_common_headers(polhode_fuzzed <Eigen/Dense> <nlohmann/json.hpp>)

add_custom_target(polhode_fuzz)
foreach(name IN LISTS harnesses)
  add_executable(fuzz_${name} EXCLUDE_FROM_ALL ${name}.cpp ${${name}_sources})
  target_link_libraries(fuzz_${name} PRIVATE polhode_fuzzed)
  target_link_options(fuzz_${name} PRIVATE -fsanitize=fuzzer,${sanitizers} ${unbound})
  polhode_read_common_headers(fuzz_${name} AS polhode_fuzzed)
  add_dependencies(polhode_fuzz fuzz_${name})
endforeach()
