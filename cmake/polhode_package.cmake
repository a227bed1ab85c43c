# SPDX-License-Identifier: Apache-2.0
# Debian packages: `polhode`, the command; `libpolhode-dev`, what programs are compiled and linked with; `python3-polhode`.
# ci/package builds them. They need a page of the manual, which is made from the command's help.
option(POLHODE_PACKAGE "Prepare Debian packages for cpack" OFF)
if(NOT POLHODE_PACKAGE)
  return()
endif()
include(GNUInstallDirs)
find_program(POLHODE_HELP2MAN help2man)
find_program(POLHODE_GZIP gzip)
foreach(tool HELP2MAN GZIP)
  if(NOT POLHODE_${tool})
    string(TOLOWER ${tool} name)
    message(FATAL_ERROR "POLHODE_PACKAGE=ON needs the Debian package ${name}")
  endif()
endforeach()

set(made ${PROJECT_BINARY_DIR}/package)
set(own ${PROJECT_SOURCE_DIR}/cmake/package)
# The date of what is packaged, so that two builds of one commit are the same bytes.
set(epoch $ENV{SOURCE_DATE_EPOCH})
if(NOT epoch)
  message(FATAL_ERROR "POLHODE_PACKAGE=ON needs SOURCE_DATE_EPOCH, as of git log -1 --format=%ct")
endif()
string(TIMESTAMP POLHODE_DATE "%a, %d %b %Y %H:%M:%S +0000" UTC)
set(CPACK_PACKAGE_CONTACT "The polhode maintainers <maintainers@polhode.example>")
configure_file(${own}/changelog.in ${made}/changelog @ONLY)
execute_process(COMMAND ${POLHODE_GZIP} -9nf ${made}/changelog COMMAND_ERROR_IS_FATAL ANY)
foreach(page README CHANGELOG THIRD_PARTY_NOTICES)
  configure_file(${PROJECT_SOURCE_DIR}/${page}.md ${made}/${page}.md COPYONLY)
  execute_process(COMMAND ${POLHODE_GZIP} -9nkf ${made}/${page}.md COMMAND_ERROR_IS_FATAL ANY)
endforeach()
add_custom_command(OUTPUT ${made}/polhode.1.gz
  COMMAND ${POLHODE_HELP2MAN} --no-info --name "verify stochastic geometric integrators" --output ${made}/polhode.1 $<TARGET_FILE:polhode>
  COMMAND ${POLHODE_GZIP} -9nf ${made}/polhode.1
  DEPENDS polhode VERBATIM)
add_custom_target(polhode_manual ALL DEPENDS ${made}/polhode.1.gz)

install(FILES ${made}/polhode.1.gz DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT command)
foreach(pair command=polhode laboratory=libpolhode-dev python=python3-polhode)
  string(REPLACE = ";" pair ${pair})
  list(GET pair 0 component)
  list(GET pair 1 package)
  install(FILES ${own}/copyright ${made}/changelog.gz ${made}/THIRD_PARTY_NOTICES.md.gz
    DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${package} COMPONENT ${component})
endforeach()
install(FILES ${made}/README.md.gz ${made}/CHANGELOG.md.gz DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/polhode COMPONENT command)

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME polhode)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_ALL command integrators laboratory python)
set(CPACK_COMPONENTS_GROUPING ONE_PER_GROUP)
set(CPACK_COMPONENT_COMMAND_GROUP command)
set(CPACK_COMPONENT_INTEGRATORS_GROUP dev)
set(CPACK_COMPONENT_LABORATORY_GROUP dev)
set(CPACK_COMPONENT_PYTHON_GROUP python)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_HOMEPAGE ${PROJECT_HOMEPAGE_URL})
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_COMMAND_PACKAGE_NAME polhode)
set(CPACK_DEBIAN_COMMAND_PACKAGE_SECTION math)
set(CPACK_DEBIAN_COMMAND_PACKAGE_SHLIBDEPS ON)
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "")  # each has its own: the first line of its description
set(CPACK_COMPONENT_COMMAND_DESCRIPTION "verifies stochastic geometric integrators
Decides with intervals whether an integrator of stochastic Lie-Poisson
systems keeps its promises: coadjoint orbits, strong and weak order, the
energy law and the stationary law. Takes schemes of its own, libraries,
programs and recorded data, and writes a report.")
set(CPACK_DEBIAN_DEV_PACKAGE_NAME libpolhode-dev)
set(CPACK_DEBIAN_DEV_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEV_PACKAGE_DEPENDS "libeigen3-dev, libboost-dev, libgsl-dev, libfmt-dev, libtomlplusplus-dev, \
nlohmann-json3-dev, libpugixml-dev, libpng-dev, zlib1g-dev, libcli11-dev")
set(CPACK_DEBIAN_DEV_PACKAGE_SUGGESTS polhode)
set(CPACK_COMPONENT_DEV_DESCRIPTION "stochastic geometric integrators, and what polhode is made of
Header-only integrators for dissipative stochastic Lie-Poisson systems, a
test kit with a declared budget of false alarms, the C interface for
integrators to be verified, and the library that the command polhode is
made of.")
set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-polhode)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS "python3, python3-numpy")
set(CPACK_COMPONENT_PYTHON_DESCRIPTION "verification of stochastic geometric integrators, from Python
Holds numpy callables against scenes with the verdicts of the command
polhode, gives exact references and recorded paths as arrays, and has a
test kit with a declared budget of false alarms.")
include(CPack)
