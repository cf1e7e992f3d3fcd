# SPDX-FileCopyrightText: 2026 The primitect developers
# SPDX-License-Identifier: BSD-3-Clause
# primitect_test(NAME LIBRARIES...): a gtest from NAME.cpp in the current folder.
# Target `tests` builds all of them; ctest runs them.

if(NOT TARGET tests)
  add_custom_target(tests)
endif()
find_package(GTest REQUIRED)

function(primitect_test name)
  if(PRIMITECT_ROS)
    catkin_add_gtest(test_${name} ${name}.cpp)
  else()
    add_executable(test_${name} EXCLUDE_FROM_ALL ${name}.cpp)
    target_link_libraries(test_${name} GTest::gtest)
    add_test(NAME ${name} COMMAND test_${name})
    set_tests_properties(${name} PROPERTIES ENVIRONMENT "ASAN_OPTIONS=alloc_dealloc_mismatch=0;UBSAN_OPTIONS=print_stacktrace=1")
    add_dependencies(tests test_${name})
  endif()
  target_link_libraries(test_${name} GTest::gtest_main ${ARGN})
  target_include_directories(test_${name} PRIVATE ${PROJECT_SOURCE_DIR})
  target_include_directories(test_${name} SYSTEM PRIVATE ${EIGEN3_INCLUDE_DIRS})
  target_compile_definitions(test_${name} PRIVATE
    PRIMITECT_SOURCE_DIR="${PROJECT_SOURCE_DIR}" PRIMITECT_TOOLS_DIR="${CMAKE_BINARY_DIR}/devel/lib/primitect")
endfunction()
