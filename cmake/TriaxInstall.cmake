# SPDX-License-Identifier: GPL-3.0-or-later
# The libraries as others find them: find_package(triax) gives triax::sim, triax::lab, triax::db and triax::study.
# Headers keep their names ("lab/rig/session.hpp") below include/triax. Component "development"; the program and what
# belongs to it are component "program", which is what the Debian package holds.
include(CMakePackageConfigHelpers)

set(triax_config ${CMAKE_INSTALL_LIBDIR}/cmake/triax)
foreach(library sim lab db study)
  set_target_properties(triax_${library} PROPERTIES EXPORT_NAME ${library})
  target_include_directories(triax_${library} PUBLIC $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/triax>)
  target_compile_features(triax_${library} PUBLIC cxx_std_20)
  install(TARGETS triax_${library} EXPORT triaxTargets COMPONENT development)
endforeach()
install(EXPORT triaxTargets NAMESPACE triax:: DESTINATION ${triax_config} COMPONENT development)

foreach(folder sim lab db)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/${folder} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/triax
    COMPONENT development FILES_MATCHING PATTERN "*.hpp"
    PATTERN "dialects" EXCLUDE PATTERN "dictionary" EXCLUDE PATTERN "instruments" EXCLUDE PATTERN "migrations" EXCLUDE)
endforeach()
install(DIRECTORY ${PROJECT_SOURCE_DIR}/src/study DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/triax/src
  COMPONENT development FILES_MATCHING PATTERN "*.hpp")

configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/triaxConfig.cmake.in
  ${CMAKE_BINARY_DIR}/triaxConfig.cmake INSTALL_DESTINATION ${triax_config})
# Before 1.0 a second number may rename headers.
write_basic_package_version_file(${CMAKE_BINARY_DIR}/triaxConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_BINARY_DIR}/triaxConfig.cmake ${CMAKE_BINARY_DIR}/triaxConfigVersion.cmake
  ${PROJECT_SOURCE_DIR}/sim/materials/umat_host.exports DESTINATION ${triax_config} COMPONENT development)

# What the README's and the demo's commands read, and what the licences ask for.
# Those of Python come with the module (src/python).
install(DIRECTORY ${PROJECT_SOURCE_DIR}/samples DESTINATION ${CMAKE_INSTALL_DATADIR}/triax USE_SOURCE_PERMISSIONS
  PATTERN samples/python EXCLUDE)
install(FILES ${PROJECT_SOURCE_DIR}/CITATION.cff ${PROJECT_SOURCE_DIR}/LICENSE ${triax_documents}/copyright
  ${triax_documents}/changelog.gz ${triax_documents}/changelog.Debian.gz DESTINATION ${CMAKE_INSTALL_DOCDIR})
