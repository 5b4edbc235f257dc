#include "film/film_painter.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/error.h"
#include "figure/canvas/canvas.h"
#include "figure/overlays/overlay_plot.h"
#include "gl/pinned.h"
#include "render/colour/colouring.h"
#include "render/colour/palette.h"
#include "render/view/water.h"
#include "scene/overlay_keys.h"

namespace fumon {

namespace {

constexpr double safe_edge = 0.05;           // of the picture's shorter side, kept free of overlays
constexpr double usual_short_side = 1080.0;  // pixels for which film.cap_height is meant

/// `share` of the second image and the rest of the first.
Image mixed(Image first, const Image& second, double share) {
    for (std::size_t i = 0; i < first.rgb.size(); ++i) {
        const double value = (1.0 - share) * first.rgb[i] + share * second.rgb[i];
        first.rgb[i] = static_cast<std::uint8_t>(std::lround(value));
    }
    return first;
}

/// As the camera sees directions on the ground, wherever it stands.
Camera level_camera(const Camera& camera, double aspect) {
    Camera level = camera;
    level.perspective = false;
    level.half = {aspect, 1.0};
    level.eye = -3.0 * camera.forward;
    return level;
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

FilmPainter::FilmPainter(const Film& film, const StoredBeds& beds, const FilmSize& size,
                         const TitleFacts& facts, gl::Backend backend, WorkerPool& pool)
    : film_(film), beds_(beds), timeline_(film), stage_(make_stage(film, beds, size)) {
    for (std::size_t i = 0; i < film.shots.size(); ++i) shots_.emplace_back(film, i, stage_, beds);
    Scene& scene = stage_.scene;
    scene.locations = film.locations;
    scene.source = film.source;
    const double side = static_cast<double>(std::min(size.width, size.height));
    for (OverlaySettings& overlay : scene.view.overlays) {
        if (overlay.font_size.is_word())
            overlay.font_size = std::max(
                6.0, film.settings.cap_height / cap_height_of_font * side / usual_short_side);
    }
    name_parameter_keys(scene);
    located(film, [&] { rows_ = beds.measurements(plotted_columns(scene)); });
    fix_ranges();
    context_ = gl::Context::create(backend);
    renderer_ =
        std::make_unique<Renderer>(*context_, scene.view, beds.first(), scene.run.steps, pool);
    std::vector<CanvasBox> taken;
    if (has_overlays(scene)) {
        located(film, [&] {
            overlays_ = std::make_unique<FrameOverlays>(
                scene, beds.first(),
                OverlayStyle{film.settings.plates == Plates::none, true, safe_edge * side});
        });
        for (const PlacedOverlay& placed : overlays_->placed()) taken.push_back(placed.box);
    }
    titles_ = std::make_unique<Titles>(film, stage_, beds.first(), facts, timeline_, taken);
    if (const std::string missing = titles_->missing_letters(); !missing.empty())
        notes_.push_back(missing);
}

std::set<std::size_t> FilmPainter::shown_beds(const FilmPart& part) const {
    std::set<std::size_t> shown;
    if (part.kind != FilmPart::Kind::shot) return shown;
    const std::int64_t moving = part.frames - part.held;
    for (std::int64_t i = 0; i < moving; ++i) {
        const double share =
            moving > 1 ? static_cast<double>(i) / static_cast<double>(moving - 1) : 0.0;
        shown.insert(shots_[part.number].bed_at(share));
    }
    return shown;
}

/// What scenes take from each frame is taken from all beds that the film shows.
void FilmPainter::fix_ranges() {
    std::set<std::size_t> shown;
    for (const FilmPart& part : timeline_.parts()) {
        const std::set<std::size_t> beds = shown_beds(part);
        shown.insert(beds.begin(), beds.end());
        constexpr std::int64_t few = 3;  // frames a bed
        const auto count = static_cast<std::int64_t>(beds.size());
        if (count > 1 && part.frames - part.held > few * count) {
            notes_.push_back(fmt::format(
                "shot {}: its {} frames show {} stored beds, each as it is; for a smoother film "
                "let the run store more of them (output.fields_every)",
                part.number + 1, part.frames, count));
        }
    }
    LookSettings& look = stage_.scene.view.look;
    const bool ranged =
        look.colour_by != Colouring::natural && (look.low.is_word() || look.high.is_word());
    const bool watery =
        look.water && look.water_clarity.is_word() && beds_.first().landform == Landform::water;
    if (ranged || watery) {
        double low = INFINITY;
        double high = -INFINITY;
        double clarity = 0.0;
        for (const std::size_t number : shown) {
            const auto bed = beds_.snapshot(number);
            if (watery) clarity = std::max(clarity, water_clarity(look, water_statistics(*bed)));
            if (!ranged) continue;
            const auto [from, to] =
                colour_range(look, *bed, coloured_values(look.colour_by, *bed, beds_.first()));
            low = std::min(low, from);
            high = std::max(high, to);
        }
        if (ranged && low < high) {
            look.low = low;
            look.high = high;
        }
        if (watery && clarity > 0.0) look.water_clarity = clarity;
    }
    if (shown.empty()) return;
    for (OverlaySettings& overlay : stage_.scene.view.overlays) {
        if (overlay.kind != OverlayKind::plot) continue;
        const MeasuredColumn* column = rows_[*shown.rbegin()].find(overlay.y);
        if (column == nullptr) continue;
        const auto [low, high] = growing_range({column->values.data(), column->values.size()});
        if (overlay.low.is_word()) overlay.low = low;
        if (overlay.high.is_word()) overlay.high = high;
    }
}

Image FilmPainter::ground(const PartOfFrame& shown) {
    if (shown.part->kind == FilmPart::Kind::card)
        return titles_->dark_card(shown.part->number, shown.share);
    const StagedShot& shot = shots_[shown.part->number];
    const CameraPose pose = shot.pose_at(shown.share);
    FramePose frame{camera_of(stage_, pose), stage_.scene.view.sun, pose.exposure};
    frame.sun.azimuth = pose.sun_azimuth;
    frame.sun.elevation = pose.sun_elevation;
    return renderer_->render(*beds_.snapshot(shot.bed_at(shown.share)), frame);
}

void FilmPainter::write_over(Image& image, const PartOfFrame& shown) {
    if (!overlays_ || shown.part->kind == FilmPart::Kind::card) return;
    const StagedShot& shot = shots_[shown.part->number];
    const std::size_t number = shot.bed_at(shown.share);
    const Camera camera = level_camera(camera_of(stage_, shot.pose_at(shown.share)), stage_.aspect);
    overlays_->draw(image,
                    {*beds_.snapshot(number), rows_[number], renderer_->colour_range(), &camera});
}

Image FilmPainter::paint(std::int64_t frame) {
    const std::vector<PartOfFrame> shown = timeline_.at(frame);
    Image image = ground(shown.front());
    if (shown.size() == 1) {
        write_over(image, shown.front());
    } else {
        Image second = ground(shown.back());
        const bool both_shots = shown.front().part->kind == FilmPart::Kind::shot &&
                                shown.back().part->kind == FilmPart::Kind::shot;
        if (both_shots) {
            image = mixed(std::move(image), second, shown.back().weight);
            write_over(image, shown.back().weight < 0.5 ? shown.front() : shown.back());
        } else {
            write_over(image, shown.front());
            write_over(second, shown.back());
            image = mixed(std::move(image), second, shown.back().weight);
        }
    }
    titles_->draw(image, frame);
    return image;
}

DrawingRecord FilmPainter::record() const {
    const std::string name = context_->renderer_name();
    const std::string obstacle = gl::rendering_is_pinned() ? text_is_not_pinned : "";
    DrawingRecord record{
        opengl_environment(context_->backend_name(), name, context_->version(), false), obstacle,
        renderer_->exaggeration(), figure_library()};
    return record;
}

}  // namespace fumon
