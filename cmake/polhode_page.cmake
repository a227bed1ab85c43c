# SPDX-License-Identifier: Apache-2.0
# The template of the report page: reports/viewer/dist/report.html becomes strings of the writers.
# Included, it defines polhode_embed_page(target); run as a script (-DPAGE=... -DOUT=...), it writes the source.
if(NOT CMAKE_SCRIPT_MODE_FILE)
  set(POLHODE_PAGE_SCRIPT ${CMAKE_CURRENT_LIST_FILE})
  function(polhode_embed_page target)
    set(page ${PROJECT_SOURCE_DIR}/reports/viewer/dist/report.html)
    set(generated ${CMAKE_CURRENT_BINARY_DIR}/generated/page_template.cpp)
    add_custom_command(OUTPUT ${generated}
      COMMAND ${CMAKE_COMMAND} -DPAGE=${page} -DOUT=${generated} -P ${POLHODE_PAGE_SCRIPT}
      DEPENDS ${page} ${POLHODE_PAGE_SCRIPT}
      COMMENT "Embedding the report page" VERBATIM)
    target_sources(${target} PRIVATE ${generated})
  endfunction()
  return()
endif()
cmake_minimum_required(VERSION 3.25)

file(READ "${PAGE}" text)
if(text MATCHES "\\)page\"")
  message(FATAL_ERROR "${PAGE}: holds the end of a raw string")
endif()
# Compilers need not accept longer literals than 65536.
set(literals "")
string(LENGTH "${text}" size)
foreach(at RANGE 0 ${size} 60000)
  string(SUBSTRING "${text}" ${at} 60000 piece)
  string(APPEND literals "    R\"page(${piece})page\"sv,\n")
endforeach()
file(WRITE "${OUT}" "// Generated from reports/viewer/dist/report.html. Do not edit.
#include \"reports/writers/page_template.hpp\"

namespace polhode::report {
namespace {
using namespace std::string_view_literals;  // lengths need not be counted, which compilers limit

constexpr std::string_view pieces[] = {
${literals}};
}  // namespace

std::span<const std::string_view> page_template() { return pieces; }

}  // namespace polhode::report
")
