# SPDX-License-Identifier: Apache-2.0
# What every target of the laboratory is compiled with. Users of the installed headers never see these.
add_library(polhode_options INTERFACE)
target_compile_features(polhode_options INTERFACE cxx_std_20)
target_include_directories(polhode_options INTERFACE ${PROJECT_SOURCE_DIR} ${PROJECT_SOURCE_DIR}/src)
target_compile_options(polhode_options INTERFACE
  -Wall -Wextra -Wpedantic
  # Where sources are joined, a local name of one may be that of a constant of another.
  $<$<NOT:$<BOOL:$<TARGET_PROPERTY:UNITY_BUILD>>>:-Wshadow>
  -Wconversion -Wno-sign-conversion $<$<BOOL:${POLHODE_WERROR}>:-Werror>
  # g++ 12 sees overlapping copies in std::string where there are none (GCC bug 105651).
  $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>
  # clang sees a deprecated call inside libstdc++ 12's own std::stable_sort.
  $<$<CXX_COMPILER_ID:Clang>:-Wno-deprecated-declarations>)

find_program(POLHODE_CCACHE ccache)
if(POLHODE_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${POLHODE_CCACHE})
endif()

# The largest objects take 1.2 GB of the compiler's memory: on a small machine fewer are made at a time than it has
# processors.
if(PROJECT_IS_TOP_LEVEL)
  cmake_host_system_information(RESULT memory QUERY TOTAL_PHYSICAL_MEMORY)  # in MiB
  cmake_host_system_information(RESULT processors QUERY NUMBER_OF_LOGICAL_CORES)
  math(EXPR jobs "${memory} / 1400")
  if(jobs LESS processors)
    if(jobs LESS 1)
      set(jobs 1)
    endif()
    message(STATUS "${memory} MiB of memory: compiles at most ${jobs} sources at a time")
    set_property(GLOBAL PROPERTY JOB_POOLS compiling=${jobs})
    set(CMAKE_JOB_POOL_COMPILE compiling)
    set(CMAKE_JOB_POOL_PRECOMPILE_HEADER compiling)
  endif()
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
