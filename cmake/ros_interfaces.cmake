# SPDX-FileCopyrightText: 2026 The primitect developers
# SPDX-License-Identifier: BSD-3-Clause
# Messages, live parameters and what other catkin packages see of this one.

add_message_files(FILES Primitive.msg PrimitiveArray.msg)
generate_messages(DEPENDENCIES geometry_msgs std_msgs)

generate_dynamic_reconfigure_options(cfg/Detector.cfg)
# The .cfg reads params.def: a changed default must reach the generated header too.
add_custom_command(OUTPUT ${_output_cpp} APPEND DEPENDS ${PROJECT_SOURCE_DIR}/include/primitect/params.def)

# The public headers include Eigen.
find_package(Eigen3 REQUIRED)
catkin_package(
  INCLUDE_DIRS include
  LIBRARIES primitect
  CATKIN_DEPENDS geometry_msgs message_runtime nodelet roscpp sensor_msgs std_msgs
  DEPENDS EIGEN3)
