#include "models/dunes/transport/kernels/drift_vectors.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "vectors/target.h"

namespace fumon {
namespace {

using Wholes = std::vector<std::int64_t>;
using Reals = std::vector<double>;

/// Lengths of rows that end within vectors of every target.
constexpr std::array<std::size_t, 8> odd_lengths{1, 3, 7, 13, 31, 67, 129, 255};

class DriftVectors : public testing::TestWithParam<std::string> {
  protected:
    void SetUp() override { vectors::use_target(GetParam()); }
    void TearDown() override { vectors::use_target(vectors::targets().front()); }

    Wholes wholes(std::size_t count, std::int64_t low, std::int64_t high) {
        std::uniform_int_distribution<std::int64_t> draw(low, high);
        Wholes row(count);
        for (std::int64_t& value : row) value = draw(random_);
        return row;
    }
    Reals reals(std::size_t count, double low, double high) {
        std::uniform_real_distribution<double> draw(low, high);
        Reals row(count);
        for (double& value : row) value = draw(random_);
        return row;
    }
    /// Sand of up to so many units over rock, a third of the cells bare.
    Wholes surface_over(const Wholes& rock, std::int64_t thickest) {
        Wholes surface = wholes(rock.size(), -thickest / 2, thickest);
        for (std::size_t x = 0; x < rock.size(); ++x)
            surface[x] = rock[x] + std::max<std::int64_t>(surface[x], 0);
        return surface;
    }

