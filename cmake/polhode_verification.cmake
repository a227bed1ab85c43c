# SPDX-License-Identifier: Apache-2.0
# Verifications of one's own integrator as tests of one's own project; installed with the package.
#
#   polhode_add_verification(NAME mine SCENE scene.toml WITH $<TARGET_FILE:mine> SCHEMES my_heun)
#   polhode_add_verification(NAME script SCENE paper COMMAND "python3 mine.py" SCHEMES my_heun EXPERIMENTS casimir strong)
#
# registers the test verification.<NAME>, which runs `polhode verify`. Arguments:
#   NAME         letters, digits, and . _ -
#   SCENE        TOML files, relative to the current source folder, or built-in names; one or more
#   WITH         libraries (docs/verify-your-integrator.md), generator expressions included
#   COMMAND      programs that are integrators, each with its arguments in one text; run in the current source folder
#   SCHEMES      only these, as the integrators call themselves, ours beside them if named; default: all
#   EXPERIMENTS  only these; default: all
#   EFFORT       quick, standard, thorough; default: quick
#   THREADS      default: 1; ctest keeps as many processors free. Results do not depend on it
#   TIMEOUT      seconds; default: 1800
#   OUT          folder; default: ${CMAKE_CURRENT_BINARY_DIR}/verification/<NAME>
#   ARGUMENTS    further arguments of `polhode verify`
#   PROGRAM      the program; default: the target `polhode`, else POLHODE_PROGRAM (OFF: none), else what find_program finds
#   REQUIRED     no program is an error; else the test is registered, disabled, and ctest says so
#
# The test passes where every claim holds (exit code 0). It fails where one is refuted (1), where bad input is given (2),
# where nothing is refuted and something is inconclusive (3), and where the program cannot run (4). Labels: polhode,
# verification. OUT holds a folder for each scene, under its name, with report.html, report.md and junit.xml; OUT is
# written anew by each run. Nothing is taken from a cache: the integrator may have changed.

function(polhode_add_verification)
  cmake_parse_arguments(PARSE_ARGV 0 given "REQUIRED" "NAME;EFFORT;THREADS;TIMEOUT;OUT;PROGRAM"
    "SCENE;WITH;COMMAND;SCHEMES;EXPERIMENTS;ARGUMENTS")
  _polhode_check_verification()
  _polhode_verification_program(program)
  if(NOT given_OUT)
    set(given_OUT ${CMAKE_CURRENT_BINARY_DIR}/verification/${given_NAME})
  endif()
  foreach(default IN ITEMS EFFORT=quick THREADS=1 TIMEOUT=1800)
    string(REPLACE "=" ";" default ${default})
    list(GET default 0 key)
    if(NOT given_${key})
      list(GET default 1 given_${key})
    endif()
  endforeach()

  set(arguments)
  foreach(scene IN LISTS given_SCENE)
    cmake_path(ABSOLUTE_PATH scene BASE_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR} OUTPUT_VARIABLE file)
    if(EXISTS ${file} AND NOT IS_DIRECTORY ${file})
      set(scene ${file})
    endif()
    list(APPEND arguments ${scene})
  endforeach()
  foreach(integrator IN LISTS given_WITH given_COMMAND)
    list(APPEND arguments --with ${integrator})
  endforeach()
  foreach(choice IN ITEMS SCHEMES EXPERIMENTS)
    if(given_${choice})
      string(TOLOWER ${choice} option)
      string(REPLACE ";" "," chosen "${given_${choice}}")
      list(APPEND arguments --${option} ${chosen})
    endif()
  endforeach()

  set(test verification.${given_NAME})
  add_test(NAME ${test} WORKING_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR}
    COMMAND ${program} verify ${arguments} --effort ${given_EFFORT} --threads ${given_THREADS} --out ${given_OUT} --no-cache
            ${given_ARGUMENTS})
  set_tests_properties(${test} PROPERTIES LABELS "polhode;verification" TIMEOUT ${given_TIMEOUT} PROCESSORS ${given_THREADS})
  if(NOT program)
    set_tests_properties(${test} PROPERTIES DISABLED TRUE)
    message(STATUS "${test}: disabled, as the program polhode is not found; set POLHODE_PROGRAM or pass PROGRAM")
  endif()
endfunction()

# What cannot be meant stops the configuration with one line.
macro(_polhode_check_verification)
  if(given_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "polhode_add_verification: unknown argument '${given_UNPARSED_ARGUMENTS}'")
  elseif(NOT "${given_NAME}" MATCHES "^[A-Za-z0-9._-]+$")
    message(FATAL_ERROR "polhode_add_verification: NAME '${given_NAME}': accepted: letters, digits, and . _ -")
  elseif(NOT given_SCENE)
    message(FATAL_ERROR "polhode_add_verification: ${given_NAME}: SCENE: accepted: TOML files or built-in names")
  elseif(NOT given_WITH AND NOT given_COMMAND)
    message(FATAL_ERROR "polhode_add_verification: ${given_NAME}: neither WITH nor COMMAND: no integrator is given")
  elseif(given_EFFORT AND NOT "${given_EFFORT}" MATCHES "^(quick|standard|thorough)$")
    message(FATAL_ERROR "polhode_add_verification: ${given_NAME}: EFFORT '${given_EFFORT}': accepted: quick, standard, thorough")
  endif()
  foreach(scene IN LISTS given_SCENE)
    if(scene MATCHES "[.]toml$" AND NOT EXISTS ${scene} AND NOT EXISTS ${CMAKE_CURRENT_SOURCE_DIR}/${scene})
      message(FATAL_ERROR "polhode_add_verification: ${given_NAME}: SCENE '${scene}': no such file")
    endif()
  endforeach()
endmacro()

function(_polhode_verification_program result)
  if(given_PROGRAM)
    set(program ${given_PROGRAM})
  elseif(TARGET polhode)
    set(program $<TARGET_FILE:polhode>)
  else()
    find_program(POLHODE_PROGRAM polhode DOC "The program of polhode, which runs verifications")
    set(program ${POLHODE_PROGRAM})
  endif()
  if(given_REQUIRED AND NOT program)
    message(FATAL_ERROR "polhode_add_verification: ${given_NAME}: the program polhode is not found; set POLHODE_PROGRAM or pass PROGRAM")
  endif()
  set(${result} ${program} PARENT_SCOPE)
endfunction()
