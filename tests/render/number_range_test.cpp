// The numbers for which pictures are made (base/limits.h): at their ends every kind of picture is
// drawn, beyond them it is refused with the place, and never a crash.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "base/error.h"
#include "base/limits.h"
#include "base/snapshots/ground_range.h"
#include "base/worker_pool.h"
#include "gl/context.h"
#include "render/renderer.h"
#include "support/drawn_picture.h"
#include "support/view_beds.h"

namespace fumon::number_range {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

/// A way to draw a bed: what lies around it, and how it is seen.
struct WayToDraw {
    std::string name;
    View view;
    bool periodic = false;
};

std::vector<WayToDraw> ways() {
    std::vector<WayToDraw> all;
    const auto add = [&](const std::string& name, Ground ground, Projection projection,
                         ViewMode mode, bool periodic) {
        View view = small_view(16, 16);
        view.image.supersampling = 1;
        view.look.ground = ground;
        view.camera.projection = projection;
        view.look.mode = mode;
        all.push_back({name, view, periodic});
    };
    for (const bool periodic : {false, true}) {
        const std::string bed = periodic ? ", periodic" : ", alone";
        add("endless" + bed, Ground::endless, Projection::perspective, ViewMode::scenic, periodic);
        add("table" + bed, Ground::table, Projection::perspective, ViewMode::scenic, periodic);
    }
    add("orthographic", Ground::table, Projection::orthographic, ViewMode::scenic, false);
    add("map", Ground::table, Projection::map, ViewMode::figure, false);
    add("figure", Ground::table, Projection::perspective, ViewMode::figure, false);
    return all;
}

Snapshot bed_of(double height, double cell, bool in_metres, bool periodic) {
    Snapshot snapshot;
    snapshot.bed = Grid(8, 6);
    snapshot.bed(3, 2) = height;
    snapshot.bed(6, 4) = -height;
    snapshot.scale = {cell, cell, 1.0, in_metres};
    snapshot.periodic = periodic;
    return snapshot;
}

TEST(NumberRange, PicturesAreMadeUpToItsEnds) {
    const auto context = gl::Context::create(gl::Backend::automatic);
    WorkerPool pool(1);
    for (const WayToDraw& way : ways()) {
        for (const double cell : {smallest_cell_size, largest_cell_size}) {
            const Snapshot bed = bed_of(largest_height, cell, true, way.periodic);
            View view = way.view;
            view.look.exaggeration = {"", 1e4};
            if (view.camera.projection == Projection::perspective && cell < 1.0) {
                view.camera.at = {largest_coordinate, -largest_coordinate, largest_coordinate};
                view.camera.look_at = {-largest_coordinate, 0.0, 0.0};
            }
            Renderer renderer(*context, view, bed, 1, pool);
            EXPECT_EQ(renderer.render(bed).rgb.size(), 768U) << way.name << " cells " << cell;
        }
    }
}

TEST(NumberRange, PicturesAreMadeOfWaterUpToItsEnds) {
    const auto context = gl::Context::create(gl::Backend::automatic);
    WorkerPool pool(1);
    for (const WayToDraw& way : ways()) {
        if (way.view.look.ground == Ground::endless) continue;  // which has no water
        for (const double depth : {smallest_cell_size, largest_height, largest_field_value}) {
            Snapshot wet = bed_of(1.0, 1.0, true, way.periodic);
            for (const char* name : {"water_depth", "velocity_x", "velocity_y"})
                wet.fields.push_back({name, "", "", Grid(8, 6, 0.5)});
            wet.fields[0].values(3, 3) = depth;
            wet.fields[1].values(4, 3) = depth;
            wet.fields[2].values(4, 4) = -depth;
            Renderer renderer(*context, way.view, wet, 1, pool);
            EXPECT_EQ(renderer.render(wet).rgb.size(), 768U) << way.name << " depth " << depth;
        }
    }
}

TEST(NumberRange, BeyondThemNothingIsDrawn) {
    const auto context = gl::Context::create(gl::Backend::automatic);
    WorkerPool pool(1);
    for (const WayToDraw& way : ways()) {
        const Snapshot good = bed_of(1.0, 1.0, true, way.periodic);
        Renderer renderer(*context, way.view, good, 1, pool);
        for (const double height : {std::nextafter(largest_height, infinite), 1e300, -1.797e308,
                                    infinite, -infinite, not_a_number}) {
            Snapshot bad = good;
            bad.bed(5, 1) = height;
            const auto refusal = [&](const auto& draw) -> std::string {
                try {
                    draw();
                } catch (const Error& fault) {
                    return fault.what();
                }
                return "drawn";
            };
            const std::string first =
                refusal([&] { Renderer(*context, way.view, bad, 1, pool).render(bad); });
            EXPECT_NE(first.find("the height of cell (5, 1) is "), std::string::npos)
                << way.name << " " << height << ": " << first;
            EXPECT_EQ(refusal([&] { renderer.render(bad); }), first) << "a later one";
        }
        EXPECT_EQ(renderer.render(good).rgb.size(), 768U) << "it goes on";
    }
}

TEST(NumberRange, OfScalesTimesAndFields) {
    const Snapshot good = bed_of(1.0, 1.0, true, false);
    EXPECT_EQ(beyond_ground(good), "");
    const auto fault = [&](const auto& change) {
        Snapshot bad = good;
        change(bad);
        return beyond_ground(bad);
    };
    EXPECT_EQ(fault([](Snapshot& bad) { bad.scale.dx = 1e-7; }),
              "cells are 1e-07 m wide; a cell has 1e-06 to 1e+07");
    EXPECT_EQ(fault([](Snapshot& bad) { bad.scale.height_unit = 0.0; }),
              "a model height is 0 m; it has 1e-09 to 1e+07 m");
    EXPECT_EQ(fault([](Snapshot& bad) { bad.scale.height_unit = 1e7; }),
              "the height of cell (3, 2) is 10000000 m; heights go to ±1e+06 m");
    EXPECT_EQ(fault([](Snapshot& bad) {
                  bad.time = not_a_number;
                  bad.time_unit = "s";
              }),
              "the time is nan s; it goes to 1e+15");
    EXPECT_EQ(fault([](Snapshot& bad) {
                  bad.fields.push_back({"depth", "", "m", Grid(8, 6)});
                  bad.fields.back().values(7, 5) = -infinite;
              }),
              "depth of cell (7, 5) is -inf; it has values up to ±1e+30");
    Grid large(5000, 1);
    large(4999, 0) = 2.0;
    EXPECT_EQ(first_beyond(large, 1.0), 4999U);
    EXPECT_EQ(first_beyond(large, 2.0), 5000U);
}

}  // namespace
}  // namespace fumon::number_range
