# SPDX-FileCopyrightText: 2026 The primitect developers
# SPDX-License-Identifier: BSD-3-Clause
# primitect_test(NAME LIBRARIES...): a gtest from NAME.cpp in the current folder.
# Target `tests` builds all of them; ctest runs them. With sanitizers some are left out or made of another build, then
# there is no target test_NAME: see sanitized_tests.cmake.

if(NOT TARGET tests)
  add_custom_target(tests)
endif()
find_package(GTest REQUIRED)

# What takes long to compile and many tests need, compiled once: headers, decompositions, patterns, JSON.
add_library(primitect_test_support STATIC EXCLUDE_FROM_ALL
  ${PROJECT_SOURCE_DIR}/test/support/linear_algebra.cpp ${PROJECT_SOURCE_DIR}/test/support/text.cpp)
target_link_libraries(primitect_test_support PUBLIC GTest::gtest)
target_include_directories(primitect_test_support PRIVATE ${PROJECT_SOURCE_DIR})
target_include_directories(primitect_test_support SYSTEM PRIVATE ${EIGEN3_INCLUDE_DIRS})
target_precompile_headers(primitect_test_support PRIVATE
  <gtest/gtest.h> <Eigen/Geometry> <algorithm> <array> <cmath> <cstdint> <functional> <map> <memory> <optional> <string>
  <variant> <vector>)
# As executables are compiled: precompiled headers serve only what has the same flags.
set_target_properties(primitect_test_support PROPERTIES POSITION_INDEPENDENT_CODE OFF)
target_compile_options(primitect_test_support PRIVATE -fPIE)
# Tests are compiled more often than they run; what they test keeps its optimization.
target_compile_options(primitect_test_support PUBLIC $<$<CONFIG:Release>:-O1>)
if(PRIMITECT_SANITIZE)
  # Of tests that are compiled here address errors are still found, undefined behaviour in the code under test only.
  target_compile_options(primitect_test_support PUBLIC -fno-sanitize=undefined)
endif()

# Gold links a test in a fifth of the time.
include(CheckCXXSourceCompiles)
set(CMAKE_REQUIRED_LINK_OPTIONS -fuse-ld=gold)
check_cxx_source_compiles("int main() { return 0; }" PRIMITECT_HAS_GOLD)
unset(CMAKE_REQUIRED_LINK_OPTIONS)
if(PRIMITECT_HAS_GOLD)
  target_link_options(primitect_test_support PUBLIC -fuse-ld=gold)
endif()

include(cmake/sanitized_tests.cmake)

function(primitect_test name)
  primitect_sanitized_test(done ${name} ${ARGN})
  if(done)
    return()
  endif()
  if(PRIMITECT_ROS)
    catkin_add_gtest(test_${name} ${name}.cpp)
  else()
    add_executable(test_${name} EXCLUDE_FROM_ALL ${name}.cpp)
    target_link_libraries(test_${name} GTest::gtest)
    add_test(NAME ${name} COMMAND test_${name})
    set_tests_properties(${name} PROPERTIES ENVIRONMENT "${sanitizer_options}")
    add_dependencies(tests test_${name})
  endif()
  target_link_libraries(test_${name} primitect_test_support GTest::gtest_main ${ARGN})
  # What comes with PCL is compiled with -fPIC, which the precompiled headers do not fit.
  if("${ARGN}" MATCHES "pcl_common")
    target_include_directories(test_${name} SYSTEM PRIVATE ${PCL_INCLUDE_DIRS})
  else()
    target_precompile_headers(test_${name} REUSE_FROM primitect_test_support)
  endif()
  target_include_directories(test_${name} PRIVATE ${PROJECT_SOURCE_DIR})
  target_include_directories(test_${name} SYSTEM PRIVATE ${EIGEN3_INCLUDE_DIRS})
  target_compile_definitions(test_${name} PRIVATE
    PRIMITECT_SOURCE_DIR="${PROJECT_SOURCE_DIR}" PRIMITECT_TOOLS_DIR="${CMAKE_BINARY_DIR}/devel/lib/primitect")
endfunction()
