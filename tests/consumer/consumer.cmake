# Plays the outside user; see CMakeLists.txt for the arguments. WORK is made anew.
cmake_minimum_required(VERSION 3.25)

function(run)
  execute_process(COMMAND ${ARGV} RESULT_VARIABLE code OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT code EQUAL 0)
    list(JOIN ARGV " " line)
    message(FATAL_ERROR "exit ${code}: ${line}\n${output}")
  endif()
endfunction()

set(tools -G ${GENERATOR} -D CMAKE_BUILD_TYPE=Release -D CMAKE_CXX_COMPILER=${CXX})
set(prefix ${WORK}/prefix)
file(REMOVE_RECURSE ${WORK})

if(FROM STREQUAL "headers_only")
  set(BUILD ${WORK}/polhode)
  run(${CMAKE_COMMAND} -S ${SOURCE} -B ${BUILD} ${tools} -D POLHODE_LABORATORY=OFF)
  run(${CMAKE_COMMAND} --build ${BUILD})
endif()
run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${prefix})

run(${CMAKE_COMMAND} -S ${CMAKE_CURRENT_LIST_DIR}/project -B ${WORK}/project ${tools}
  -D CMAKE_PREFIX_PATH=${prefix} -D CMAKE_FIND_USE_PACKAGE_REGISTRY=OFF)
file(STRINGS ${WORK}/project/CMakeCache.txt found REGEX "^polhode_DIR:")
if(NOT found MATCHES "=${prefix}/")
  message(FATAL_ERROR "found another polhode than the one just installed: ${found}")
endif()
run(${CMAKE_COMMAND} --build ${WORK}/project)
run(${WORK}/project/consumer)
