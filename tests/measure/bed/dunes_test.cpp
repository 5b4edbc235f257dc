#include "measure/bed/dunes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "measure/bed/dune_components.h"
#include "support/measured_beds.h"

namespace fumon {
namespace {

// ---- pieces ----

/// A bed drawn with '#' for 1; the last string is row 0.
Grid drawn(const std::vector<std::string>& rows) {
    const auto ny = static_cast<int>(rows.size());
    return test::bed_of(static_cast<int>(rows[0].size()), ny, [&](int x, int y) {
        const std::string& row = rows[static_cast<std::size_t>(ny - 1 - y)];
        return row[static_cast<std::size_t>(x)] == '#' ? 1.0 : 0.0;
    });
}

/// What a piece is, however it was found.
struct PlainPiece {
    std::set<std::pair<int, int>> cells;  ///< in the box
    bool wraps = false;

    friend bool operator==(const PlainPiece&, const PlainPiece&) = default;
};

/// A flood that carries unwrapped places along: it wraps where a cell is met at another place.
std::vector<PlainPiece> flooded(const Grid& bed, double level, bool periodic) {
    const int nx = bed.nx();
    const int ny = bed.ny();
    Field<int> seen(nx, ny, 0);
    Field<std::pair<int, int>> place(nx, ny);
    std::vector<PlainPiece> pieces;
    for (int y0 = 0; y0 < ny; ++y0) {
        for (int x0 = 0; x0 < nx; ++x0) {
            if (seen(x0, y0) != 0 || !(bed(x0, y0) > level)) continue;
            PlainPiece piece;
            std::vector<std::pair<int, int>> open = {{x0, y0}};
            seen(x0, y0) = 1;
            place(x0, y0) = {x0, y0};
            while (!open.empty()) {
                const auto [x, y] = open.back();
                open.pop_back();
                piece.cells.emplace((x % nx + nx) % nx, (y % ny + ny) % ny);
                for (int dy = -1; dy <= 1; ++dy) {
                    for (int dx = -1; dx <= 1; ++dx) {
                        const int u = x + dx;
                        const int v = y + dy;
                        if (!periodic && (u < 0 || v < 0 || u >= nx || v >= ny)) continue;
                        const int bx = (u % nx + nx) % nx;
                        const int by = (v % ny + ny) % ny;
                        if (!(bed(bx, by) > level)) continue;
                        if (seen(bx, by) == 0) {
                            seen(bx, by) = 1;
                            place(bx, by) = {u, v};
                            open.emplace_back(u, v);
                        } else if (place(bx, by) != std::pair(u, v)) {
                            piece.wraps = true;
                        }
                    }
                }
            }
            pieces.push_back(piece);
        }
    }
    return pieces;
}

std::vector<PlainPiece> plain(const DuneComponents& found, const Grid& bed) {
    std::vector<PlainPiece> pieces;
    for (const DuneComponent& piece : found.pieces) {
        PlainPiece cells;
        cells.wraps = piece.wraps;
        for (const RowRun& run : found.runs_of(piece)) {
            for (int x = run.first; x <= run.last; ++x) {
                cells.cells.emplace((x % bed.nx() + bed.nx()) % bed.nx(),
                                    (run.y % bed.ny() + bed.ny()) % bed.ny());
            }
        }
        EXPECT_EQ(piece.cells, static_cast<std::int64_t>(cells.cells.size()));
        pieces.push_back(cells);
    }
    return pieces;
}

/// An unwrapped piece hangs together without going round the box.
bool lies_together(std::span<const RowRun> runs) {
    std::set<std::pair<int, int>> cells;
    for (const RowRun& run : runs) {
        for (int x = run.first; x <= run.last; ++x) cells.emplace(x, run.y);
    }
    std::vector<std::pair<int, int>> open = {*cells.begin()};
    cells.erase(cells.begin());
    while (!open.empty()) {
        const auto [x, y] = open.back();
        open.pop_back();
        for (int dy = -1; dy <= 1; ++dy) {
            for (int dx = -1; dx <= 1; ++dx) {
                if (cells.erase({x + dx, y + dy}) > 0) open.emplace_back(x + dx, y + dy);
            }
        }
    }
    return cells.empty();
}

TEST(DuneComponents, AreThoseOfAPlainFlood) {
    int wrapped = 0;
    int apart = 0;
    for (std::uint64_t seed = 1; seed <= 60; ++seed) {
        const Grid bed =
            test::noise(9 + static_cast<int>(seed % 17), 7 + static_cast<int>(seed % 5), seed);
        const double level =
            0.45 + 0.008 * static_cast<double>(seed);  // about percolation and above
        for (const bool periodic : {true, false}) {
            const DuneComponents found = dune_components(bed, level, periodic);
            EXPECT_EQ(plain(found, bed), flooded(bed, level, periodic)) << "seed " << seed;
            for (const DuneComponent& piece : found.pieces) {
                (piece.wraps ? wrapped : apart) += 1;
                EXPECT_TRUE(piece.wraps || lies_together(found.runs_of(piece)));
            }
        }
    }
    EXPECT_GT(wrapped, 20);
    EXPECT_GT(apart, 500);
}

TEST(DuneComponents, OverTheCornerAreOne) {
    const Grid bed = drawn({"#.....#",  //
                            ".......",  //
                            ".......",  //
                            "......#"});
    const DuneComponents found = dune_components(bed, 0.5, true);
    ASSERT_EQ(found.pieces.size(), 1U);
    EXPECT_EQ(found.pieces[0].cells, 3);
    EXPECT_FALSE(found.pieces[0].wraps);
    EXPECT_EQ(dune_components(bed, 0.5, false).pieces.size(), 3U);
}

TEST(DuneComponents, BandsRoundTheBedWrap) {
    EXPECT_TRUE(dune_components(drawn({"....", "####", "...."}), 0.5, true).pieces[0].wraps);
    EXPECT_TRUE(dune_components(drawn({".#..", ".#..", ".#.."}), 0.5, true).pieces[0].wraps);
    EXPECT_TRUE(
        dune_components(drawn({"#...", ".#..", "..#.", "...#"}), 0.5, true).pieces[0].wraps);
    EXPECT_FALSE(dune_components(drawn({"....", "###.", "...."}), 0.5, true).pieces[0].wraps);
    EXPECT_FALSE(dune_components(drawn({"....", "####", "...."}), 0.5, false).pieces[0].wraps);
}

// ---- dunes ----

/// A crescent of height 1, `width` sites across the wind and 6 along it, whose ends lie `lag` sites
/// downwind of its middle, which stands at (x0, y0).
void draw_crescent(Grid& bed, int x0, int y0, int width, double lag) {
    const double half = 0.5 * (width - 1);
    for (int i = 0; i < width; ++i) {
        const double side = (i - half) / half;
        const auto start = static_cast<int>(std::lround(lag * side * side));
        for (int j = -3; j < 3; ++j) {
            const int x = x0 + start + j;
            const int y = y0 + i - (width - 1) / 2;
            bed((x % bed.nx() + bed.nx()) % bed.nx(), (y % bed.ny() + bed.ny()) % bed.ny()) = 1.0;
        }
    }
}

TEST(SeparateDunes, MeasureACrescent) {
    Grid bed(80, 60);
    draw_crescent(bed, 30, 25, 21, 8.0);
    bed(30, 25) = 2.0;
    const DuneField field = separate_dunes(bed, true);
    ASSERT_EQ(field.dunes.size(), 1U);
    const Dune& dune = field.dunes[0];
    EXPECT_EQ(dune.area, 21 * 6);
    EXPECT_DOUBLE_EQ(dune.height, 2.0);
    EXPECT_DOUBLE_EQ(dune.volume, 21 * 6 + 1.0);
    EXPECT_NEAR(dune.centre_y, 25.0, 1e-12);
    EXPECT_NEAR(dune.centre_x, 29.5 + 8.0 * (1.0 + 1.0 / 10.0) / 3.0, 0.2);
    EXPECT_NEAR(dune.horn_lag, 8.0, 0.4);
    EXPECT_DOUBLE_EQ(dune.left_horn, 8.0);
    EXPECT_DOUBLE_EQ(dune.right_horn, 8.0);
    EXPECT_DOUBLE_EQ(field.covered_share, 126.0 / 4800.0);
    EXPECT_DOUBLE_EQ(field.share_horns_downwind, 1.0);
}

TEST(SeparateDunes, TellHornsDownwindFromHornsUpwind) {
    Grid bed(120, 60);
    draw_crescent(bed, 20, 15, 15, 5.0);
    draw_crescent(bed, 70, 40, 25, -9.0);
    draw_crescent(bed, 40, 45, 11, 3.0);
    const DuneField field = separate_dunes(bed, true);
    ASSERT_EQ(field.dunes.size(), 3U);
    EXPECT_NEAR(field.share_horns_downwind, 2.0 / 3.0, 1e-12);
    EXPECT_NEAR(field.mean_horn_lag, (5.0 - 9.0 + 3.0) / 3.0, 0.4);
    EXPECT_NEAR(field.mean_area, 6.0 * (15 + 25 + 11) / 3.0, 1e-9);
    EXPECT_DOUBLE_EQ(field.mean_height, 1.0);
    EXPECT_NEAR(field.mean_volume, field.mean_area, 1e-9);
}

TEST(SeparateDunes, DoNotChangeOverTheCorner) {
    Grid middle(50, 40);
    draw_crescent(middle, 25, 20, 15, 6.0);
    Grid corner(50, 40);
    draw_crescent(corner, 0, 0, 15, 6.0);
    const Dune expected = separate_dunes(middle, true).dunes.at(0);
    const Dune found = separate_dunes(corner, true).dunes.at(0);
    EXPECT_EQ(found.area, expected.area);
    EXPECT_NEAR(found.horn_lag, expected.horn_lag, 1e-12);
    EXPECT_DOUBLE_EQ(found.left_horn, expected.left_horn);
    EXPECT_NEAR(std::fmod(found.centre_x + 25.0, 50.0), expected.centre_x, 1e-9);
    EXPECT_NEAR(std::fmod(found.centre_y + 20.0, 40.0), expected.centre_y, 1e-9);
    EXPECT_GT(separate_dunes(corner, false).dunes.size(), 1U);
}

TEST(SeparateDunes, HornsAreMeasuredOnEitherSide) {
    // A bar whose northern (left) end bends downwind by 4 sites.
    Grid bed(40, 30);
    for (int y = 5; y < 20; ++y) {
        const int bend = std::max(0, y - 15);
        for (int x = 10; x < 15; ++x) bed(x + bend, y) = 1.0;
    }
    const Dune dune = separate_dunes(bed, true).dunes.at(0);
    EXPECT_DOUBLE_EQ(dune.left_horn, 4.0);
    EXPECT_DOUBLE_EQ(dune.right_horn, 0.0);
}

TEST(SeparateDunes, HaveAtLeastTwentyCells) {
    Grid bed(40, 30);
    for (int x = 0; x < 19; ++x) bed(x, 5) = 1.0;
    EXPECT_TRUE(separate_dunes(bed, true).dunes.empty());
    EXPECT_DOUBLE_EQ(separate_dunes(bed, true).covered_share, 19.0 / 1200.0);
    bed(19, 5) = 1.0;
    const DuneField field = separate_dunes(bed, true);
    ASSERT_EQ(field.dunes.size(), 1U);
    EXPECT_TRUE(std::isnan(field.dunes[0].horn_lag));  // one row has no middle and ends
    EXPECT_TRUE(std::isnan(field.share_horns_downwind));
    EXPECT_EQ(separate_dunes(bed, true, {0.3, 21}).dunes.size(), 0U);
}

TEST(SeparateDunes, DoNotWrap) {
    Grid bed(40, 30);
    for (int y = 0; y < 30; ++y) {
        for (int x = 0; x < 5; ++x) bed(x, y) = 1.0;
    }
    EXPECT_TRUE(separate_dunes(bed, true).dunes.empty());
    EXPECT_DOUBLE_EQ(separate_dunes(bed, true).covered_share, 5.0 / 40.0);
    EXPECT_EQ(separate_dunes(bed, false).dunes.size(), 1U);
}

TEST(SeparateDunes, StandAboveThreeTenthsOfTheHighestCell) {
    Grid bed(40, 30);
    for (int y = 5; y < 10; ++y) {
        for (int x = 5; x < 10; ++x) bed(x, y) = 3.0;
    }
    bed(7, 7) = 10.0;
    EXPECT_TRUE(separate_dunes(bed, true).dunes.empty());
    for (int y = 5; y < 10; ++y) bed(5, y) = 3.01;
    EXPECT_DOUBLE_EQ(separate_dunes(bed, true).covered_share, 6.0 / 1200.0);
}

TEST(SeparateDunes, AreNoneOnBareGround) {
    for (const Grid& bed : {Grid(10, 10, 0.0), Grid(10, 10, -1.0), Grid()}) {
        const DuneField field = separate_dunes(bed, true);
        EXPECT_TRUE(field.dunes.empty());
        EXPECT_EQ(field.covered_share, 0.0);
        EXPECT_TRUE(std::isnan(field.mean_area));
    }
}

}  // namespace
}  // namespace fumon
