# SPDX-License-Identifier: Apache-2.0
# What every target of the laboratory is compiled with. Users of the installed headers never see these.
add_library(polhode_options INTERFACE)
target_compile_features(polhode_options INTERFACE cxx_std_20)
target_include_directories(polhode_options INTERFACE ${PROJECT_SOURCE_DIR} ${PROJECT_SOURCE_DIR}/src)
target_compile_options(polhode_options INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion $<$<BOOL:${POLHODE_WERROR}>:-Werror>
  # g++ 12 sees overlapping copies in std::string where there are none (GCC bug 105651).
  $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>
  # clang sees a deprecated call inside libstdc++ 12's own std::stable_sort.
  $<$<CXX_COMPILER_ID:Clang>:-Wno-deprecated-declarations>)

find_program(POLHODE_CCACHE ccache)
if(POLHODE_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${POLHODE_CCACHE})
endif()

# A pack is an object of a class: under all checks of the address and undefined-behaviour sanitizers each intermediate value
# of a step lies in memory, its scope watched, also after the return, and its references held against null, and a step takes
# many times as long. Where steps are taken by the million it is watched when it is stored. Tests of the schemes themselves
# have every check.
set(POLHODE_PACKS_AS_NUMBERS)
if(CMAKE_CXX_FLAGS MATCHES "-fsanitize=address")
  set(POLHODE_PACKS_AS_NUMBERS -fno-sanitize=null,alignment -fno-sanitize-address-use-after-scope
    $<$<CXX_COMPILER_ID:GNU>:--param=asan-use-after-return=0>)
endif()
