#include "figure/ground/snapshot_layers.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "base/error.h"
#include "figure/ground/stream_lines.h"

namespace fumon {
namespace {

/// A trough that falls southward, metres: its stream runs along the column `nx / 2`.
Snapshot trough(int nx, int ny) {
    Snapshot snapshot;
    snapshot.bed = Grid(nx, ny);
    snapshot.scale.in_metres = true;
    snapshot.scale.dx = snapshot.scale.dy = 2.0;
    snapshot.scale.height_unit = 1.0;
    for (int y = 0; y < ny; ++y)
        for (int x = 0; x < nx; ++x) snapshot.bed(x, y) = 0.1 * y + 0.5 * std::abs(x - nx / 2);
    return snapshot;
}

LayerSettings asked_for(LayerData data) {
    LayerSettings settings;
    settings.data = data;
    return settings;
}

PlacedLayer over(const LayerSettings& settings, const Snapshot& snapshot) {
    PlacedLayers placed;
    placed.layers.resize(1);
    place_ground_layers(std::span(&settings, 1), snapshot, placed);
    return placed.layers.front();
}

TEST(StreamLines, TheStreamOfATroughRunsAlongItsBottomToTheOutlet) {
    const Snapshot snapshot = trough(21, 30);
    // A row brings its 19 inner cells, 76 m²; those at the edges drain out of the bed.
    const auto streams = stream_lines(snapshot, 70.0);
    ASSERT_EQ(streams.size(), 1U);
    EXPECT_EQ(streams[0].order, 1);
    ASSERT_EQ(streams[0].places.size(), 29U);  // all but the uppermost row
    for (const BedPlace& place : streams[0].places) EXPECT_NEAR(place[0], 10.5 / 21.0, 1e-12);
    EXPECT_NEAR(streams[0].places.front()[1], 28.5 / 30.0, 1e-12);
    EXPECT_NEAR(streams[0].places.back()[1], 0.5 / 30.0, 1e-12);
}

TEST(StreamLines, WhereTwoStreamsMeetOneOfTheNextOrderBegins) {
    const int nx = 41;
    Snapshot snapshot = trough(nx, 40);
    // Two troughs in the northern half, a single one in the southern half.
    for (int y = 0; y < 40; ++y) {
        for (int x = 0; x < nx; ++x) {
            const int apart = y > 19 ? 10 : y / 2;
            snapshot.bed(x, y) =
                0.2 * y + 0.5 * std::min(std::abs(x - 20 + apart), std::abs(x - 20 - apart));
        }
    }
    const auto streams = stream_lines(snapshot, 300.0);
    const auto of_order = [&](int order) {
        return std::ranges::count(streams, order, &StreamLine::order);
    };
    EXPECT_EQ(of_order(1), 2);
    EXPECT_EQ(of_order(2), 1);
    LayerSettings settings = asked_for(LayerData::streams);
    settings.channel_area = 300.0;
    settings.label = "order";
    settings.least_order = 2;
    const PlacedLayer layer = over(settings, snapshot);
    ASSERT_EQ(layer.features.size(), 1U);
    EXPECT_EQ(layer.features[0].label, "2");
    EXPECT_EQ(layer.features[0].width, 1.5);
}

TEST(SnapshotLayers, ContoursLieAtTheirHeightsAndEveryFifthIsThickAndLabelled) {
    Snapshot snapshot = trough(8, 20);
    for (int y = 0; y < 20; ++y)
        for (int x = 0; x < 8; ++x) snapshot.bed(x, y) = 3.0 * (y + 0.5);
    LayerSettings settings = asked_for(LayerData::contours);
    settings.interval = 10.0;
    settings.label = "height";
    const PlacedLayer layer = over(settings, snapshot);
    ASSERT_EQ(layer.features.size(), 5U);  // 10 m to 50 m of 1.5 m to 58.5 m
    for (std::size_t n = 0; n < 5; ++n) {
        const LayerFeature& line = layer.features[n];
        for (const BedPlace& place : line.lines.at(0))
            EXPECT_NEAR(place[1], (static_cast<double>(n) + 1.0) * 10.0 / 60.0, 1e-12);
        EXPECT_EQ(line.label, n == 4 ? "50" : "");
        EXPECT_EQ(line.width, n == 4 ? 1.5 : 1.0);
    }
}

TEST(SnapshotLayers, ABedThatGrowsHasItsContoursThinned) {
    Snapshot snapshot = trough(8, 20);
    LayerSettings settings = asked_for(LayerData::contours);
    settings.interval = 0.001;
    EXPECT_THROW(over(settings, snapshot), InputError);
    PlacedLayers placed;
    placed.layers.resize(1);
    place_ground_layers(std::span(&settings, 1), snapshot, placed, ManyContours::thinned);
    EXPECT_FALSE(placed.layers[0].features.empty());
}

TEST(SnapshotLayers, FollowTheBedAndLeaveOtherLayersAsTheyWerePlaced) {
    View view;
    view.layers = {asked_for(LayerData::contours), asked_for(LayerData::file)};
    EXPECT_EQ(layers_over(view, trough(9, 9)), nullptr);
    auto placed = std::make_shared<PlacedLayers>();
    placed->layers.resize(2);
    placed->layers[1].features.resize(3);
    view.placed_layers = placed;
    const auto low = layers_over(view, trough(9, 9));
    Snapshot higher = trough(9, 9);
    for (double& height : higher.bed.values()) height *= 3.0;
    const auto high = layers_over(view, higher);
    EXPECT_EQ(low->layers[1].features.size(), 3U);
    ASSERT_FALSE(low->layers[0].features.empty());
    EXPECT_NE(low->layers[0].features[0].lines, high->layers[0].features[0].lines);
    view.layers.erase(view.layers.begin());
    EXPECT_EQ(layers_over(view, higher), placed);
}

}  // namespace
}  // namespace fumon
