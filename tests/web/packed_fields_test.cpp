#include "web/packed_fields.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "web/page_run.h"
#include "web/page_surface.h"

namespace fumon::test {
namespace {

constexpr int nx = 40;
constexpr int ny = 30;

/// A wave that wanders, and an unevenness of each cell that stays.
std::vector<Field<float>> waves(double unevenness) {
    std::vector<Field<float>> fields;
    for (int bed = 0; bed < 4; ++bed) {
        Field<float> field(nx, ny);
        std::uint32_t state = 7;
        for (int y = 0; y < ny; ++y) {
            for (int x = 0; x < nx; ++x) {
                state = 1664525U * state + 1013904223U;
                const double random = static_cast<double>(state >> 8U) / (1U << 24U);
                field(x, y) = static_cast<float>(-3.0 + std::sin(0.3 * x + 0.2 * bed) +
                                                 0.2 * std::cos(0.4 * y) + unevenness * random);
            }
        }
        fields.push_back(field);
    }
    return fields;
}

double worst_difference(const std::vector<Field<float>>& one,
                        const std::vector<Field<float>>& other) {
    double worst = 0.0;
    for (std::size_t bed = 0; bed < one.size(); ++bed) {
        for (std::size_t i = 0; i < one[bed].size(); ++i)
            worst = std::max(worst, std::abs(static_cast<double>(one[bed].values()[i]) -
                                             static_cast<double>(other[bed].values()[i])));
    }
    return worst;
}

TEST(PackedFields, ComeBackWithinHalfAStep) {
    for (const double unevenness : {0.0, 0.5}) {
        const std::vector<Field<float>> fields = waves(unevenness);
        const PackedFields packed = packed_fields(fields, 10.0);
        ASSERT_EQ(packed.fields.size(), fields.size());
        EXPECT_LT(packed.step, 3.0 / 65535.0);
        EXPECT_LE(worst_difference(fields, unpacked_fields(packed, nx, ny)),
                  0.5 * packed.step + 1e-6);
    }
}

TEST(PackedFields, TakeWhatIsShortest) {
    const PackedFields smooth = packed_fields(waves(0.0), 10.0);
    EXPECT_EQ(smooth.fields[0].predictor, 1);
    const PackedFields rough = packed_fields(waves(0.5), 10.0);
    EXPECT_FALSE(rough.fields[0].over_previous);
    EXPECT_TRUE(rough.fields[1].over_previous);
    EXPECT_LT(rough.fields[1].bytes.size(), rough.fields[0].bytes.size());
}

TEST(PackedFields, RoundMoreWhereTheyWouldTakeTooMuch) {
    const std::vector<Field<float>> fields = waves(0.5);
    const PackedFields fine = packed_fields(fields, 10.0);
    const PackedFields coarse = packed_fields(fields, 0.1);
    EXPECT_NEAR(coarse.step / fine.step, 65535.0 / 4095.0, 1e-9);
    EXPECT_LE(worst_difference(fields, unpacked_fields(coarse, nx, ny)), 0.51 * coarse.step);
}

TEST(PackedFields, OfAFlatBedAreNothing) {
    const std::vector<Field<float>> fields{Field<float>(nx, ny, 2.5F)};
    const PackedFields packed = packed_fields(fields, 10.0);
    EXPECT_LT(packed.fields[0].bytes.size(), 40U);
    EXPECT_EQ(worst_difference(fields, unpacked_fields(packed, nx, ny)), 0.0);
}

TEST(PageSurface, MeansLeaveOutCellsWithoutData) {
    Grid bed(5, 4, 1.0);
    bed(1, 0) = 4.0;
    Mask nodata(5, 4);
    nodata(0, 0) = 1;
    nodata(1, 1) = 1;
    nodata(4, 0) = 1;
    const Field<float> means = coarse_field(bed, nodata, 2, 0.5, 2.0);
    EXPECT_EQ(means.nx(), 3);
    EXPECT_EQ(means.ny(), 2);
    EXPECT_FLOAT_EQ(means(0, 0), 4.5F);
    EXPECT_FLOAT_EQ(means(1, 1), 1.5F);
    const Mask mask = coarse_mask(nodata, 5, 4, 2);
    EXPECT_EQ(mask(0, 0), 1);
    EXPECT_EQ(mask(1, 0), 0);
    EXPECT_EQ(mask(2, 0), 1);
    EXPECT_TRUE(coarse_mask(nodata, 5, 4, 4).empty());
    EXPECT_EQ(cells_per_point(Grid(500, 500), 500'000), 1);
    EXPECT_EQ(cells_per_point(Grid(512, 512), 500'000), 2);
}

TEST(PageSurface, PixelsBesideABedTakeTheNearestColour) {
    Image image(5, 1);
    image.rgb = {9, 9, 9, 1, 2, 3, 9, 9, 9, 9, 9, 9, 4, 5, 6};
    image.alpha = {0, 255, 128, 0, 255};
    fill_beside(image);
    EXPECT_EQ(image.rgb, (std::vector<std::uint8_t>{1, 2, 3, 1, 2, 3, 1, 2, 3, 4, 5, 6, 4, 5, 6}));
    EXPECT_FALSE(image.transparent());
}

TEST(PageSurface, OuterSidesRunAroundHolesToo) {
    Mask nodata(3, 3);
    EXPECT_EQ(outer_sides(3, 3, {}).size(), 12U);
    nodata(1, 1) = 1;
    EXPECT_EQ(outer_sides(3, 3, nodata).size(), 16U);
}

TEST(PageRun, ThinsItsBedsEvenlyWithBothEnds) {
    EXPECT_EQ(thinned_beds(4, 10), (std::vector<std::size_t>{0, 1, 2, 3}));
    EXPECT_EQ(thinned_beds(11, 6), (std::vector<std::size_t>{0, 2, 4, 6, 8, 10}));
    EXPECT_EQ(thinned_beds(10, 4), (std::vector<std::size_t>{0, 3, 6, 9}));
    EXPECT_EQ(thinned_beds(9, 1), (std::vector<std::size_t>{8}));
    EXPECT_EQ(thinned_beds(1, 5), (std::vector<std::size_t>{0}));
}

}  // namespace
}  // namespace fumon::test
