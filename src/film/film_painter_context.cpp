#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "film/cache/picture_key.h"
#include "film/film_painter.h"
#include "gl/pinned.h"

namespace fumon {

void FilmPainter::open() {
    if (context_) return;
    context_ = gl::Context::create(backend_);
}

RenderLimits FilmPainter::limits() const {
    RenderLimits limits;
    limits.draft = film_.settings.draft;
    return limits;
}

/// Made for the first picture that is drawn: those of a film that is made again may all be kept.
Renderer& FilmPainter::renderer_of(Pane& pane) {
    if (!pane.renderer) {
        pane.renderer = std::make_unique<Renderer>(
            *context_, pane.scene.view, pane.beds->first(), pane.scene.run.steps, pool_, limits(),
            light_ ? PixelFormat::radiance : PixelFormat::display_8);
    }
    return *pane.renderer;
}

std::size_t FilmPainter::bed_of(std::size_t run, const Moment& moment) const {
    return runs_.in_step(run, moment.place.bed, film_.shots[moment.shot].clock);
}

RecordPlace FilmPainter::place_of(std::size_t run, const Moment& moment) const {
    if (film_.settings.between == RecordsBetween::blend)
        return runs_.in_step(run, moment.place, film_.shots[moment.shot].clock);
    const std::size_t bed = bed_of(run, moment);
    return {bed, bed, 0.0};
}

std::shared_ptr<const Snapshot> FilmPainter::snapshot_of(std::size_t run,
                                                         const Moment& moment) const {
    return panes_[run].beds->snapshot(place_of(run, moment));
}

Sha256 FilmPainter::bed_key(std::size_t run, const Moment& moment) {
    Pane& pane = panes_[run];
    const RecordPlace place = place_of(run, moment);
    if (place.share > 0.0) return snapshot_hash(*snapshot_of(run, moment));
    const std::size_t number = place.bed;
    auto known = pane.bed_keys.find(number);
    if (known == pane.bed_keys.end())
        known = pane.bed_keys.emplace(number, snapshot_hash(*pane.beds->snapshot(number))).first;
    return known->second;
}

Sha256 FilmPainter::key_of(std::size_t run, const ViewState& view_state) {
    Pane& pane = panes_[run];
    if (!pane.key)
        pane.key = renderer_key(pane.scene, pane.beds->first(), limits(),
                                environment_text(record().environment));
    const Sha256 reference = differs() ? bed_key(1, view_state.moment) : Sha256{};
    return picture_key(*pane.key, bed_key(run, view_state.moment), pose_of(run, view_state),
                       reference);
}

/// Gives a run's pane the picture of a state, kept or drawn, and has the next one begin.
void FilmPainter::show(std::size_t run, const PictureRequest& wanted, const ViewState& view_state) {
    Pane& pane = panes_[run];
    std::optional<ReadyPicture> ready = prefetch_.take(wanted);
    std::optional<Sha256> key;
    if (cache_) key = key_of(run, view_state);
    std::optional<CachedPicture> kept;
    if (cache_ && !ready) kept = cache_->find(*key);
    pane.seen = view_state;
    if (kept) {
        pane.image = std::move(kept->image);
        pane.colours = kept->colours;
        prefetch_from(wanted);
        return;
    }
    if (!ready) ready = preparation_of(run, view_state)(pool_);
    pane.lit = ready->lit;
    prefetch_from(wanted);
    pane.image = pane.renderer->render(*ready);
    pane.colours = pane.renderer->frame_colour_range();
    if (cache_) cache_->add(*key, {pane.image, pane.colours});
}

LayeredImage FilmPainter::light(std::int64_t frame) {
    begin_frame(frame);
    const std::vector<FramePart> shown = timeline_.at(frame);
    LayeredImage light = light_of(shown.front());
    if (shown.size() == 1) return light;
    return mixed(std::move(light), light_of(shown.back()), shown.back().weight);
}

LayeredImage FilmPainter::light_of(const FramePart& shown) {
    if (!light_) {
        close();
        light_ = true;
    }
    open();
    const PictureRequest wanted{0, shown.part->number, shown.share, frame_of(shown)};
    std::optional<ReadyPicture> ready = prefetch_.take(wanted);
    if (!ready) ready = preparation_of(0, view_state_of(wanted))(pool_);
    panes_.front().lit = ready->lit;
    prefetch_from(wanted);
    return renderer_of(panes_.front()).render_light(*ready);
}

void FilmPainter::close() {
    if (!context_) return;
    prefetch_.wait_idle();
    context_->make_current();  // other films may have drawn since
    for (Pane& pane : panes_) {
        pane.renderer.reset();
        pane.lit.reset();
        pane.seen.reset();
        pane.image = {};
    }
    context_.reset();
}

DrawingRecord FilmPainter::record() {
    open();
    const std::string name = context_->renderer_name();
    const std::string obstacle = gl::rendering_is_pinned() ? text_is_not_pinned : "";
    DrawingRecord record{
        opengl_environment(context_->backend_name(), name, context_->version(), false), obstacle,
        stage_.block.exaggeration, figure_library()};
    return record;
}

/// Where the pace follows the change of the ground, beds may lie densely at one end of a shot and
/// far apart at the other: there a second is looked at, elsewhere all of the shot that moves.
FilmPainter::Stretch FilmPainter::stillest(const FilmPart& part) const {
    const double frames =
        film_.settings.frames_for_one * static_cast<double>(part.frames - part.held);
    const double second = film_.settings.frames_for_one * film_.settings.rate;
    const bool whole = film_.shots[part.number].pace != Pace::change || second >= frames;
    const double length = whole ? frames : second;
    Stretch stillest;
    for (double from = 0.0; from + length <= frames; from += 1.0) {
        const auto bed_at = [&](double frame) {
            return shots_[part.number].place_at(std::min(frame / frames, 1.0)).bed;
        };
        const auto [first, last] = std::minmax({bed_at(from), bed_at(from + length)});
        if (stillest.frames > 0.0 && last - first >= stillest.last - stillest.first) continue;
        stillest = {length, first, last};
    }
    return stillest;
}

/// Tells of shots whose ground stands still for some frames and then jumps, and which interval of
/// stored beds would change that. A draft is told what the whole film would show.
void FilmPainter::note_jumps() {
    constexpr double few = 3.0;  // frames a bed
    if (film_.settings.between == RecordsBetween::blend) return;
    const std::vector<StoredBed>& beds = runs_.first().beds();
    for (const FilmPart& part : timeline_.parts()) {
        if (part.kind != FilmPart::Kind::shot) continue;
        const auto [frames, first, last] = stillest(part);
        const StagedShot& shot = shots_[part.number];
        if (shot.place_at(0.0).bed == shot.place_at(1.0).bed) continue;
        const std::size_t count = last - first + 1;
        if (frames <= few * static_cast<double>(count)) continue;
        const std::size_t next = std::min(std::max(last, first + 1), beds.size() - 1);
        const std::int64_t steps = beds[next].step - beds[first].step;
        const auto fitting = static_cast<std::int64_t>(2.0 * static_cast<double>(steps) / frames);
        const std::string remedy = fitting >= 1
                                       ? fmt::format(
                                             "for a smoother film run the scene with --set "
                                             "output.fields_every={}",
                                             fitting)
                                       : "for a smoother film shorten the shot, or show more steps";
        const double all =
            film_.settings.frames_for_one * static_cast<double>(part.frames - part.held);
        const std::string which = frames < all ? fmt::format("{:.0f} of its {:.0f}", frames, all)
                                               : fmt::format("its {:.0f}", all);
        notes_.push_back(fmt::format(
            "shot {}: {} frames show {} stored bed{}, each as it is, so that the ground "
            "moves in jumps; {}",
            part.number + 1, which, count, count == 1 ? "" : "s", remedy));
    }
}

}  // namespace fumon
