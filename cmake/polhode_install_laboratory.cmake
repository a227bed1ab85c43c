# SPDX-License-Identifier: Apache-2.0
# The command, and the package's component `laboratory`: what a program with schemes or systems of its own is linked with.
set(laboratory_headers ${CMAKE_INSTALL_INCLUDEDIR}/polhode/laboratory)
foreach(library polhode_laboratory polhode_reports)
  target_compile_features(${library} INTERFACE cxx_std_20)
  target_include_directories(${library} INTERFACE $<INSTALL_INTERFACE:${laboratory_headers}>)
endforeach()
set_target_properties(polhode_laboratory PROPERTIES EXPORT_NAME laboratory)
set_target_properties(polhode_reports PROPERTIES EXPORT_NAME reports)

install(TARGETS polhode RUNTIME COMPONENT command)
install(TARGETS polhode_laboratory polhode_reports EXPORT polhode-laboratory ARCHIVE COMPONENT laboratory)
install(EXPORT polhode-laboratory NAMESPACE polhode:: COMPONENT laboratory DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/polhode)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/src/ DESTINATION ${laboratory_headers} COMPONENT laboratory FILES_MATCHING PATTERN "*.hpp")
install(DIRECTORY ${PROJECT_SOURCE_DIR}/reports/ DESTINATION ${laboratory_headers}/reports COMPONENT laboratory
  FILES_MATCHING PATTERN "*.hpp" PATTERN viewer EXCLUDE PATTERN baseline EXCLUDE PATTERN pictures EXCLUDE)
