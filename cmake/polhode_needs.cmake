# SPDX-License-Identifier: Apache-2.0
# polhode_needs(libgsl-dev GSL 2.7): find_package(GSL 2.7), and where there is none the name to install.
macro(polhode_needs debian library)
  find_package(${library} ${ARGN} QUIET)
  if(NOT ${library}_FOUND)
    string(REPLACE ";" " " _wanted "${library};${ARGN}")
    set(_seen "")
    if(${library}_CONSIDERED_VERSIONS)
      set(_seen ", and found is ${${library}_CONSIDERED_VERSIONS}")
    endif()
    message(FATAL_ERROR "polhode needs ${_wanted}${_seen}: on Debian 12 and its kin `apt install ${debian}`; "
      "`ci/setup` installs all that a build needs")
  endif()
endmacro()

# The headers ask for C++20 and for packs of the standard library.
function(polhode_needs_compiler)
  if(NOT cxx_std_20 IN_LIST CMAKE_CXX_COMPILE_FEATURES)
    message(FATAL_ERROR "polhode needs a compiler of C++20, and ${CMAKE_CXX_COMPILER_ID} ${CMAKE_CXX_COMPILER_VERSION} "
      "(${CMAKE_CXX_COMPILER}) is none: g++ from 12 on, or clang from 19 on")
  endif()
  include(CheckIncludeFileCXX)
  set(CMAKE_REQUIRED_QUIET ON)
  set(CMAKE_REQUIRED_FLAGS ${CMAKE_CXX20_STANDARD_COMPILE_OPTION})
  check_include_file_cxx(experimental/simd POLHODE_HAS_SIMD)
  if(NOT POLHODE_HAS_SIMD)
    message(FATAL_ERROR "polhode needs <experimental/simd>, which libstdc++ has from 11 on (libc++ has none): "
      "with clang leave out -stdlib=libc++")
  endif()
endfunction()
