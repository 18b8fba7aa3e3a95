include(CMakePackageConfigHelpers)
include(GNUInstallDirs)

configure_package_config_file(
  ${PROJECT_SOURCE_DIR}/cmake/scree-config.cmake.in ${PROJECT_BINARY_DIR}/scree-config.cmake
  INSTALL_DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/scree)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/scree-config-version.cmake
                                 COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/scree-config.cmake ${PROJECT_BINARY_DIR}/scree-config-version.cmake
        DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/scree COMPONENT base)
