# SPDX-FileCopyrightText: 2026 The primitect developers
# SPDX-License-Identifier: BSD-3-Clause
# What `make install` puts where, by catkin's conventions.

foreach(library primitect primitect_png primitect_io primitect_synthetic primitect_tools primitect_ros primitect_bags)
  install(TARGETS ${library}
    ARCHIVE DESTINATION ${CATKIN_PACKAGE_LIB_DESTINATION}
    LIBRARY DESTINATION ${CATKIN_PACKAGE_LIB_DESTINATION}
    RUNTIME DESTINATION ${CATKIN_GLOBAL_BIN_DESTINATION})
endforeach()
foreach(program detector synthetic_camera detect detect_bag)
  if(TARGET ${program})
    install(TARGETS ${program} RUNTIME DESTINATION ${CATKIN_PACKAGE_BIN_DESTINATION})
  endif()
endforeach()

install(DIRECTORY include/${PROJECT_NAME}/ DESTINATION ${CATKIN_PACKAGE_INCLUDE_DESTINATION})
install(DIRECTORY launch config DESTINATION ${CATKIN_PACKAGE_SHARE_DESTINATION})
install(FILES nodelet_plugins.xml DESTINATION ${CATKIN_PACKAGE_SHARE_DESTINATION})
install(PROGRAMS scripts/check_bag DESTINATION ${CATKIN_PACKAGE_SHARE_DESTINATION}/scripts)  # launch files run it
catkin_install_python(PROGRAMS scripts/live_table scripts/rviz_in_frame DESTINATION ${CATKIN_PACKAGE_BIN_DESTINATION})
