# SPDX-FileCopyrightText: 2026 The primitect developers
# SPDX-License-Identifier: BSD-3-Clause
# primitect_tests(PROGRAM TESTS name... LIBRARIES name...): gtests from files name.cpp in the current folder, one program,
# test_PROGRAM; to ctest each file is a test. primitect_test(NAME LIBRARIES...): a program of one file.
# Target `tests` builds all of them; ctest runs them. With sanitizers some are left out, all may be those of another build,
# then there is no target test_PROGRAM: see sanitized_tests.cmake.

if(NOT TARGET tests)
  add_custom_target(tests)
endif()
find_package(GTest REQUIRED)
if(NOT TARGET GTest::gtest)  # CMake before 3.20 has another name for it
  add_library(GTest::gtest INTERFACE IMPORTED)
  target_link_libraries(GTest::gtest INTERFACE GTest::GTest)
endif()

# What takes long to compile and many tests need, compiled once: headers, decompositions, patterns, JSON; and main().
add_library(primitect_test_support STATIC EXCLUDE_FROM_ALL
  ${PROJECT_SOURCE_DIR}/test/support/linear_algebra.cpp ${PROJECT_SOURCE_DIR}/test/support/main.cpp
  ${PROJECT_SOURCE_DIR}/test/support/text.cpp)
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
target_compile_options(primitect_test_support PUBLIC ${PRIMITECT_COMPILE_QUICKLY})
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

# One of ctest's tests: what NAME.cpp has in test_PROGRAM. In a ROS build with catkin's report, for `run_tests`.
function(primitect_add_test name program)
  if(PRIMITECT_ROS)
    get_target_property(folder test_${program} RUNTIME_OUTPUT_DIRECTORY)
    set(report gtest-test_${name}.xml)
    catkin_run_tests_target(gtest test_${name} ${report} DEPENDENCIES test_${program}
      COMMAND "${folder}/test_${program} ${name} --gtest_output=xml:${CATKIN_TEST_RESULTS_DIR}/${PROJECT_NAME}/${report}")
  else()
    add_test(NAME ${name} COMMAND test_${program} ${name})
    set_tests_properties(${name} PROPERTIES ENVIRONMENT "${sanitizer_options}")
  endif()
endfunction()

function(primitect_tests program)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "TESTS;LIBRARIES")
  if(NOT arg_TESTS OR arg_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "primitect_tests(${program}): names of tests follow TESTS, libraries LIBRARIES")
  endif()
  set(tests)
  foreach(name ${arg_TESTS})
    primitect_sanitized_test(done ${name} ${program} ${arg_LIBRARIES})
    if(NOT done)
      list(APPEND tests ${name})
    endif()
  endforeach()
  if(NOT tests)
    return()
  endif()
  list(TRANSFORM tests APPEND .cpp OUTPUT_VARIABLE files)
  add_executable(test_${program} EXCLUDE_FROM_ALL ${files})
  add_dependencies(tests test_${program})
  foreach(name ${tests})
    primitect_add_test(${name} ${program})
  endforeach()
  target_link_libraries(test_${program} primitect_test_support ${arg_LIBRARIES})
  # What comes with PCL is compiled with -fPIC, which the precompiled headers do not fit.
  if("${arg_LIBRARIES}" MATCHES "pcl_common")
    target_include_directories(test_${program} SYSTEM PRIVATE ${PCL_INCLUDE_DIRS})
  else()
    target_precompile_headers(test_${program} REUSE_FROM primitect_test_support)
  endif()
  target_include_directories(test_${program} PRIVATE ${PROJECT_SOURCE_DIR})
  target_include_directories(test_${program} SYSTEM PRIVATE ${EIGEN3_INCLUDE_DIRS})
  target_compile_definitions(test_${program} PRIVATE
    PRIMITECT_SOURCE_DIR="${PROJECT_SOURCE_DIR}" PRIMITECT_TOOLS_DIR="${CMAKE_BINARY_DIR}/devel/lib/primitect")
endfunction()

# Those of ctest's tests of this folder whose names match: catkin has names of its own for gtests and rostests.
function(primitect_find_tests variable pattern)
  get_property(tests DIRECTORY PROPERTY TESTS)
  list(FILTER tests INCLUDE REGEX "${pattern}")
  set(${variable} ${tests} PARENT_SCOPE)
endfunction()

function(primitect_test name)
  primitect_tests(${name} TESTS ${name} LIBRARIES ${ARGN})
endfunction()
