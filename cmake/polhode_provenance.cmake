# SPDX-License-Identifier: Apache-2.0
# polhode_build.hpp: version, commit, compiler and flags. Looked up at every build, rewritten only if something changed.
# Included, it defines polhode_add_provenance(target); run as a script, it writes the header.
if(NOT CMAKE_SCRIPT_MODE_FILE)
  set(POLHODE_PROVENANCE_SCRIPT ${CMAKE_CURRENT_LIST_FILE})
  function(polhode_add_provenance target)
    set(header ${CMAKE_CURRENT_BINARY_DIR}/generated/polhode_build.hpp)
    string(TOUPPER "${CMAKE_BUILD_TYPE}" type)
    get_target_property(shared polhode_options INTERFACE_COMPILE_OPTIONS)
    get_target_property(own ${target} COMPILE_OPTIONS)
    set(flags ${shared} ${own})
    # Warnings change no result; generator expressions are not known yet.
    list(FILTER flags EXCLUDE REGEX "^-W|\\$<|NOTFOUND$")
    list(JOIN flags " " flags)
    string(STRIP "${CMAKE_CXX_FLAGS} ${CMAKE_CXX_FLAGS_${type}} ${flags}" flags)
    add_custom_target(${target}_provenance
      COMMAND ${CMAKE_COMMAND} -DSOURCE=${PROJECT_SOURCE_DIR} -DOUT=${header} -DVERSION=${PROJECT_VERSION}
        "-DCOMPILER=${CMAKE_CXX_COMPILER_ID} ${CMAKE_CXX_COMPILER_VERSION}" "-DFLAGS=${flags}"
        -P ${POLHODE_PROVENANCE_SCRIPT}
      BYPRODUCTS ${header} VERBATIM)
    add_dependencies(${target} ${target}_provenance)
    target_include_directories(${target} PRIVATE ${CMAKE_CURRENT_BINARY_DIR}/generated)
  endfunction()
  return()
endif()
cmake_minimum_required(VERSION 3.25)

set(commit "unknown")
find_program(GIT git)
# Only the project's own repository: unpacked inside another one, its commit would be a wrong answer.
if(GIT AND EXISTS "${SOURCE}/.git")
  execute_process(COMMAND ${GIT} -C ${SOURCE} rev-parse --short=12 HEAD
    OUTPUT_VARIABLE head OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE failed)
  if(NOT failed)
    set(commit ${head})
    execute_process(COMMAND ${GIT} --no-optional-locks -C ${SOURCE} status --porcelain --untracked-files=no
      OUTPUT_VARIABLE changes ERROR_QUIET)
    if(changes)
      string(APPEND commit "+dirty")
    endif()
  endif()
endif()

set(text "// Generated at build time. Do not edit.\n#pragma once\n\nnamespace polhode::build {\n")
foreach(name IN ITEMS version commit compiler flags)
  string(TOUPPER ${name} given)
  if(NOT name STREQUAL "commit")
    set(${name} "${${given}}")
  endif()
  string(REGEX REPLACE "([\"\\])" "\\\\\\1" value "${${name}}")
  string(APPEND text "inline constexpr const char* ${name} = \"${value}\";\n")
endforeach()
string(APPEND text "}  // namespace polhode::build\n")
set(former "")
if(EXISTS "${OUT}")
  file(READ "${OUT}" former)
endif()
if(NOT text STREQUAL former)
  file(WRITE "${OUT}" "${text}")
endif()
