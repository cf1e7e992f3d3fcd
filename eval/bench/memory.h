// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Resident memory of this process, now and at its peak (Linux).
#pragma once

#include <string>

namespace primitect::bench {

/// A line of /proc/self/status in kB: "VmRSS", "VmHWM". Throws std::runtime_error naming it when it is not there.
long statusKilobytes(const std::string& name);

/// Gives free memory back to the system and lets VmHWM begin anew at what is resident now. False where the system
/// refuses: VmHWM is then that of the whole life of the process.
bool forgetPeak();

}  // namespace primitect::bench
