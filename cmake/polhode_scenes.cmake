# SPDX-License-Identifier: Apache-2.0
# The built-in scenes: every reports/scenes/*.toml becomes a string of the laboratory.
# Included, it defines polhode_embed_scenes(target); run as a script (-DSCENES=... -DOUT=...), it writes the source.
if(NOT CMAKE_SCRIPT_MODE_FILE)
  set(POLHODE_SCENES_SCRIPT ${CMAKE_CURRENT_LIST_FILE})
  function(polhode_embed_scenes target)
    file(GLOB scenes CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/reports/scenes/*.toml)
    # The default scene comes first, the others by name.
    list(REMOVE_ITEM scenes ${PROJECT_SOURCE_DIR}/reports/scenes/paper.toml)
    list(PREPEND scenes ${PROJECT_SOURCE_DIR}/reports/scenes/paper.toml)
    set(generated ${CMAKE_CURRENT_BINARY_DIR}/generated/builtin_scenes.cpp)
    add_custom_command(OUTPUT ${generated}
      COMMAND ${CMAKE_COMMAND} "-DSCENES=${scenes}" -DOUT=${generated} -P ${POLHODE_SCENES_SCRIPT}
      DEPENDS ${scenes} ${POLHODE_SCENES_SCRIPT}
      COMMENT "Embedding the built-in scenes" VERBATIM)
    target_sources(${target} PRIVATE ${generated})
  endfunction()
  return()
endif()
cmake_minimum_required(VERSION 3.25)

set(table "")
foreach(file IN LISTS SCENES)
  get_filename_component(name "${file}" NAME_WE)
  file(READ "${file}" text)
  if(NOT text MATCHES "^# ([^\n\"\\]+)\n")
    message(FATAL_ERROR "${file}: the first line must be a comment: the scene's title")
  endif()
  string(APPEND table "    {\"${name}\", \"${CMAKE_MATCH_1}\", R\"toml(${text})toml\"},\n")
endforeach()
file(WRITE "${OUT}" "// Generated from reports/scenes. Do not edit.
#include \"scene/builtin.hpp\"

namespace polhode {
namespace {
constexpr builtin_scene table[] = {
${table}};
}  // namespace

std::span<const builtin_scene> builtin_scene_table() { return table; }

}  // namespace polhode
")
