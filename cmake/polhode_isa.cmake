# SPDX-License-Identifier: Apache-2.0
# Sources that are compiled once per instruction set. Every inline function in them, ours or the standard library's, would be
# merged by the linker with its namesake of another instruction set, and AVX-512 would run where there is none. So the objects
# of one set are linked into one relocatable object, and of its symbols only the entries polhode_* stay visible.
set(POLHODE_ISA_LEVELS ON CACHE STRING
  "Compile the inner loops for x86-64-v2, v3 and v4 and choose at start (ON), for this machine's level alone (NATIVE), or for the compiler's target (OFF)")
set_property(CACHE POLHODE_ISA_LEVELS PROPERTY STRINGS ON NATIVE OFF)

set(POLHODE_ISA_SOURCES
  transfer/isa/basis_sums.cpp algebra/isa/dense_algebra.cpp ensemble/observing/isa/direction_bins.cpp transfer/isa/frame_sums.cpp
  ensemble/noise/isa/normal_block.cpp ensemble/isa/tangent_controls.cpp ensemble/isa/yardstick.cpp ensemble/isa/chen.cpp
  ensemble/tapes/isa/tape_player.cpp systems/rigid_body/isa/rigid_body.cpp
  systems/rigid_body/isa/bound_face.cpp systems/rigid_body/isa/own_kernels.cpp)
