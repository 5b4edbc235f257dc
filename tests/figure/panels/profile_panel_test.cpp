#include "figure/panels/profile_panel.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "base/error.h"
#include "support/picture_pixels.h"
#include "support/water_beds.h"

namespace fumon {
namespace {

using test::at_step;
using test::Pixel;
using test::pixel_at;

TEST(ProfilePanel, StatesTheExaggerationThatItDraws) {
    Snapshot snapshot = at_step(wavy_bed(80, 3), 5);
    snapshot.scale = {0.5, 0.5, 0.1, true};
    const ProfilePanel panel(profile_picture({&snapshot, 1}, 1));
    Canvas canvas(700, 400, 12.0);
    const CanvasBox frame{100.0, 60.0, 500.0, 250.0};
    panel.draw(canvas, frame);
    const double stated = panel.exaggeration(frame.width, frame.height);
    EXPECT_TRUE(
        std::any_of(canvas.texts().begin(), canvas.texts().end(), [&](const PlacedText& text) {
            return text.text.starts_with("heights × ") &&
                   std::abs(std::stod(text.text.substr(text.text.find("× ") + 3)) - stated) < 1e-9;
        }));
    // The drawn surface: the uppermost sand in the columns of the highest and the lowest cell.
    const Image image = canvas.image();
    const auto surface = [&](int cell) {
        const double x = frame.x + frame.width * (cell + 0.5) / 80.0;
        for (int y = 62; y < 309; ++y)
            if (pixel_at(image, x, y)[2] < 200) return static_cast<double>(y);
        return 0.0;
    };
    const auto row = snapshot.bed.row(1);
    const auto high = std::max_element(row.begin() + 1, row.end() - 1);
    const auto low = std::min_element(row.begin() + 1, row.end() - 1);
    const double drawn = surface(static_cast<int>(low - row.begin())) -
                         surface(static_cast<int>(high - row.begin()));
    const double metre = frame.width / 40.0;  // units along x
    EXPECT_NEAR(drawn, 0.1 * (*high - *low) * metre * stated, 2.5);
    EXPECT_THROW(profile_line(snapshot, 3), InputError);
    EXPECT_THROW(ProfilePanel(ProfilePicture{}), InputError);
}

TEST(ProfilePanel, NothingIsDrawnWhereThereAreNoData) {
    Snapshot snapshot = at_step(wavy_bed(80, 3), 5);
    snapshot.nodata = Mask(80, 3);
    for (int x = 30; x < 50; ++x) snapshot.nodata(x, 1) = 1;
    const ProfilePanel panel(profile_picture({&snapshot, 1}, 1));
    Canvas canvas(700, 400, 12.0);
    const CanvasBox frame{100.0, 60.0, 500.0, 250.0};
    panel.draw(canvas, frame);
    const Image image = canvas.image();
    const auto is_drawn = [&](double cell) {
        for (int y = 63; y < 307; ++y) {
            if (pixel_at(image, frame.x + frame.width * cell / 80.0, y) != Pixel{255, 255, 255})
                return true;
        }
        return false;
    };
    EXPECT_TRUE(is_drawn(29.0));
    EXPECT_TRUE(is_drawn(51.0));
    for (double cell = 30.5; cell < 50.0; cell += 0.5)
        EXPECT_FALSE(is_drawn(cell)) << "cell " << cell;
}

/// How many points the longest open line of an SVG page has.
std::ptrdiff_t points_of_longest_line(const std::string& svg) {
    std::ptrdiff_t most = 0;
    for (std::size_t at = svg.find("<path "); at != std::string::npos;
         at = svg.find("<path ", at + 1)) {
        const std::string path = svg.substr(at, svg.find("/>", at) - at);
        // As Cairo 1.16 writes it, and later versions.
        if (path.find("fill:none") == std::string::npos &&
            path.find("fill=\"none\"") == std::string::npos)
            continue;
        const std::size_t line = path.find(" d=\"");
        const auto letters = std::count_if(path.begin() + static_cast<std::ptrdiff_t>(line),
                                           path.end(), [](char c) { return c == 'M' || c == 'L'; });
        most = std::max(most, letters);
    }
    return most;
}

TEST(ProfilePanel, HasAPointForEachCellThatHasData) {
    Snapshot snapshot = at_step(wavy_bed(80, 3), 5);
    const auto points = [&] {
        Canvas canvas(PageFormat::svg, 700.0, 400.0, 72.0, 12.0);
        ProfilePanel(profile_picture({&snapshot, 1}, 1)).draw(canvas, {100.0, 60.0, 500.0, 250.0});
        return points_of_longest_line(canvas.bytes());
    };
    EXPECT_EQ(points(), 80);
    snapshot.nodata = Mask(80, 3);
    for (int x = 30; x < 50; ++x) snapshot.nodata(x, 1) = 1;
    EXPECT_EQ(points(), 30);
}

}  // namespace
}  // namespace fumon
