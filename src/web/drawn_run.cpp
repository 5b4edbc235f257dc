#include "web/drawn_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numeric>
#include <optional>
#include <utility>

#include "base/worker_pool.h"
#include "figure/overlays/overlay_text.h"
#include "picture/stills/picture_file.h"
#include "render/land/sea_water.h"
#include "render/view/framing.h"
#include "render/view/ground_choice.h"
#include "render/view/shown_snapshot.h"
#include "render/view/water.h"
#include "run/frame_painter.h"
#include "run/terminal/status_line.h"
#include "web/page_surface.h"
#include "web/wall_colours.h"

namespace fumon {

namespace {

constexpr double least_picture_side = 512.0;  // pixels of a bed's longer side
constexpr double most_picture_side = 1024.0;
constexpr int picture_quality = 70;
constexpr int poster_quality = 84;

/// Whether the scene's camera has the whole block before it.
bool fits_block(const View& view, const Snapshot& first) {
    const CameraSettings& camera = view.camera;
    return camera.projection == Projection::perspective && camera.framing == Framing::block &&
           camera.at.empty() && camera.look_at.empty() && camera.distance.is_word() &&
           !is_endless(view, first);
}

/// What stands on the bed or moves over it would lie flat on a page.
Scene scene_for_page(const PageRun& run, const PageOptions& options) {
    Scene scene = run.scene;
    View& view = scene.view;
    view.overlays.clear();
    view.persons.clear();
    view.streamers.strength = 0.0;
    view.sun.haze = 0.0;
    view.look.ground = Ground::table;
    view.look.background = Background::surroundings;
    view.look.survey_edge = SurveyEdge::none;
    view.look.air = false;
    view.image = {};
    if (options.exaggeration > 0.0) view.look.exaggeration = options.exaggeration;
    CameraSettings camera;
    if (fits_block(run.scene.view, run.first)) {
        camera.azimuth = view.camera.azimuth;
        camera.elevation = view.camera.elevation;
        camera.field_of_view = view.camera.field_of_view;
        camera.focal_length = view.camera.focal_length;
    } else if (view.camera.projection != Projection::map) {
        camera.azimuth = view.camera.azimuth;
    }
    view.camera = camera;
    return scene;
}

Snapshot without_air(const Snapshot& snapshot) {
    Snapshot bare = snapshot;
    bare.section.reset();
    return bare;
}

/// As its surface is shown: a profile as a strip, a coast with its sea.
Snapshot surface_of(const Snapshot& snapshot, const View& view) {
    if (snapshot.bed.ny() > 1) {
        Snapshot surface = snapshot;
        if (!view.look.sea_level.is_word()) add_sea(surface, view.look.sea_level.value);
        return surface;
    }
    std::optional<Snapshot> strip = shown_snapshot(snapshot, view);
    return strip ? *std::move(strip) : snapshot;
}

Scene from_above(Scene scene, double width, double height, double pixels) {
    scene.view.camera = {};
    scene.view.camera.projection = Projection::map;
    scene.view.camera.margin = 0.0;
    const double per_length = pixels / std::max(width, height);
    scene.view.image.width = std::max(16L, std::lround(width * per_length));
    scene.view.image.height = std::max(16L, std::lround(height * per_length));
    return scene;
}

std::string webp(const Image& image, int quality) {
    const std::vector<std::uint8_t> bytes =
        encode_picture(image, PictureFormat::webp, {quality, false}, screen_dots_per_inch, {});
    return {bytes.begin(), bytes.end()};
}

std::string label_of(const TimeText& times, const Snapshot& snapshot) {
    std::string text = times(snapshot.time);
    if (times.unit != "steps") text = fmt::format("step {}, {}", snapshot.step, text);
    if (times.date) text += ", " + times.date(snapshot.time);
    return text;
}

class RunDrawing {
  public:
    RunDrawing(const PageRun& run, const PageOptions& options, const WorkOptions& work)
        : run_(run),
          work_(work),
          scene_(scene_for_page(run, options)),
          first_(without_air(run.first)),
          pool_(work.threads, "fumon-render") {
        const Snapshot surface = surface_of(first_, scene_.view);
        const int nx = surface.bed.nx();
        const int ny = surface.bed.ny();
        made_.cells_per_point = cells_per_point(surface.bed, options.most_triangles);
        made_.nodata = coarse_mask(surface.nodata, nx, ny, made_.cells_per_point);
        made_.block = framed_block(scene_.view, surface);
        made_.zero = made_.block.reference * surface.scale.height_unit;
        made_.scale = surface.scale;
        made_.width = nx * surface.scale.dx;
        made_.height = ny * surface.scale.dy;
        made_.azimuth = scene_.view.camera.azimuth;
        made_.elevation = scene_.view.camera.elevation;
        made_.margin = scene_.view.camera.margin;
        constexpr double any_aspect = 1.6;
        made_.tangent = place_camera(scene_.view.camera, made_.block, any_aspect, 0.0).half.y;
    }

