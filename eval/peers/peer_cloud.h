// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// What peers are given: the cloud with normals, the same for all of them.
#pragma once

#include "eval/labelled_cloud.h"

namespace primitect::eval {

/// The cloud itself if it brings normals. Otherwise with normals at every measured point, estimated as our detector
/// estimates those of its samples (image window, or nearest neighbours when unorganized; default parameters), NaN where
/// there is none to be had. They are made once for a cloud and no peer's time contains them: a gift to the peers.
/// Valid until the next call, or as long as the input; for one thread.
const Cloud& peerCloud(const LabelledCloud& input);

}  // namespace primitect::eval
