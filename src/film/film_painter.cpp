#include "film/film_painter.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/error.h"
#include "figure/canvas/canvas.h"
#include "figure/overlays/overlay_plot.h"
#include "film/script/film_looks.h"
#include "render/colour/colouring.h"
#include "render/colour/palette.h"
#include "scene/overlay_keys.h"
#include "scene/placed_sun.h"

namespace fumon {

namespace {

constexpr double safe_edge_share = 0.05;   // of the picture's shorter side, kept free of overlays
constexpr double least_letters = 0.6;      // of what stands over several runs' pictures
constexpr double pane_letter_ratio = 1.5;  // of letters in a run's picture, of its share

/// A bed just as wide as a narrow pane would leave half of it to sky and table: its corners are cut
/// off instead.
double overrun_of_pane(double aspect) {
    constexpr double most = 0.45;
    constexpr double narrowest = 0.5;  // from which on it is that much
    return most * std::clamp((1.0 - aspect) / (1.0 - narrowest), 0.0, 1.0);
}

/// Whether records lie at distances in time that differ by half or more.
bool are_uneven(const std::vector<StoredBed>& records) {
    constexpr double even = 1.5;  // ratio of distances
    double shortest = INFINITY;
    double longest = 0.0;
    for (std::size_t i = 1; i < records.size(); ++i) {
        const double apart = records[i].time - records[i - 1].time;
        shortest = std::min(shortest, apart);
        longest = std::max(longest, apart);
    }
    return longest > even * shortest;
}

/// The plate of a film tells that ground between two beds is invented. Of other models' records
/// and surveys at uneven times it tells that ground is held.
TimeNote time_note_of(const Film& film, const StoredBeds& beds) {
    if (film.settings.between == RecordsBetween::blend) return TimeNote::blended;
    const bool held = beds.foreign() != nullptr && are_uneven(beds.beds());
    return held ? TimeNote::held : TimeNote::none;
}

/// An overlay's fault, at its key in the film.
template <class Work>
void located(const Film& film, const Work& work) {
    try {
        work();
    } catch (const KeyError& fault) {
        throw InputError(film.at(fault.key()) + fault.what());
    }
}

}  // namespace

FilmPainter::~FilmPainter() {
    close();
}

bool FilmPainter::transparent() const {
    return stage_.scene.view.look.background == Background::transparent;
}

FilmPainter::FilmPainter(const Film& film, const FilmRuns& runs, const FilmSize& size,
                         const TitleFacts& facts, gl::Backend backend, WorkerPool& pool,
                         const std::vector<Override>& looks, PictureCache* cache)
    : film_(film),
      runs_(runs),
      size_(size),
      timeline_(film),
      layout_(film, runs, size),
      stage_(make_stage(film, runs.first(), layout_.size(), looks)),
      backend_(backend),
      pool_(pool),
      cache_(cache),
      prefetch_(pool.size()) {
    if (layout_.boxes().size() > 1) stage_.overrun = overrun_of_pane(stage_.aspect);
    const double side = static_cast<double>(std::min(size.width, size.height));
    const double letters = film.settings.cap_height / cap_height_em * side / usual_side_pixels;
    for (OverlaySettings& overlay : stage_.scene.view.overlays) {
        if (overlay.kind == OverlayKind::colour_bar) overlay.size *= shared_letters();
        if (!overlay.font_size.is_word()) continue;
        const double ratio = overlay.kind == OverlayKind::plot ? 1.0 : shared_letters();
        overlay.font_size = std::max(6.0, ratio * letters);
    }
    keep_clear(safe_edge_share * side, facts);
    for (std::size_t i = 0; i < film.shots.size(); ++i) shots_.emplace_back(film, i, stage_, runs);
    for (const StagedShot& shot : shots_)
        if (!shot.note().empty()) notes_.push_back(shot.note());
    stage_panes(looks);
    fix_ranges(shown_moments());
    for (Pane& pane : panes_) pane.scene.view.look = stage_.scene.view.look;
    place_overlays(size);
    std::vector<CanvasBox> taken;
    if (overlays_)
        for (const PlacedOverlay& placed : overlays_->placed()) taken.push_back(placed.box);
    for (std::size_t run = 0; run < panes_.size(); ++run) {
        if (!panes_[run].overlays) continue;
        for (const PlacedOverlay& placed : panes_[run].overlays->placed()) {
            const PaneBox& pane = layout_.boxes()[run];
            taken.push_back({placed.box.x + pane.x, placed.box.y + pane.y, placed.box.width,
                             placed.box.height});
        }
    }
    FilmStage whole = stage_;
    whole.scene.view.image.width = size.width;
    whole.scene.view.image.height = size.height;
    titles_ = std::make_unique<Titles>(film, whole, runs.first().first(), facts, timeline_, taken);
    for (const std::string& missing : {titles_->missing_letters(), layout_.missing_letters()})
        if (!missing.empty()) notes_.push_back(missing);
}

/// The letters of what stands in a run's own picture, as a share of a film's of one run.
double FilmPainter::pane_letters() const {
    const double side = static_cast<double>(std::min(size_.width, size_.height));
    return std::min(1.0, pane_letter_ratio * layout_.shorter_side() / side);
}

/// Likewise of what stands over several pictures.
double FilmPainter::shared_letters() const {
    return layout_.boxes().size() > 1 ? std::max(least_letters, pane_letters()) : 1.0;
}

/// What each run's part of the picture is drawn with: its own scene under one look.
void FilmPainter::stage_panes(const std::vector<Override>& looks) {
    if (runs_.size() > 1) stage_.scene.view.look.exaggeration = stage_.block.exaggeration;
    if (differs()) {
        LookSettings& look = stage_.scene.view.look;
        look.colour_by =
            colours_field(look.colour_by) ? Colouring::field_change : Colouring::change;
        look.palette = "vik";
        look.low = look.high = WordOrReal{"auto", 0.0};
    }
    for (std::size_t run = 0; run < runs_.size(); ++run) {
        Pane pane{&runs_.beds(run), stage_.scene};
        pane.sun = with_looks(pane.beds->scene(), film_, looks).view.sun;
        if (run > 0) {
            pane.scene = runs_.beds(run).scene();
            pane.scene.view = stage_.scene.view;
        }
        pane.scene.locations = film_.locations;
        pane.scene.source = film_.source;
        name_parameter_keys(pane.scene);
        located(film_, [&] { pane.rows = pane.beds->measurements(plotted_columns(pane.scene)); });
        panes_.push_back(std::move(pane));
    }
    stage_.scene.view.overlays = panes_.front().scene.view.overlays;
}

/// All moments of stored beds that the film shows, or shows the time between, which all runs have.
std::set<FilmPainter::Moment> FilmPainter::shown_moments() const {
    std::set<Moment> shown;
    for (const FilmPart& part : timeline_.parts()) {
        if (part.kind != FilmPart::Kind::shot) continue;
        const std::int64_t moving = part.frames - part.held;
        for (std::int64_t i = 0; i < moving; ++i) {
            const double share =
                moving > 1 ? static_cast<double>(i) / static_cast<double>(moving - 1) : 0.0;
            const RecordPlace place = shots_[part.number].place_at(share);
            for (const std::size_t bed : {place.bed, place.next})
                shown.insert({part.number, {bed, bed, 0.0}});
        }
    }
    for (const Moment& moment : shown)
        for (std::size_t run = 0; run < runs_.size(); ++run)
            static_cast<void>(bed_of(run, moment));  // throws where one is missing
    return shown;
}

/// Over the whole picture stands what all runs share; over the picture of each of several stands
/// its plot.
void FilmPainter::place_overlays(const FilmSize& size) {
    const bool several = layout_.boxes().size() > 1;
    const auto is_own = [&](const OverlaySettings& overlay) {
        return several && overlay.kind == OverlayKind::plot;
    };
    double end_time = 0.0;
    for (std::size_t run = 0; run < runs_.size(); ++run)
        end_time = std::max(end_time, runs_.beds(run).beds().back().time);
    const auto make = [&](const Scene& scene, double side,
                          double under = 0.0) -> std::unique_ptr<FrameOverlays> {
        if (!has_overlays(scene)) return nullptr;
        std::unique_ptr<FrameOverlays> made;
        located(film_, [&] {
            made = std::make_unique<FrameOverlays>(
                scene, runs_.first().first(),
                OverlayStyle{film_.settings.plates == Plates::none, true, safe_edge_share * side,
                             end_time, under, time_note_of(film_, runs_.first())});
        });
        return made;
    };
    const double side = static_cast<double>(std::min(size.width, size.height));
    whole_ = panes_.front().scene;
    whole_.view.image.width = size.width;
    whole_.view.image.height = size.height;
    for (OverlaySettings& overlay : whole_.view.overlays)
        if (is_own(overlay)) overlay.show = false;
    if (several) {  // each run has its own
        whole_.view.look.contours = WordOrReal{"none", 0.0};
        whole_.view.look.survey_edge = SurveyEdge::none;
        whole_.view.layers.clear();
        whole_.view.placed_layers.reset();
    }
    overlays_ = make(whole_, side, layout_.strip());
    if (!several) return;
    const double pane_side = layout_.shorter_side();
    const double smaller = pane_letters();
    for (Pane& pane : panes_) {
        for (OverlaySettings& overlay : pane.scene.view.overlays) {
            if (!is_own(overlay)) overlay.show = false;
            if (!overlay.font_size.is_word())
                overlay.font_size = std::max(6.0, smaller * overlay.font_size.value);
        }
        pane.overlays = make(pane.scene, pane_side);
    }
}

/// The pictures of runs that a frame is put together of, in the order in which they are drawn;
/// those under a card left out.
std::vector<PictureRequest> FilmPainter::pictures_of(std::int64_t frame) const {
    const std::size_t runs = film_.panes.show == PanesShow::wipe ? 2 : layout_.boxes().size();
    std::vector<PictureRequest> pictures;
    for (const FramePart& shown : timeline_.at(frame)) {
        if (shown.part->kind != FilmPart::Kind::shot) continue;
        for (std::size_t run = 0; run < runs; ++run)
            pictures.push_back({run, shown.part->number, shown.share, frame_of(shown)});
    }
    return pictures;
}

/// Streamers move where camera and bed stand still, too.
std::int64_t FilmPainter::frame_of(const FramePart& shown) const {
    return stage_.scene.view.streamers.strength > 0.0 ? shown.frame : 0;
}

FilmPainter::ViewState FilmPainter::view_state_of(const PictureRequest& wanted) const {
    const StagedShot& shot = shots_[wanted.shot];
    return {{wanted.shot, shot.place_at(wanted.share)}, shot.pose_at(wanted.share), wanted.frame};
}

namespace {

/// Whether a shot says nothing of where the sun stands.
bool leaves_sun_to_scene(const Shot& shot) {
    const auto is_left = [](const auto& light) {
        return light.sun_azimuth.is_word() && light.sun_elevation.is_word();
    };
    return shot.move != Move::morning_to_evening && is_left(shot) &&
           std::ranges::all_of(shot.keys, is_left);
}

}  // namespace

FramePose FilmPainter::pose_of(std::size_t run, const ViewState& view_state) const {
    FramePose frame{camera_of(stage_, view_state.pose), stage_.scene.view.sun,
                    view_state.pose.exposure};
    frame.sun.azimuth = view_state.pose.sun_azimuth;
    frame.sun.elevation = view_state.pose.sun_elevation;
    frame.frame = view_state.frame;
    frame.metered = camera_of(stage_, shots_[view_state.moment.shot].pose_at(0.0));
    const StoredBeds& beds = *panes_[run].beds;
    frame.share =
        share_of_run(beds.step_at(place_of(run, view_state.moment)), beds.scene().run.steps);
    const SunSettings there = sun_at(panes_[run].sun, frame.share);
    if (there.hours != 0.0 && leaves_sun_to_scene(film_.shots[view_state.moment.shot]))
        frame.sun = there;
    if (differs()) frame.reference = snapshot_of(1, view_state.moment);
    return frame;
}

/// Reads the bed, and says how what its picture needs is found.
PicturePrefetch::Find FilmPainter::preparation_of(std::size_t run, const ViewState& view_state) {
    Pane& pane = panes_[run];
    return [&renderer = renderer_of(pane), bed = snapshot_of(run, view_state.moment),
            frame = pose_of(run, view_state), before = pane.lit](WorkerPool& pool) {
        return renderer.ready(bed, frame, before, pool);
    };
}

void FilmPainter::prefetch_from(const PictureRequest& present) {
    auto next = std::ranges::find(coming_, present);
    if (next == coming_.end() || ++next == coming_.end()) return;
    const ViewState view_state = view_state_of(*next);
    if (panes_[next->run].seen == view_state) return;
    if (!cache_ || !cache_->holds(key_of(next->run, view_state)))
        prefetch_.begin(*next, preparation_of(next->run, view_state));
}

/// What one run shows.
Image FilmPainter::picture(std::size_t run, const FramePart& shown) {
    const PictureRequest wanted{run, shown.part->number, shown.share, frame_of(shown)};
    Pane& pane = panes_[run];
    const ViewState view_state = view_state_of(wanted);
    if (pane.seen != view_state) {
        show(run, wanted, view_state);
    } else {
        prefetch_.wait_idle();
        prefetch_from(wanted);
    }
    Image image = pane.image;
    if (pane.overlays) {
        const Camera camera = camera_of(stage_, view_state.pose);
        pane.overlays->draw(
            image, {*snapshot_of(run, view_state.moment), pane.rows[bed_of(run, view_state.moment)],
                    pane.colours, &camera});
    }
    return image;
}

Image FilmPainter::ground(const FramePart& shown) {
    if (shown.part->kind == FilmPart::Kind::card) {
        return titles_->card(shown.part->number, shown.share,
                             [&](std::int64_t frame) { return ground(timeline_.shot_at(frame)); });
    }
    if (runs_.size() == 1) return picture(0, shown);
    Image whole = layout_.ground();
    const std::vector<PaneBox>& boxes = layout_.boxes();
    if (film_.panes.show == PanesShow::wipe) {
        const std::vector<double>& places = film_.panes.wipe_places;
        const double place = places[0] + (places[1] - places[0]) * eased(shown.share);
        copy_into(whole, wiped(picture(0, shown), picture(1, shown), place), boxes.front());
    } else {
        for (std::size_t run = 0; run < boxes.size(); ++run)
            copy_into(whole, picture(run, shown), boxes[run]);
    }
    return whole;
}

void FilmPainter::write_over(Image& image, const FramePart& shown) {
    if (!overlays_ || shown.part->kind == FilmPart::Kind::card) return;
    const StagedShot& shot = shots_[shown.part->number];
    const RecordPlace place = shot.place_at(shown.share);
    const Pane& pane = panes_.front();
    const Camera camera = camera_of(stage_, shot.pose_at(shown.share));
    overlays_->draw(image, {*pane.beds->snapshot(place), pane.rows[place.bed], pane.colours,
                            &camera, layout_.size().height});
}

void FilmPainter::begin_frame(std::int64_t frame) {
    open();
    coming_ = pictures_of(frame);
    if (frame == last_frame_ + 1 && frame + 1 < frames()) {
        const std::vector<PictureRequest> next = pictures_of(frame + 1);
        coming_.insert(coming_.end(), next.begin(), next.end());
    }
    last_frame_ = frame;
}

Image FilmPainter::paint(std::int64_t frame) {
    begin_frame(frame);
    const std::vector<FramePart> shown = timeline_.at(frame);
    Image image = ground(shown.front());
    if (shown.size() == 1) {
        titles_->darken(image, frame);
        write_over(image, shown.front());
    } else {
        Image second = ground(shown.back());
        const bool both_shots = shown.front().part->kind == FilmPart::Kind::shot &&
                                shown.back().part->kind == FilmPart::Kind::shot;
        if (both_shots) {
            image = mixed(std::move(image), second, shown.back().weight);
            titles_->darken(image, frame);
            write_over(image, shown.back().weight < 0.5 ? shown.front() : shown.back());
        } else {
            titles_->darken(image, frame);
            titles_->darken(second, frame);
            write_over(image, shown.front());
            write_over(second, shown.back());
            image = mixed(std::move(image), second, shown.back().weight);
        }
    }
    write_titles(image, frame);
    return image;
}

Image FilmPainter::untitled(const FramePart& shown, std::int64_t frame) {
    open();
    Image image = ground(shown);
    titles_->darken(image, frame);
    write_over(image, shown);
    return image;
}

void FilmPainter::write_titles(Image& image, std::int64_t frame) {
    titles_->draw(image, frame);
}

}  // namespace fumon
