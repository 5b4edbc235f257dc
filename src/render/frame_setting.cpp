#include "render/frame_setting.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/units.h"
#include "gl/functions.h"
#include "render/light/light.h"
#include "render/light/view_light.h"
#include "render/samples/visibility_buffer.h"
#include "render/view/display_bed.h"
#include "render/view/framing.h"
#include "render/view/ground_choice.h"
#include "render/view/repeated_bed.h"
#include "render/view/shown_snapshot.h"
#include "render/view/water.h"

namespace fumon {

namespace {

/// Cells along the bed's longer side from which on it is drawn as it is. On endless ground one may
/// stand.
int smooth_enough(Ground ground, bool draft) {
    if (draft) return 200;
    return ground == Ground::endless ? 1000 : 400;
}

/// Cells of the maps of a bed in its plain, at most.
constexpr double most_cells_in_plain = 8.6e6;

int chosen_refinement(const View& view, const Snapshot& first, const Snapshot& ground, bool draft) {
    const int wanted =
        refinement_of(first.bed.nx(), first.bed.ny(),
                      static_cast<int>(std::max(view.image.width, view.image.height)),
                      smooth_enough(view.look.ground, draft));
    if (&first == &ground) return wanted;
    const double most = std::sqrt(most_cells_in_plain / static_cast<double>(ground.bed.size()));
    return std::clamp(static_cast<int>(most), 1, wanted);
}

std::optional<SurroundingPlain> plain_of(const View& view, const Snapshot& first,
                                         WorkerPool& pool) {
    if (view.look.ground != Ground::endless || !is_bounded(first)) return std::nullopt;
    return SurroundingPlain(first, pool, known_sea(view, first));
}

TilePlan plan_of(const View& view, const RenderLimits& limits) {
    GLint largest = 0;
    gl::functions().GetIntegerv(GL_MAX_TEXTURE_SIZE, &largest);
    return plan_tiles(static_cast<int>(view.image.width), static_cast<int>(view.image.height),
                      view.camera.has_lens() ? 1 : static_cast<int>(view.image.supersampling),
                      std::min(limits.tile_samples, static_cast<int>(largest)));
}

/// The samples of the first tile, and those beside them.
SampleRectangle samples_of(const TilePlan& plan) {
    const glm::ivec2 pixels(plan.tiles.front().width, plan.tiles.front().height);
    return {{}, {}, plan.factor * pixels + 2};
}

}  // namespace

FrameSetting::FrameSetting(const View& view_, const Snapshot& first_, std::int64_t last_step_,
                           const RenderLimits& limits, PixelFormat wanted_, WorkerPool& pool)
    : view(with_chosen_light(with_chosen_ground(view_, first_))),
      first(shown_first(drawable(first_), view)),
      last_step(last_step_),
      wanted(wanted_),
      kind(lens() ? PixelFormat::radiance : wanted_),
      block(framed_block(view, first)),
      plain(plain_of(view, first, pool)),
      first_in_plain(plain ? std::optional(plain->around(first, pool, view.look.field))
                           : std::nullopt),
      ground(plain ? plain->ground_of(block) : block),
      water(draws_water(view.look, first)),
      refinement(chosen_refinement(view, first, first_ground(), limits.draft)),
      origin(endless() && !plain
                 ? origin_around(camera_at(0), block, first.bed.nx(), first.bed.ny())
                 : DrawnOrigin{}),
      copies(tile_warp_of(view, block, first)),
      plan(plan_of(view, limits)) {}

Snapshot FrameSetting::shown_first(const Snapshot& first, const View& view) {
    std::optional<Snapshot> shown = shown_snapshot(first, view);
    return shown ? *std::move(shown) : first;
}

Camera FrameSetting::camera_at(std::int64_t step) const {
    return camera_at_step(view, block, step, last_step);
}

bool FrameSetting::rasterises_in_buffer() const {
    return endless() && !lens() && view.camera.projection == Projection::perspective &&
           VisibilityBuffer::holds(samples_of(plan));
}

FloorMap FrameSetting::floor(WorkerPool& pool) const {
    const bool has_floor = view.look.mode == ViewMode::scenic && !endless() && !open();
    if (!has_floor) return open_floor();
    const bool studio = view.look.light == LightKind::studio;
    return floor_map(display_bed(first, block, refinement), block, sun_direction(view.sun), pool,
                     studio ? 0.5 * studio_lamp_width * degree : 0.0);
}

int FrameSetting::samples_across() const {
    return static_cast<int>(std::max(view.image.width, view.image.height) *
                            view.image.supersampling);
}

}  // namespace fumon