  private:
    std::mt19937_64 random_{48};
};

constexpr std::int64_t metre = std::int64_t{1} << 32;

TEST_P(DriftVectors, SpreadsAndAddsAsCellByCell) {
    const std::array along{0.21, 0.5, 0.29};
    const std::array across{0.07, 0.8, 0.13};
    for (const std::size_t count : odd_lengths) {
        const Wholes amounts = wholes(count, 0, metre);
        drift_vectors::Pieces pieces;
        drift_vectors::spread(amounts.data(), count, along, across, pieces);
        std::array<Wholes, 3> expected;
        expected.fill(Wholes(count + 2));
        for (std::size_t x = 0; x < count; ++x) {
            std::int64_t rest = amounts[x];
            for (std::size_t j = 0; j < 3; ++j) {
                const double of_row = static_cast<double>(amounts[x]) * across[j];
                for (std::size_t i = 0; i < 3; ++i) {
                    if (i == 1 && j == 1) continue;
                    const auto piece = static_cast<std::int64_t>(of_row * along[i]);
                    expected[j][x + i] += piece;
                    rest -= piece;
                }
            }
            expected[1][x + 1] += rest;
        }
        for (std::size_t j = 0; j < 3; ++j) {
            Wholes to(count + 2);
            const std::size_t first = count / 3;  // as where a row goes on behind the other edge
            drift_vectors::add(pieces, j, 0, first, to.data());
            drift_vectors::add(pieces, j, first, count + 2 - first, to.data() + first);
            EXPECT_EQ(to, expected[j]) << count << " cells, row " << j;
        }
    }
}

TEST_P(DriftVectors, DriftsDownSlopesAsCellByCell) {
    const double share_x = 0.031;
    const double share_y = 0.27;
    for (const std::size_t count : odd_lengths) {
        std::array<Wholes, 3> rock;
        std::array<Wholes, 3> surface;
        for (std::size_t row = 0; row < 3; ++row) {
            rock[row] = wholes(count + 2, -metre, metre);
            surface[row] = surface_over(rock[row], 2 * metre);
        }
        Wholes expected(count + 2);
        for (std::size_t x = 1; x <= count; ++x) {
            const auto got = [&](std::size_t row, std::size_t there, double share) {
                const std::int64_t difference = surface[row][there] - surface[1][x];
                const std::int64_t most = difference > 0
                                              ? (surface[row][there] - rock[row][there]) / 4
                                              : (surface[1][x] - rock[1][x]) / 4;
                const auto wanted =
                    static_cast<std::int64_t>(share * static_cast<double>(std::abs(difference)));
                return difference > 0 ? std::min(wanted, most) : -std::min(wanted, most);
            };
            expected[x] = surface[1][x] + got(1, x - 1, share_x) + got(1, x + 1, share_x) +
                          got(0, x, share_y) + got(2, x, share_y);
        }
        Wholes after(count + 2);
        drift_vectors::drift_down({surface[1].data(), rock[1].data(), surface[0].data(),
                                   rock[0].data(), surface[2].data(), rock[2].data()},
                                  1, count + 1, share_x, share_y, after.data());
        EXPECT_EQ(after, expected) << count << " cells";
    }
}

TEST_P(DriftVectors, LiftsAsCellByCell) {
    const double layer = 0.37 * static_cast<double>(metre);
    const double greatest = 1.9;
    for (const std::size_t count : odd_lengths) {
        for (const bool with_shear : {false, true}) {
            const Wholes rock = wholes(count, -metre, metre);
            Wholes surface = surface_over(rock, metre);
            Wholes moving = wholes(count, 0, metre);
            const Reals shade = reals(count, 0.0, 1.0);
            const Reals shear = reals(count, -1.5, 1.5);  // also beyond both bounds
            Wholes surface_expected = surface;
            Wholes moving_expected = moving;
            for (std::size_t x = 0; x < count; ++x) {
                double factor = 1.0 - shade[x];
                if (with_shear) factor *= std::clamp(1.0 + shear[x], 0.0, greatest);
                const std::int64_t lifted =
                    std::min(static_cast<std::int64_t>(layer * factor), surface[x] - rock[x]);
                surface_expected[x] -= lifted;
                moving_expected[x] += lifted;
            }
            drift_vectors::lift(count, layer, greatest, shade.data(),
                                with_shear ? shear.data() : nullptr, rock.data(), surface.data(),
                                moving.data());
            EXPECT_EQ(surface, surface_expected) << count << " cells";
            EXPECT_EQ(moving, moving_expected) << count << " cells";
        }
    }
}

TEST_P(DriftVectors, DepositsAsCellByCell) {
    const drift_vectors::Staying share{0.1, 0.5, 1.0 / (0.3 * static_cast<double>(metre)), 0.83};
    for (const std::size_t count : odd_lengths) {
        const Wholes rock = wholes(count, -metre, metre);
        Wholes surface = surface_over(rock, metre);
        const Wholes came = wholes(count, 0, metre);
        const Reals shade = reals(count, 0.0, 1.0);
        Wholes moving = wholes(count, 0, metre);
        Wholes landed = wholes(count, 0, metre);
        Wholes surface_expected = surface;
        Wholes moving_expected(count);
        Wholes landed_expected = landed;
        for (std::size_t x = 0; x < count; ++x) {
            const double cover =
                std::min(static_cast<double>(surface[x] - rock[x]) * share.per_full_cover, 1.0);
            const double all =
                std::max(shade[x], share.on_rock + share.more_on_sand * cover) * share.landing;
            const auto stays = static_cast<std::int64_t>(all * static_cast<double>(came[x]));
            surface_expected[x] += stays;
            moving_expected[x] = came[x] - stays;
            landed_expected[x] += came[x];
        }
        Wholes arrived = came;
        drift_vectors::deposit(count, share, shade.data(), rock.data(), arrived.data(),
                               surface.data(), moving.data(), landed.data());
        EXPECT_EQ(surface, surface_expected) << count << " cells";
        EXPECT_EQ(moving, moving_expected) << count << " cells";
        EXPECT_EQ(landed, landed_expected) << count << " cells";
        EXPECT_EQ(arrived, Wholes(count)) << count << " cells";
    }
}

INSTANTIATE_TEST_SUITE_P(Targets, DriftVectors, testing::ValuesIn(vectors::targets()),
                         [](const auto& info) { return info.param; });

}  // namespace
}  // namespace fumon
