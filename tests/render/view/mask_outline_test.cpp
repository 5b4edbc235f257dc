#include "render/view/mask_outline.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fumon {
namespace {

/// Cells whose centres lie below a line through the middle that rises by an angle have data.
struct Halved {
    explicit Halved(double degrees, int side_) : side(side_), mask(side_, side_, 0) {
        cosine = std::cos(degrees * std::numbers::pi / 180.0);
        sine = std::sin(degrees * std::numbers::pi / 180.0);
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x) mask(x, y) = off({x + 0.5, y + 0.5}) > 0.0 ? 1 : 0;
    }
    /// How far a point lies above the line, cells.
    [[nodiscard]] double off(OutlinePoint at) const {
        return (at.y - 0.5 * side - 0.3) * cosine - (at.x - 0.5 * side) * sine;
    }
    int side;
    Mask mask;
    double cosine;
    double sine;
};

TEST(MaskOutline, AStraightEdgeStaysStraight) {
    for (const double degrees : {7.0, 20.0, 30.0, 37.0, 60.0}) {
        const Halved half(degrees, 80);
        const std::vector<OutlineLoop> outline = mask_outline(half.mask);
        ASSERT_EQ(outline.size(), 1U);
        double farthest = 0.0;
        int points = 0;
        for (const OutlinePoint& at : outline.front()) {
            const bool inner = std::min(at.x, at.y) > 12.0 && std::max(at.x, at.y) < 68.0;
            if (!inner) continue;
            farthest = std::max(farthest, std::abs(half.off(at)));
            ++points;
        }
        EXPECT_GT(points, 40) << degrees;
        EXPECT_LE(farthest, 0.15) << degrees;
    }
}

TEST(MaskOutline, NoCornerMovesByMoreThanHalfACell) {
    Mask mask(40, 40, 1);
    for (int y = 5; y < 35; ++y)
        for (int x = 8; x < 30; ++x) mask(x, y) = 0;
    const std::vector<OutlineLoop> outline = mask_outline(mask);
    ASSERT_EQ(outline.size(), 1U);
    ASSERT_EQ(outline.front().size(), 2U * (22 + 30));
    double low = 40.0;
    double high = 0.0;
    for (const OutlinePoint& at : outline.front()) {
        low = std::min(low, at.x);
        high = std::max(high, at.x);
    }
    EXPECT_GE(low, 8.0);
    EXPECT_LE(low, 8.12);  // the sides stay
    EXPECT_LE(high, 30.0);
    const Mask outside = outside_of(outline, 40, 40, 3);
    const auto inside = std::ranges::count(outside.values(), 0);
    EXPECT_LT(inside, 9 * 22 * 30);
    EXPECT_GT(static_cast<double>(inside), 0.95 * 9 * 22 * 30);  // it is round at its corners
}

TEST(MaskOutline, SmallPartsAndHolesStay) {
    Mask mask(12, 12, 1);
    mask(2, 2) = 0;
    mask(5, 5) = 0;
    mask(6, 6) = 0;  // touches the other one in a corner
    for (int y = 8; y < 11; ++y)
        for (int x = 1; x < 8; ++x) mask(x, y) = 0;
    mask(4, 9) = 1;
    const std::vector<OutlineLoop> outline = mask_outline(mask);
    EXPECT_EQ(outline.size(), 5U);
    EXPECT_EQ(outside_of(outline, 12, 12, 1), mask);
}

TEST(MaskOutline, TheNearestPointOnItIsFound) {
    Mask mask(60, 60, 1);
    for (int y = 4; y < 56; ++y)
        for (int x = 4; x < 56; ++x) mask(x, y) = 0;
    const std::vector<OutlineLoop> outline = mask_outline(mask);
    const OutlineSearch search(outline, 60, 60);
    const OutlinePoint at = search.nearest({30.2, 4.9}, 2.0);
    EXPECT_NEAR(at.x, 30.2, 0.01);
    EXPECT_NEAR(at.y, 4.0, 0.05);
    const OutlinePoint far{30.0, 30.0};
    EXPECT_EQ(search.nearest(far, 2.0), far);
}

}  // namespace
}  // namespace fumon
