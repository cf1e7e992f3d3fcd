# SPDX-FileCopyrightText: 2026 The primitect developers
# SPDX-License-Identifier: BSD-3-Clause
# primitect_outside_frames(target...): no frame passes through their code, so they are compiled with -O1, which takes two
# thirds of the time.
function(primitect_outside_frames)
  foreach(target ${ARGN})
    target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1>)
  endforeach()
endfunction()
