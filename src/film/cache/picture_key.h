#pragma once

#include <cstdint>
#include <string>

#include "base/sha256.h"
#include "base/snapshot.h"
#include "render/renderer.h"
#include "scene/scene.h"

namespace fumon {

/// SHA-256 of all that a snapshot shows.
Sha256 snapshot_hash(const Snapshot& snapshot);

/// SHA-256 of what all pictures of one renderer depend on: the program's sources and tools, what
/// draws (`environment`), the limits, the scene without what is written over it, and its first
/// snapshot.
Sha256 renderer_key(const Scene& scene, const Snapshot& first, const RenderLimits& limits,
                    const std::string& environment);

/// The key of a picture: of its renderer, of its snapshot and of how that is seen. `reference`: of
/// the snapshot that pose.reference names, where it names one.
Sha256 picture_key(const Sha256& renderer, const Sha256& snapshot, const FramePose& pose,
                   const Sha256& reference);

}  // namespace fumon
