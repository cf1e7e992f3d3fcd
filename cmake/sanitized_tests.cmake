# SPDX-FileCopyrightText: 2026 The primitect developers
# SPDX-License-Identifier: BSD-3-Clause
# Which tests run with sanitizers, and how: with PRIMITECT_TESTS_FROM they are those of that build, run with the sanitized
# libraries of this one. Their own code and main() of the programs go unchecked, with what the compiler takes from headers
# into them, and where libraries reach beyond their local and static objects; what lies on the heap does not. The simulated
# camera (src/synthetic) and eval are left to a build with PRIMITECT_SANITIZE alone, which checks all there is without ROS.

# Whole data sets, the same frames over and over, and a program started dozens of times take minutes under sanitizers; their
# parts have tests of their own, and detect_program starts the program, too.
# With their malloc allocations has nothing to count. From the third line on are scenes that reach no line of the libraries
# that the rest does not reach (gcov; covariance three, simulated_frame two, hard_scenes one).
set(PRIMITECT_NOT_SANITIZED paper_dataset small_scene touching_nees mechanical_part tabletop lying_tubes close_heights
  seen_lengths detect_sensor detect_runs tracked_tables unseen_ends tapered_cups cone_tip heap allocations
  alone_in_image behind_poles cluttered_tables continuations covariance end_faces flanks hard_scenes simulated_frame
  steep_faces table_edges tube_gaps)

# What libpcl takes in one way it gives back in another.
set(sanitizer_options "ASAN_OPTIONS=alloc_dealloc_mismatch=0;UBSAN_OPTIONS=print_stacktrace=1")
if(PRIMITECT_TESTS_FROM)
  # What was built without sanitizers must have them loaded before all else.
  foreach(name asan ubsan)
    execute_process(COMMAND ${CMAKE_CXX_COMPILER} -print-file-name=lib${name}.so
      OUTPUT_VARIABLE runtime OUTPUT_STRIP_TRAILING_WHITESPACE)
    list(APPEND runtimes ${runtime})
  endforeach()
  list(JOIN runtimes ":" runtimes)
  set(sanitized_libraries "LD_PRELOAD=${runtimes};LD_LIBRARY_PATH=${CMAKE_LIBRARY_OUTPUT_DIRECTORY}")
endif()

# Sets DONE where nothing is to be built: the test is left out, or that of another build is run.
function(primitect_sanitized_test done name program)
  set(${done} FALSE PARENT_SCOPE)
  if(PRIMITECT_SANITIZE AND name IN_LIST PRIMITECT_NOT_SANITIZED)
    set(${done} TRUE PARENT_SCOPE)
  endif()
  if(NOT PRIMITECT_TESTS_FROM OR name IN_LIST PRIMITECT_NOT_SANITIZED)
    return()
  endif()
  foreach(library ${ARGN})
    if(TARGET ${library})
      get_target_property(type ${library} TYPE)
      get_target_property(foreign ${library} IMPORTED)
      if(type STREQUAL "STATIC_LIBRARY" AND NOT foreign)
        message(FATAL_ERROR "test_${program} has a copy of ${library}, a static library, which would go unchecked")
      endif()
    endif()
  endforeach()
  add_test(NAME ${name} COMMAND ${PRIMITECT_TESTS_FROM}/devel/lib/primitect/test_${program} ${name})
  set_tests_properties(${name} PROPERTIES ENVIRONMENT "${sanitizer_options};${sanitized_libraries}")
  set(${done} TRUE PARENT_SCOPE)
endfunction()
