# Components: carom (the library, its headers and what finds them) and carom-games (the same of the
# rules), each complete with its own build target.
include(CMakePackageConfigHelpers)
set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/carom)

# install_library(TARGET EXPORT COMPONENT): target, package files and carom.pc's like.
function(install_library target name)
  install(TARGETS ${target} EXPORT ${name}Targets
    RUNTIME COMPONENT ${name}
    LIBRARY COMPONENT ${name} NAMELINK_COMPONENT ${name}
    ARCHIVE COMPONENT ${name})
  install(EXPORT ${name}Targets NAMESPACE carom:: DESTINATION ${package_folder} COMPONENT ${name})
  # Relative, so that the folder may be moved.
  file(RELATIVE_PATH prefix ${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig ${CMAKE_INSTALL_PREFIX})
  string(REGEX REPLACE "/$" "" prefix ${prefix})
  configure_file(${PROJECT_SOURCE_DIR}/cmake/${name}.pc.in ${name}.pc @ONLY)
  install(FILES ${CMAKE_CURRENT_BINARY_DIR}/${name}.pc
    DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT ${name})
endfunction()

install_library(carom carom)
install(DIRECTORY include/carom DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT carom)
configure_package_config_file(cmake/carom-config.cmake.in carom-config.cmake
  INSTALL_DESTINATION ${package_folder} NO_SET_AND_CHECK_MACRO)
write_basic_package_version_file(carom-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/carom-config.cmake
  ${CMAKE_CURRENT_BINARY_DIR}/carom-config-version.cmake
  DESTINATION ${package_folder} COMPONENT carom)

if(TARGET carom_games)
  install_library(carom_games carom-games)
  install(DIRECTORY include/games DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/carom-games
    COMPONENT carom-games)
endif()
