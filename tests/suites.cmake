# SPDX-License-Identifier: Apache-2.0
# The suites of a binary of GoogleTest as tests of ctest: a process costs what many quick tests do together. A suite that fails
# names its tests. Included, it defines polhode_discover_suites(target [PREFIX text] [LABELS text] [TIMEOUT seconds]); run as
# a script after the target is linked, it writes the list of tests.
if(NOT CMAKE_SCRIPT_MODE_FILE)
  set(POLHODE_SUITES_SCRIPT ${CMAKE_CURRENT_LIST_FILE})
  function(polhode_discover_suites target)
    cmake_parse_arguments(PARSE_ARGV 1 given "" "PREFIX;LABELS;TIMEOUT" "")
    set(list ${CMAKE_CURRENT_BINARY_DIR}/${target}_suites.cmake)
    add_custom_command(TARGET ${target} POST_BUILD
      COMMAND ${CMAKE_COMMAND} -DPROGRAM=$<TARGET_FILE:${target}> -DOUT=${list} "-DPREFIX=${given_PREFIX}"
        "-DLABELS=${given_LABELS}" -DTIMEOUT=${given_TIMEOUT} -P ${POLHODE_SUITES_SCRIPT}
      BYPRODUCTS ${list} VERBATIM)
    set(included ${CMAKE_CURRENT_BINARY_DIR}/${target}_include.cmake)
    file(WRITE ${included} "if(EXISTS \"${list}\")\n  include(\"${list}\")\nelse()\n  add_test(${target} ${target}_NOT_BUILT)\nendif()\n")
    set_property(DIRECTORY APPEND PROPERTY TEST_INCLUDE_FILES ${included})
  endfunction()
  return()
endif()
cmake_minimum_required(VERSION 3.25)

execute_process(COMMAND ${PROGRAM} --gtest_list_tests OUTPUT_VARIABLE listed COMMAND_ERROR_IS_FATAL ANY)
string(REGEX MATCHALL "(^|\n)[^ \n]+[.]( +# TypeParam = [^\n]+)?" suites "${listed}")
set(tests "")
foreach(suite IN LISTS suites)
  string(REGEX MATCH "([^\n]+)[.]( +# TypeParam = (.+))?$" matched "${suite}")
  set(name ${CMAKE_MATCH_1})
  set(filter ${name}.*)
  if(CMAKE_MATCH_3)
    string(REGEX REPLACE "/[0-9]+$" "<${CMAKE_MATCH_3}>" name ${name})
  endif()
  string(APPEND tests "add_test([==[${PREFIX}${name}]==] [==[${PROGRAM}]==] \"--gtest_filter=${filter}\")\n"
    "set_tests_properties([==[${PREFIX}${name}]==] PROPERTIES LABELS \"${LABELS}\" TIMEOUT ${TIMEOUT} SKIP_REGULAR_EXPRESSION [==[\\[  SKIPPED \\][^\n]*\n*$]==])\n")
endforeach()
file(WRITE ${OUT} "${tests}")
