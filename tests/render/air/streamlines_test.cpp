#include "render/air/streamlines.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "base/error.h"
#include "support/section_beds.h"

namespace fumon {
namespace {

const StreamlineSettings plotted{800.0, 1200.0, 18.0};

double pixels_between(glm::dvec2 a, glm::dvec2 b) {
    return glm::length((a - b) *
                       glm::dvec2(plotted.pixels_per_metre_x, plotted.pixels_per_metre_z));
}

TEST(Streamlines, FollowTheAir) {
    const Snapshot snapshot = eddy_section();
    const SectionAir air(snapshot);
    const SnapshotField& u = *air.find("velocity_x");
    const SnapshotField& w = *air.find("velocity_z");
    const std::vector<Streamline> lines = streamlines(air, plotted);
    ASSERT_GT(lines.size(), 8U);
    for (const Streamline& line : lines) {
        for (std::size_t i = 1; i < line.size(); ++i) {
            const glm::dvec2 middle = 0.5 * (line[i] + line[i - 1]);
            const glm::dvec2 velocity(air.value(u, middle.x, middle.y),
                                      air.value(w, middle.x, middle.y));
            const glm::dvec2 along = glm::normalize(line[i] - line[i - 1]);
            EXPECT_GT(glm::dot(along, glm::normalize(velocity)), 0.99)
                << middle.x << ' ' << middle.y;
        }
    }
}

TEST(Streamlines, StayInTheAirAndInTheSection) {
    const Snapshot snapshot = eddy_section();
    const SectionAir air(snapshot);
    for (const Streamline& line : streamlines(air, plotted)) {
        for (const glm::dvec2 at : line) {
            EXPECT_GT(at.y, air.bed(at.x));
            EXPECT_LE(at.y, air.height());
            EXPECT_GE(at.x, 0.0);
            EXPECT_LE(at.x, air.length());
        }
    }
}

TEST(Streamlines, KeepTheirDistanceAndLeaveNoGaps) {
    const Snapshot snapshot = eddy_section();
    const SectionAir air(snapshot);
    const std::vector<Streamline> lines = streamlines(air, plotted);
    const auto nearest = [&](glm::dvec2 at, const Streamline* without) {
        double least = 1e9;
        for (const Streamline& line : lines) {
            if (&line == without) continue;
            for (const glm::dvec2 position : line)
                least = std::min(least, pixels_between(at, position));
        }
        return least;
    };
    for (const Streamline& line : lines) {
        for (std::size_t i = 0; i < line.size(); i += 5)
            EXPECT_GE(nearest(line[i], &line), 0.5 * plotted.separation - 1e-9);
    }
    for (double x = 0.1; x < 0.9; x += 0.1) {
        for (double z = 0.08; z < 0.28; z += 0.05)
            EXPECT_LT(nearest({x, z}, nullptr), 1.5 * plotted.separation) << x << ' ' << z;
    }
}

TEST(Streamlines, GoRoundAnEddyOnce) {
    const Snapshot snapshot = eddy_section();
    const SectionAir air(snapshot);
    const std::vector<Streamline> lines = streamlines(air, plotted);
    const auto closed = std::find_if(lines.begin(), lines.end(), [](const Streamline& line) {
        return pixels_between(line.front(), line.back()) < plotted.separation;
    });
    ASSERT_NE(closed, lines.end());
    double turned = 0.0;  // radians around the line's own middle
    glm::dvec2 middle(0.0);
    for (const glm::dvec2 at : *closed) middle += at / static_cast<double>(closed->size());
    for (std::size_t i = 1; i < closed->size(); ++i) {
        const glm::dvec2 a = (*closed)[i - 1] - middle;
        const glm::dvec2 b = (*closed)[i] - middle;
        turned += std::atan2(a.x * b.y - a.y * b.x, glm::dot(a, b));
    }
    EXPECT_NEAR(std::abs(turned), 6.28, 1.5);
    EXPECT_NEAR(middle.x, 0.5, 0.1);
}

TEST(Streamlines, AreTheSameAgain) {
    const Snapshot snapshot = eddy_section();
    const SectionAir air(snapshot);
    EXPECT_EQ(streamlines(air, plotted), streamlines(air, plotted));
}

TEST(Streamlines, NeedAVelocityAndAScale) {
    Snapshot snapshot = eddy_section();
    EXPECT_THROW(streamlines(SectionAir(snapshot), {800.0, 1200.0, 0.0}), Error);
    auto still = std::make_shared<SnapshotSection>(*snapshot.section);
    still->fields.pop_back();
    snapshot.section = still;
    EXPECT_TRUE(streamlines(SectionAir(snapshot), plotted).empty());
}

}  // namespace
}  // namespace fumon
