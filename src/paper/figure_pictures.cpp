#include "paper/figure_pictures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/worker_pool.h"
#include "figure/panels/hill_shading.h"
#include "figure/panels/map_panel.h"
#include "figure/panels/view_panel.h"
#include "files/netcdf/netcdf_record.h"
#include "files/terrain/esri_ascii.h"
#include "gl/context.h"
#include "paper/figure_picture_data.h"
#include "render/renderer.h"
#include "run/workshop.h"

namespace fumon {

namespace {

/// The look of a panel's picture: that of its scene, with what the panel says.
LookSettings look_of(const PanelSettings& panel, const Scene& scene) {
    LookSettings look = scene.view.look;
    if (panel.palette.empty()) {
        look.palette_reversed = look.palette_reversed != panel.palette_reversed;
    } else {
        look.palette = panel.palette;
        look.palette_reversed = panel.palette_reversed;
    }
    if (!panel.low.is_word()) look.low = panel.low;
    if (!panel.high.is_word()) look.high = panel.high;
    look.mode = ViewMode::figure;
    return look;
}

std::optional<GroundDirection> direction_of(PanelArrow arrow) {
    if (arrow == PanelArrow::wind) return wind_direction();
    if (arrow == PanelArrow::flow) return flow_direction();
    return std::nullopt;
}

/// The colouring that shows a field; nothing where it is none of the renderer's.
std::optional<Colouring> colouring_of(const std::string& field) {
    if (field == "bed") return Colouring::height;
    if (field == "change") return Colouring::change;
    if (field == "water_depth") return Colouring::water_depth;
    return std::nullopt;
}

/// The look that shows a panel's field, where it is one of the renderer's.
std::optional<LookSettings> look_of_field(const PanelSettings& panel, const Scene& scene) {
    const auto colouring = colouring_of(panel.field);
    if (!colouring) return std::nullopt;
    LookSettings look = look_of(panel, scene);
    look.colour_by = *colouring;
    return look;
}

void share_range(std::vector<MapPicture>& pictures) {
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (const MapPicture& picture : pictures) {
        low = std::min(low, picture.colours.low);
        high = std::max(high, picture.colours.high);
    }
    for (MapPicture& picture : pictures) {
        picture.colours.low = low;
        picture.colours.high = high;
    }
}

std::vector<MapPicture> map_pictures_of(const PanelFeed& panel, const Snapshot& first,
                                        const std::vector<Snapshot>& snapshots) {
    const Scene& scene = panel.picture->scene;
    const bool shared = panel.settings.range == PanelRange::shared;
    const auto look = look_of_field(panel.settings, scene);
    if (look && shared) return map_pictures(*look, snapshots, first);
    std::vector<MapPicture> pictures;
    pictures.reserve(snapshots.size());
    for (const Snapshot& snapshot : snapshots) {
        pictures.push_back(
            look ? map_picture(*look, snapshot, first)
                 : field_picture(look_of(panel.settings, scene), snapshot, panel.settings.field));
    }
    if (shared) share_range(pictures);
    return pictures;
}

/// Metres where the snapshot has them, else model heights.
Grid heights_of(const Snapshot& snapshot) {
    Grid heights = snapshot.bed;
    for (double& height : heights.values()) height *= snapshot.scale.height_unit;
    return heights;
}

/// The row that a profile or time-space panel shows; none: the mean over all.
std::optional<int> row_of(const PanelSettings& panel, const Grid& bed) {
    if (!panel.row_of_bed.is_word()) return static_cast<int>(panel.row_of_bed.value);
    if (panel.row_of_bed.word == "mean") return std::nullopt;
    return bed.ny() / 2;
}

}  // namespace

class FigurePictures::Parts {
  public:
    Parts(const FigurePlan& plan, const FigureRuns& runs, const RunStore& store,
          const FigureDrawing& drawing)
        : plan_(plan), runs_(runs), store_(store), drawing_(drawing), pool_(drawing.threads) {}

    std::vector<ShownPicture> make(const PanelFeed& panel, double width) {
        const Workshop workshop = set_up(panel.picture->scene, 1);
        const Snapshot start = workshop.model->snapshot();
        const auto at = [&](std::int64_t step) {
            return read_fields_snapshot(store_.fields(runs_[panel.picture->run]), step, start);
        };
        const Snapshot first = at(0);
        std::vector<Snapshot> snapshots;
        for (const std::int64_t step : panel.picture->steps) snapshots.push_back(at(step));
        std::vector<ShownPicture> made = draw(panel, first, snapshots, width);
        for (std::size_t k = 0; k < made.size(); ++k)
            made[k].title = panel_title(panel.settings, panel.picture->scene, &snapshots[k]);
        return made;
    }

  private:
    std::vector<ShownPicture> draw(const PanelFeed& panel, const Snapshot& first,
                                   const std::vector<Snapshot>& snapshots, double width) {
        switch (panel.settings.kind) {
            case PanelKind::view:
                return views(panel, first, snapshots, width);
            case PanelKind::profile:
                return profile(panel, snapshots);
            case PanelKind::time_space:
                return time_space(panel, snapshots);
            case PanelKind::section:
                return sections(panel, snapshots);
            default:
                return maps(panel, first, snapshots);
        }
    }

    static std::vector<ShownPicture> profile(const PanelFeed& panel,
                                             const std::vector<Snapshot>& snapshots) {
        ProfilePicture picture =
            profile_picture(snapshots, row_of(panel.settings, snapshots.front().bed));
        picture.wind = panel.settings.arrow == PanelArrow::wind;
        std::vector<ShownPicture> made(1);
        made[0].data_end = ".csv";
        made[0].data = profile_csv(picture);
        made[0].content = std::make_unique<ProfilePanel>(std::move(picture));
        return made;
    }

