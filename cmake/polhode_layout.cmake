# SPDX-License-Identifier: Apache-2.0
# The layout of a build folder. Raised where one that was configured before cannot be used on: with 2, what a folder of 1
# holds of the Python package is links without the module.
set(POLHODE_BUILD_LAYOUT 2)
if(NOT CMAKE_SOURCE_DIR STREQUAL CMAKE_CURRENT_SOURCE_DIR)
  return()  # the folder is another project's
endif()
if(DEFINED CACHE{polhode_BINARY_DIR} AND NOT "$CACHE{POLHODE_CONFIGURED_LAYOUT}" STREQUAL POLHODE_BUILD_LAYOUT)
  message(FATAL_ERROR "${CMAKE_BINARY_DIR} was configured by another layout of the build: remove it (cmake -E rm -r "
    "${CMAKE_BINARY_DIR}) and configure again; ci/build and ci/report do that by themselves")
endif()
set(POLHODE_CONFIGURED_LAYOUT ${POLHODE_BUILD_LAYOUT} CACHE INTERNAL "Layout of the build that configured this folder")
