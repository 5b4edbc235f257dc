#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "base/worker_pool.h"
#include "gl/context.h"
#include "render/renderer.h"

namespace fumon {

inline View small_view(int width = 320, int height = 180) {
    View view;
    view.image.width = width;
    view.image.height = height;
    return view;
}

/// Frames of a run, drawn one after the other in a context of their own.
inline std::vector<Image> pictures(const View& view, const std::vector<Snapshot>& snapshots) {
    const auto context = gl::Context::create(gl::Backend::automatic);
    WorkerPool pool(2);
    Renderer renderer(*context, view, snapshots.front(), 100, pool);
    std::vector<Image> drawn;
    drawn.reserve(snapshots.size());
    for (const Snapshot& snapshot : snapshots) drawn.push_back(renderer.render(snapshot));
    return drawn;
}

/// A run's first frame, drawn in a context of its own.
inline Image picture(const View& view, const Snapshot& snapshot, int threads = 2,
                     gl::Backend backend = gl::Backend::automatic,
                     const RenderLimits& limits = {}) {
    const auto context = gl::Context::create(backend);
    WorkerPool pool(threads);
    Renderer renderer(*context, view, snapshot, 100, pool, limits);
    return renderer.render(snapshot);
}

/// The colour at a share of the width from the left and of the height from the top.
inline std::array<int, 3> colour_at(const Image& image, double x, double y) {
    const std::uint8_t* pixel = image.row(static_cast<int>(y * image.height)) +
                                3 * static_cast<std::size_t>(x * image.width);
    return {pixel[0], pixel[1], pixel[2]};
}

}  // namespace fumon
