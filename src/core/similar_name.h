// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Which name may be meant by one that there is not.
#pragma once

#include <string>
#include <vector>

namespace primitect {

/// "; did you mean 'max_depth'?", for the end of a message: the name that is spelled most like this one. It begins with
/// it, or at most one letter in six is missing, too much or another (one letter of short names). Empty where none is,
/// and for fewer than four letters.
std::string similarNameHint(const std::string& name, const std::vector<std::string>& names);

}  // namespace primitect