file(GLOB POLHODE_SYSTEM_SOURCES CONFIGURE_DEPENDS RELATIVE ${CMAKE_CURRENT_LIST_DIR}/../src ${CMAKE_CURRENT_LIST_DIR}/../src/systems/*.cpp)
list(REMOVE_ITEM POLHODE_SYSTEM_SOURCES systems/systems.cpp systems/scheme_table.cpp systems/faced_system.cpp)
list(APPEND POLHODE_ISA_SOURCES ${POLHODE_SYSTEM_SOURCES})
set(POLHODE_AES_SOURCES ensemble/noise/isa/normal_block_ars.cpp)  # with AES besides, which no level implies
set(POLHODE_UNCONTRACTED  # the same bits on every instruction set
  ensemble/observing/isa/direction_bins.cpp ensemble/noise/isa/normal_block.cpp ${POLHODE_AES_SOURCES})

function(polhode_isa_objects target level objects sources)
  add_library(${objects} OBJECT ${sources})
  target_link_libraries(${objects} PRIVATE polhode_options polhode::integrators)
  target_compile_definitions(${objects} PRIVATE POLHODE_ISA=${level} POLHODE_X86_LEVELS)
  target_compile_options(${objects} PRIVATE -march=x86-64-${level}
    $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>
    $<$<CXX_COMPILER_ID:GNU>:-Wno-uninitialized>
    $<$<CXX_COMPILER_ID:GNU>:-fno-gnu-unique>)  # g++ 12's own AVX-512 headers (GCC bug 105593)
  if(level STREQUAL v4)
    target_compile_options(${objects} PRIVATE -mprefer-vector-width=512)
  endif()
  # Vectors and matrices of packs are copied and zeroed a pack at a time: `rep movs`, and words that a load of a whole
  # pack then waits for, cost a fifth of the steps of six components and more.
  set(pack_bits_v2 128)
  set(pack_bits_v3 256)
  set(pack_bits_v4 512)
  if(CMAKE_CXX_COMPILER_ID STREQUAL GNU)
    set(by_packs vector_loop:8192:noalign,libcall:-1:noalign)
    target_compile_options(${objects} PRIVATE -mmove-max=${pack_bits_${level}} -mstore-max=${pack_bits_${level}}
      -mmemcpy-strategy=${by_packs} -mmemset-strategy=${by_packs} -fno-tree-loop-distribute-patterns)
    # A vector of packs is taken apart into registers however large it is. Else its copies stay on the stack, dead ones
    # too, and a step of six components waits for its stores: with one pack Heun and Lie-Heun take a sixth to a half longer.
    target_compile_options(${objects} PRIVATE "SHELL:--param sra-max-scalarization-size-Ospeed=8192")
    # The compiler collects its own garbage later: a tenth of its time, for a tenth of memory more.
    target_compile_options(${objects} PRIVATE --param=ggc-min-expand=1000 --param=ggc-min-heapsize=4000000)
  endif()
  if(level STREQUAL v2)  # processors of before 2013 are owed the same results, not speed: two thirds of the compiler's time
    target_compile_options(${objects} PRIVATE $<$<CONFIG:Release>:-O1>)
  endif()
  set(merged ${CMAKE_CURRENT_BINARY_DIR}/${objects}.o)
  set(compiled "$<FILTER:$<TARGET_OBJECTS:${objects}>,EXCLUDE,[.][gp]ch$>")  # CMake counts precompiled headers among them
  add_custom_command(OUTPUT ${merged}
    COMMAND ${POLHODE_LD} -r --force-group-allocation -o ${merged}.all ${compiled}
    COMMAND ${CMAKE_OBJCOPY} --wildcard --keep-global-symbol=polhode_*_${level} ${merged}.all ${merged}
    DEPENDS ${objects} ${compiled} COMMAND_EXPAND_LISTS VERBATIM
    COMMENT "Inner loops for x86-64-${level}")
  set_source_files_properties(${merged} PROPERTIES EXTERNAL_OBJECT ON GENERATED ON)
  target_sources(${target} PRIVATE ${merged})
endfunction()

function(polhode_native_level out)
  try_run(level_of_processor compiled ${CMAKE_CURRENT_BINARY_DIR}/native_level ${PROJECT_SOURCE_DIR}/cmake/native_level.cpp)
  if(NOT compiled OR NOT level_of_processor MATCHES "^[234]$")
    message(FATAL_ERROR "POLHODE_ISA_LEVELS=NATIVE: this processor has no x86-64-v2; accepted: ON, OFF")
  endif()
  message(STATUS "Inner loops for x86-64-v${level_of_processor} alone")
  set(${out} v${level_of_processor} PARENT_SCOPE)
endfunction()

find_program(POLHODE_LD ld.bfd)  # others do not dissolve groups

function(polhode_add_isa target)
  # Without tree-ter g++ keeps the order in which several packs advance together, instead of one chain after another.
  set_source_files_properties(${POLHODE_UNCONTRACTED} PROPERTIES SKIP_PRECOMPILE_HEADERS ON
    COMPILE_OPTIONS "-ffp-contract=off;$<$<CXX_COMPILER_ID:GNU>:-fno-tree-ter>")
  if(POLHODE_ISA_LEVELS AND CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64" AND CMAKE_OBJCOPY AND POLHODE_LD)
    target_compile_definitions(${target} PRIVATE POLHODE_X86_LEVELS)
    set(levels v2 v3 v4)
    if(POLHODE_ISA_LEVELS STREQUAL NATIVE)
      polhode_native_level(levels)
      target_compile_definitions(${target} PRIVATE POLHODE_X86_LEVEL=${levels})
    endif()
    foreach(level ${levels})
      polhode_isa_objects(${target} ${level} ${target}_${level} "${POLHODE_ISA_SOURCES}")
      polhode_read_common_headers(${target}_${level} <Eigen/Core> <polhode/simd.hpp>)
    endforeach()
    foreach(level v2 v3 v4)  # the widest with AES may be narrower than the widest without
      polhode_isa_objects(${target} ${level} ${target}_aes_${level} "${POLHODE_AES_SOURCES}")
      target_compile_options(${target}_aes_${level} PRIVATE -maes $<$<STREQUAL:${level},v4>:-mvaes>)
    endforeach()
  else()
    if(POLHODE_ISA_LEVELS)
      message(STATUS "Inner loops for the compiler's own target alone: other levels need x86-64, ld.bfd and objcopy")
    endif()
    set(all ${POLHODE_ISA_SOURCES} ${POLHODE_AES_SOURCES})
    target_sources(${target} PRIVATE ${all})
    set_source_files_properties(${all} PROPERTIES COMPILE_DEFINITIONS POLHODE_ISA=portable)
    set_property(SOURCE ${all} APPEND PROPERTY COMPILE_OPTIONS ${POLHODE_PACKS_AS_NUMBERS})
  endif()
endfunction()
