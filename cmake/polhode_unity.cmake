# SPDX-License-Identifier: Apache-2.0
# The sources of a folder compiled as one: they read the same headers, and reading takes most of their time. A changed
# source then costs what its folder costs, so this is for builds from nothing.
option(POLHODE_UNITY "Compile the sources of each folder together" OFF)

# These are compiled by themselves all the same, and so is what is generated; what is compiled for an instruction set; and
# src/algebra, where each source makes something else of Eigen: joined they cost as much time, and 1.9 GB of memory.
set(POLHODE_ALONE
  systems/scheme_table.cpp                 # every scheme for every kind of system: as dear as the rest of its folder
  experiments/lyapunov/orbit_geometry.cpp  # Eigen's decompositions: a third of its folder, and 1.4 GB with the rest
  foreign/child.cpp                        # tests put another in its place
  cli/missing_memory.cpp)                  # defines what the linker wraps around malloc

# polhode_join_folders(target [MOST number]): of a folder at most so many are one.
function(polhode_join_folders target)
  cmake_parse_arguments(PARSE_ARGV 1 given "" "MOST" "")
  if(NOT POLHODE_UNITY)
    return()
  endif()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
  # Without collecting what it no longer needs g++ takes a tenth less time, and 1.2 GB at most.
  target_compile_options(${target} PRIVATE
    "$<$<CXX_COMPILER_ID:GNU>:--param=ggc-min-expand=1000;--param=ggc-min-heapsize=4000000>")
  get_target_property(sources ${target} SOURCES)
  list(FILTER sources INCLUDE REGEX "\\.cpp$")
  foreach(source IN LISTS sources)
    cmake_path(ABSOLUTE_PATH source BASE_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR})
    cmake_path(RELATIVE_PATH source BASE_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR} OUTPUT_VARIABLE name)
    if(NOT name MATCHES "^(\\.\\.|algebra)/" AND NOT name IN_LIST POLHODE_ALONE)
      cmake_path(GET name PARENT_PATH folder)
      string(REPLACE "/" "_" folder "${folder}")
      if(given_MOST)
        math(EXPR ${folder}_joined "0${${folder}_joined} + 1")
        math(EXPR part "(${${folder}_joined} - 1) / ${given_MOST} + 1")
        string(APPEND folder _${part})
      endif()
      set_source_files_properties(${source} PROPERTIES UNITY_GROUP "${folder}")
    endif()
  endforeach()
endfunction()
