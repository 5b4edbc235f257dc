#pragma once

#include "base/snapshots/ground_range.h"
#include "base/worker_pool.h"
#include "fuzz_input.h"
#include "gl/context.h"
#include "models/registry.h"
#include "render/life/person_layer.h"
#include "render/life/track_layer.h"
#include "render/renderer.h"
#include "render/streamers/blown_sand.h"
#include "render/view/lens.h"
#include "render/view/water.h"
#include "scene/initial_bed.h"

namespace fumon::fuzz {

/// What takes seconds and shows no more.
inline View smallest(View view) {
    view.image.width = 16;
    view.image.height = 16;
    view.image.supersampling = 1;
    if (view.camera.has_lens()) view.camera.lens_samples = {"", 4.0};
    return view;
}

/// Draws the smallest picture of a scene with a bed of few cells, unless a run refuses it.
inline void draw_small(const Scene& scene, const InitialBed& initial) {
    static WorkerPool pool(1, "fuzz");
    static const auto context = gl::Context::create(gl::Backend::automatic);
    if (!beyond_ground(initial.bed, initial.scale).empty()) return;  // as a run refuses it
    const auto model =
        find_model(scene.model.name)
            ->make(scene.model.parameters, {initial.bed, initial.nodata, initial.scale,
                                            static_cast<std::uint64_t>(scene.seed), pool, false});
    const Snapshot first = model->snapshot();
    const View view = smallest(scene.view);
    if (colours_water(view.look.colour_by) && !has_water(first)) return;
    if (view.look.mark != Marking::none && marked_field(view.look.mark, first) == nullptr) return;
    check_lens(view, first);
    check_persons(view, first);
    check_tracks(view, first);
    check_streamers(view, first);
    if (first.section && view.look.mode == ViewMode::figure) return;  // no 3-D view
    Renderer renderer(*context, view, first, scene.run.steps, pool);
    if (renderer.render(first).rgb.size() != 3UL * 16 * 16)
        broken_promise("a picture has its size", "");
}

}  // namespace fumon::fuzz
