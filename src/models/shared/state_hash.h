#pragma once

#include "base/sha256.h"
#include "models/shared/model.h"

namespace fumon {

/// SHA-256 over model name, step (64-bit little-endian) and every state field in declared order
/// (float64 little-endian).
Sha256 state_hash(const Model& model);

}  // namespace fumon
