# SPDX-FileCopyrightText: 2026 The primitect developers
# SPDX-License-Identifier: BSD-3-Clause
# Without ROS: the library with its headers, for find_package(primitect) and the target primitect::primitect.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/${PROJECT_NAME})

target_compile_features(primitect INTERFACE cxx_std_17)
target_include_directories(primitect INTERFACE $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
install(TARGETS primitect EXPORT primitect-targets LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT library)
install(DIRECTORY include/${PROJECT_NAME}/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/${PROJECT_NAME} COMPONENT library)
install(EXPORT primitect-targets NAMESPACE primitect:: DESTINATION ${package_folder} FILE primitect-config.cmake
  COMPONENT library)
write_basic_package_version_file(${CMAKE_BINARY_DIR}/primitect-config-version.cmake VERSION ${package_version}
  COMPATIBILITY SameMajorVersion)
install(FILES ${CMAKE_BINARY_DIR}/primitect-config-version.cmake DESTINATION ${package_folder} COMPONENT library)