    DrawnRun draw(const std::vector<std::size_t>& numbers) {
        draw_beds(numbers);
        draw_poster(without_air(*run_.snapshot(numbers.back())));
        find_walls(without_air(*run_.snapshot(numbers[deepest()])));
        return std::move(made_);
    }

  private:
    void draw_beds(const std::vector<std::size_t>& numbers) {
        const double longer = std::max(first_.bed.nx(), first_.bed.ny());
        Scene above = from_above(scene_, made_.width, made_.height,
                                 std::clamp(longer, least_picture_side, most_picture_side));
        // Its outline there is a smooth one, and that of the page goes along cells.
        if (!first_.nodata.empty()) above.view.look.background = Background::transparent;
        const TimeText times = time_text_of(run_.scene, first_);
        const auto painter = make_frame_painter(above, first_, work_.backend, pool_);
        painter->keep_colours();
        StatusLine status(work_.verbosity);
        for (const std::size_t number : numbers) {
            const Snapshot snapshot = without_air(*run_.snapshot(number));
            const Snapshot surface = surface_of(snapshot, scene_.view);
            DrawnBed bed;
            bed.step = snapshot.step;
            bed.label = label_of(times, snapshot);
            bed.heights = coarse_field(surface.bed, surface.nodata, made_.cells_per_point,
                                       made_.zero, surface.scale.height_unit);
            bed.reference =
                block_of_frame(made_.block, scene_.view.look, first_, snapshot).reference *
                    surface.scale.height_unit -
                made_.zero;
            if (draws_water(scene_.view.look, surface)) bed.depths = depths_of(surface);
            Image picture = painter->paint(snapshot, {});
            fill_beside(picture);
            bed.picture = webp(picture, picture_quality);
            made_.nx = bed.heights.nx();
            made_.ny = bed.heights.ny();
            made_.beds.push_back(std::move(bed));
            if (status.due())
                status.show(fmt::format("bed {}/{}", made_.beds.size(), numbers.size()));
        }
        status.clear();
    }

    [[nodiscard]] Field<float> depths_of(const Snapshot& snapshot) const {
        const Field<float> depths = water_depths(snapshot);
        Grid grid(depths.nx(), depths.ny());
        const auto closed = static_cast<float>(closed_depth(snapshot.scale));
        for (std::size_t i = 0; i < depths.size(); ++i) {
            const float depth = depths.values()[i];
            grid.values()[i] = depth >= closed ? static_cast<double>(depth) : 0.0;
        }
        return coarse_field(grid, snapshot.nodata, made_.cells_per_point, 0.0, 1.0);
    }

    /// The number of the bed with most water, whose sides tell its colour.
    [[nodiscard]] std::size_t deepest() const {
        const auto water = [](const DrawnBed& bed) {
            const auto depths = bed.depths.values();
            return std::accumulate(depths.begin(), depths.end(), 0.0);
        };
        return static_cast<std::size_t>(std::ranges::max_element(made_.beds, {}, water) -
                                        made_.beds.begin());
    }

    void draw_poster(const Snapshot& last) {
        Scene scene = scene_;
        made_.poster_width = 960;
        made_.poster_height = 600;
        scene.view.image.width = made_.poster_width;
        scene.view.image.height = made_.poster_height;
        const auto painter = make_frame_painter(scene, first_, work_.backend, pool_);
        made_.poster = webp(painter->paint(last, {}), poster_quality);
    }

    void find_walls(const Snapshot& snapshot) {
        const WallColours colours = wall_colours(
            scene_, first_, snapshot, surface_of(snapshot, scene_.view), work_.backend, pool_);
        made_.walls = colours.ground;
        made_.water = colours.water;
    }

    const PageRun& run_;
    const WorkOptions& work_;
    Scene scene_;
    Snapshot first_;
    WorkerPool pool_;
    DrawnRun made_;
};

}  // namespace

DrawnRun drawn_run(const PageRun& run, const PageOptions& options, const WorkOptions& work) {
    return RunDrawing(run, options, work).draw(thinned_beds(run.beds.size(), options.beds));
}

}  // namespace fumon
