#include "measure/suite.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace fumon {
namespace {

Snapshot bed_of(int nx, int ny, std::int64_t step = 0, double shift = 0.0) {
    Snapshot snapshot;
    snapshot.step = step;
    snapshot.periodic = true;
    snapshot.bed = Grid(nx, ny);
    for (int y = 0; y < ny; ++y) {
        for (int x = 0; x < nx; ++x)
            snapshot.bed(x, y) = 2.0 + std::sin(6.283185307179586 * (x - shift) / 10.0);
    }
    return snapshot;
}

double value_of(const MeasureSuite& suite, const std::vector<double>& row,
                const std::string& name) {
    for (std::size_t k = 0; k < row.size(); ++k) {
        if (suite.columns()[k].name == name) return row[k];
    }
    ADD_FAILURE() << "there is no column " << name;
    return 0.0;
}

TEST(MeasureSuite, EveryRowHasAValueForEveryColumnAndNamesAreDistinct) {
    for (const Landform landform : {Landform::bed, Landform::profile, Landform::pile}) {
        MeasureSuite suite(landform);
        std::set<std::string> names;
        for (const MeasureColumn& column : suite.columns()) {
            EXPECT_TRUE(names.insert(column.name).second) << column.name;
            EXPECT_FALSE(column.help.empty()) << column.name;
        }
        EXPECT_EQ(suite.row(bed_of(40, landform == Landform::profile ? 1 : 20)).size(),
                  names.size());
        Snapshot masked = bed_of(40, 20);
        masked.nodata = Mask(40, 20);
        masked.nodata(3, 3) = 1;
        EXPECT_EQ(suite.row(masked).size(), names.size());
    }
}

TEST(MeasureSuite, CelerityIsSinceTheRowBefore) {
    MeasureSuite suite(Landform::bed);
    EXPECT_TRUE(std::isnan(value_of(suite, suite.row(bed_of(40, 20)), "celerity")));
    EXPECT_NEAR(value_of(suite, suite.row(bed_of(40, 20, 10, 2.0)), "celerity"), 0.2, 0.005);
    EXPECT_NEAR(value_of(suite, suite.row(bed_of(40, 20, 14, 1.0)), "celerity"), -0.25, 0.005);
}

TEST(MeasureSuite, AvalanchesCountWhetherOrNotTheirStepIsMeasured) {
    MeasureSuite suite(Landform::pile);
    const std::vector<Avalanche> first{{1, 12, 2, 3, 0}, {2, 40, 3, 5, 1}};
    const std::vector<Avalanche> second{{3, 7, 1, 1, 0}};
    suite.note(first);
    suite.note({});
    suite.note(second);
    const auto row = suite.row(bed_of(9, 9));
    EXPECT_EQ(value_of(suite, row, "avalanches"), 3.0);
    EXPECT_EQ(value_of(suite, row, "last_avalanche_size"), 7.0);
    EXPECT_EQ(value_of(suite, row, "largest_avalanche_size"), 40.0);
}

TEST(MeasureSuite, LandformsAreToldApart) {
    EXPECT_EQ(landform_of(bed_of(10, 10)), Landform::bed);
    EXPECT_EQ(landform_of(bed_of(10, 1)), Landform::profile);
    Snapshot pile = bed_of(10, 1);
    pile.numbers.push_back({"dropped_grains", "grains", 4.0});
    EXPECT_EQ(landform_of(pile), Landform::pile);
}

TEST(MeasureSuite, MetresTakeThePlaceOfSitesAndHeights) {
    const WorldScale scale{2.0, 3.0, 0.5, true};
    const auto metres = [&](const char* unit) {
        const MeasuredValue found = in_world_units({{"some", unit, ""}, 8.0}, scale);
        return std::pair(found.value, found.column.unit);
    };
    using Found = std::pair<double, std::string>;
    EXPECT_EQ(metres("sites"), Found(16.0, "m"));
    EXPECT_EQ(metres("heights"), Found(4.0, "m"));
    EXPECT_EQ(metres("cells"), Found(48.0, "m2"));
    EXPECT_EQ(metres("heights x cells"), Found(24.0, "m3"));
    EXPECT_EQ(metres("heights/site"), Found(2.0, ""));
    EXPECT_EQ(metres("sites/step"), Found(16.0, "m/step"));
    EXPECT_EQ(metres("degrees"), Found(8.0, "degrees"));
    const MeasuredValue sites = in_world_units({{"some", "sites", ""}, 8.0}, {});
    EXPECT_EQ(sites.value, 8.0);
    EXPECT_EQ(sites.column.unit, "sites");
}

}  // namespace
}  // namespace fumon
