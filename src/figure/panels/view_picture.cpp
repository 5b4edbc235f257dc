#include "figure/panels/view_picture.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <optional>

#include "figure/ground/snapshot_layers.h"
#include "figure/panels/projected_ground.h"
#include "figure/panels/relief_view.h"
#include "render/view/framing.h"
#include "render/view/shown_snapshot.h"

namespace fumon {

namespace {

/// Pixels: columns from left to before right, rows likewise.
struct PixelRectangle {
    int left = 0;
    int right = 0;
    int top = 0;
    int bottom = 0;
};

/// What differs from the first pixel by more than rounding; everything where nothing does.
PixelRectangle content_of(const Image& image) {
    PixelRectangle box{image.width, 0, image.height, 0};
    const std::uint8_t* ground = image.row(0);
    constexpr int rounding = 3;
    for (int y = 0; y < image.height; ++y) {
        const std::uint8_t* pixel = image.row(y);
        for (int x = 0; x < image.width; ++x, pixel += 3) {
            bool differs = false;
            for (int c = 0; c < 3; ++c) differs |= std::abs(pixel[c] - ground[c]) > rounding;
            if (!differs) continue;
            box = {std::min(box.left, x), std::max(box.right, x + 1), std::min(box.top, y), y + 1};
        }
    }
    if (box.right <= box.left) return {0, image.width, 0, image.height};
    return box;
}

Image cut(const Image& image, const PixelRectangle& box) {
    Image part(box.right - box.left, box.bottom - box.top);
    for (int y = 0; y < part.height; ++y)
        std::copy_n(image.row(box.top + y) + std::ptrdiff_t{3} * box.left, 3 * part.width,
                    part.row(y));
    return part;
}

}  // namespace

ViewProjection ViewPicture::in(const CanvasBox& frame) const {
    return {camera,
            block,
            {frame.x + whole.x * frame.width, frame.y + whole.y * frame.height,
             whole.width * frame.width, whole.height * frame.height}};
}

ViewPicture view_picture(const View& view, const Image& image, const Snapshot& first,
                         double exaggeration, double progress) {
    View drawn = view;
    drawn.image.width = image.width;
    drawn.image.height = image.height;
    const std::optional<Snapshot> averaged = shown_snapshot(first, drawn);
    const Snapshot& shown = averaged ? *averaged : first;
    ViewPicture picture;
    picture.block = frame_block(shown, exaggeration, view.look.room, view.look.footing);
    picture.camera = place_camera(view.camera, picture.block,
                                  static_cast<double>(image.width) / image.height, progress);
    picture.in_metres = first.scale.in_metres;
    picture.exaggeration = exaggeration;
    picture.scale = first.scale;
    picture.length_x = first.bed.nx() * first.scale.dx;
    picture.length_y = first.bed.ny() * first.scale.dy;
    const Image on_paper = view.look.relief == FigureRelief::clear
                               ? outlined(image, outline_width(view.image))
                               : composited_on(image, 255);
    const PixelRectangle box = content_of(on_paper);
    picture.image = cut(on_paper, box);
    const double width = picture.image.width;
    const double height = picture.image.height;
    picture.whole = {-box.left / width, -box.top / height, image.width / width,
                     image.height / height};
    return picture;
}

double outline_width(const ImageSettings& image) {
    constexpr double width = 0.5 / 72.0;  // inches
    return std::max(1.0, width * image.dots_per_inch);
}

void add_contours(ViewPicture& picture, const View& view, const WordOrReal& asked,
                  const Snapshot& first, const Snapshot& snapshot) {
    const std::optional<Snapshot> averaged = shown_snapshot(snapshot, view);
    const Snapshot& shown = averaged ? *averaged : snapshot;
    const auto contours = ground_contours(asked, shown);
    if (!contours) return;
    const std::optional<Snapshot> averaged_first = shown_snapshot(first, view);
    ViewProjection projection = picture.in({0.0, 0.0, 1.0, 1.0});
    projection.block =
        block_of_frame(picture.block, view.look, averaged_first ? *averaged_first : first, shown);
    picture.contours = visible_contours(*contours, shown, projection);
    picture.contour_interval = contours->interval;
}

void add_layers(ViewPicture& picture, const View& view, const Snapshot& first,
                const Snapshot& snapshot) {
    if (!view.placed_layers) return;
    const std::optional<Snapshot> averaged = shown_snapshot(snapshot, view);
    const Snapshot& shown = averaged ? *averaged : snapshot;
    const std::optional<Snapshot> averaged_first = shown_snapshot(first, view);
    constexpr CanvasBox square{0.0, 0.0, 1.0, 1.0};
    ViewProjection projection = picture.in(square);
    projection.block =
        block_of_frame(picture.block, view.look, averaged_first ? *averaged_first : first, shown);
    picture.placed_layers = layers_over(view, shown);
    picture.layers = seen_layers(
        {view.layers, *picture.placed_layers, square, picture.length_x, picture.length_y, false},
        ProjectedGround(shown, projection));
    picture.layer_settings = view.layers;
}

}  // namespace fumon