    static std::vector<ShownPicture> time_space(const PanelFeed& panel,
                                                const std::vector<Snapshot>& snapshots) {
        const PanelSettings& settings = panel.settings;
        LookSettings look = look_of(settings, panel.picture->scene);
        look.colour_by = colouring_of(settings.field).value_or(Colouring::height);
        TimeSpacePicture picture =
            time_space_picture(look, snapshots, row_of(settings, snapshots.front().bed));
        std::vector<ShownPicture> made(1);
        made[0].data_end = ".csv";
        made[0].data = time_space_csv(picture);
        made[0].content = std::make_unique<TimeSpacePanel>(
            std::move(picture), settings.colour_bar ? BarPlace::right : BarPlace::none);
        return made;
    }

    static std::vector<ShownPicture> sections(const PanelFeed& panel,
                                              const std::vector<Snapshot>& snapshots) {
        const PanelSettings& settings = panel.settings;
        View view = panel.picture->scene.view;
        view.look = look_of(settings, panel.picture->scene);
        view.section.panels = {settings.section};
        if (!settings.low.is_word()) view.section.low = settings.low;
        if (!settings.high.is_word()) view.section.high = settings.high;
        std::vector<ShownPicture> made;
        for (const Snapshot& snapshot : snapshots) {
            const SectionPanel shown = section_panels(view.section, snapshot).front();
            ShownPicture one;
            one.data_end = ".csv";
            one.data = section_csv(*snapshot.section, shown);
            one.content = make_section_panel(
                view, snapshot, shown, settings.colour_bar ? BarPlace::right : BarPlace::none);
            made.push_back(std::move(one));
        }
        return made;
    }

    std::vector<ShownPicture> maps(const PanelFeed& panel, const Snapshot& first,
                                   const std::vector<Snapshot>& snapshots) {
        const PanelSettings& settings = panel.settings;
        std::vector<MapPicture> pictures = map_pictures_of(panel, first, snapshots);
        if (settings.shading > 0.0) {
            HillShading shading;
            shading.strength = settings.shading;
            shading.from_all_sides = settings.shading_from_all_sides;
            for (std::size_t k = 0; k < pictures.size(); ++k)
                pictures[k].light = hill_light(snapshots[k], shading, pool_);
        }
        const bool shared = settings.range == PanelRange::shared;
        std::vector<ShownPicture> made;
        for (std::size_t k = 0; k < pictures.size(); ++k) {
            MapPicture& picture = pictures[k];
            MapSettings shown;
            shown.axes = settings.axes;
            const bool bar = settings.colour_bar && (!shared || k + 1 == pictures.size());
            shown.colour_bar = bar ? BarPlace::right : BarPlace::none;
            if (k == 0) {
                shown.scale_bar = settings.scale_bar;
                shown.arrow = direction_of(settings.arrow);
            }
            if (settings.vectors) shown.flow = water_flow_of(snapshots[k]);
            ShownPicture one;
            one.data_end = ".asc";
            one.data =
                esri_ascii(picture.values, picture.blank, picture.scale.dx, picture.scale.dy);
            one.content = std::make_unique<MapPanel>(std::move(picture), std::move(shown));
            made.push_back(std::move(one));
        }
        return made;
    }

    std::vector<ShownPicture> views(const PanelFeed& panel, const Snapshot& first,
                                    const std::vector<Snapshot>& snapshots, double width) {
        const PanelSettings& settings = panel.settings;
        const Scene& scene = panel.picture->scene;
        View view = scene.view;
        view.look = look_of(settings, scene);
        if (const auto colouring = colouring_of(settings.field);
            colouring && *colouring != Colouring::height)
            view.look.colour_by = *colouring;
        constexpr double points_per_inch = 72.0;
        const double aspect =
            static_cast<double>(view.image.height) / static_cast<double>(view.image.width);
        const double pixels = plan_.scene.figure.dots_per_inch / points_per_inch * width;
        view.image.width = std::max<std::int64_t>(16, std::llround(pixels));
        view.image.height = std::max<std::int64_t>(16, std::llround(pixels * aspect));
        if (!context_) context_ = gl::Context::create(drawing_.backend);
        Renderer renderer(*context_, view, first, scene.run.steps, pool_);
        std::vector<ShownPicture> made;
        for (const Snapshot& snapshot : snapshots) {
            const double progress = scene.run.steps > 0 ? static_cast<double>(snapshot.step) /
                                                              static_cast<double>(scene.run.steps)
                                                        : 0.0;
            ViewSettings shown;
            shown.scale_bar = settings.scale_bar;
            shown.arrow = direction_of(settings.arrow);
            ShownPicture one;
            one.content =
                std::make_unique<ViewPanel>(view_picture(view, renderer.render(snapshot), first,
                                                         renderer.exaggeration(), progress),
                                            std::move(shown));
            one.data_end = ".asc";
            one.data = esri_ascii(heights_of(snapshot), snapshot.nodata, snapshot.scale.dx,
                                  snapshot.scale.dy);
            made.push_back(std::move(one));
        }
        return made;
    }

    const FigurePlan& plan_;
    const FigureRuns& runs_;
    const RunStore& store_;
    FigureDrawing drawing_;
    WorkerPool pool_;
    std::unique_ptr<gl::Context> context_;
};

FigurePictures::FigurePictures(const FigurePlan& plan, const FigureRuns& runs,
                               const RunStore& store, const FigureDrawing& drawing)
    : parts_(std::make_unique<Parts>(plan, runs, store, drawing)) {}

FigurePictures::~FigurePictures() = default;

std::vector<ShownPicture> FigurePictures::make(const PanelFeed& panel, double width) {
    return parts_->make(panel, width);
}

}  // namespace fumon
