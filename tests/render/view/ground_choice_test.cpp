#include "render/view/ground_choice.h"

#include <gtest/gtest.h>

#include "base/error.h"

namespace fumon {
namespace {

Snapshot periodic_bed() {
    Snapshot bed;
    bed.bed = Grid(8, 6, 1.0);
    bed.periodic = true;
    return bed;
}

Ground chosen(const View& view, const Snapshot& bed) {
    return with_chosen_ground(view, bed).look.ground;
}

TEST(GroundChoice, GoesOnForSandInPerspective) {
    EXPECT_EQ(chosen({}, periodic_bed()), Ground::endless);
    Snapshot land = periodic_bed();
    land.periodic = false;
    EXPECT_EQ(chosen({}, land), Ground::table);
    Snapshot profile = periodic_bed();
    profile.bed = Grid(8, 1, 1.0);
    EXPECT_EQ(chosen({}, profile), Ground::table);
    View map;
    map.camera.projection = Projection::map;
    EXPECT_EQ(chosen(map, periodic_bed()), Ground::table);
    View figure;
    figure.look.mode = ViewMode::figure;
    EXPECT_EQ(chosen(figure, periodic_bed()), Ground::table);
}

TEST(GroundChoice, IsWhatASceneAsksFor) {
    View view;
    view.look.ground = Ground::table;
    EXPECT_EQ(chosen(view, periodic_bed()), Ground::table);
    view.look.ground = Ground::endless;
    EXPECT_EQ(chosen(view, periodic_bed()), Ground::endless);
    Snapshot land = periodic_bed();
    land.periodic = false;
    EXPECT_EQ(chosen(view, land), Ground::endless) << "in a plain";
    Snapshot wet = periodic_bed();
    for (const char* name : {"water_depth", "velocity_x", "velocity_y"})
        wet.fields.push_back({name, "", "", Grid(8, 6)});
    EXPECT_EQ(chosen(view, wet), Ground::endless);
    EXPECT_EQ(chosen({}, wet), Ground::table) << "water is drawn on a block if nobody asks";
    Snapshot profile = periodic_bed();
    profile.bed = Grid(8, 1, 1.0);
    EXPECT_THROW(chosen(view, profile), InputError);
}

TEST(GroundChoice, RefusesACoverWhereThereIsNoLand) {
    View view;
    view.look.cover = LandCover::automatic;
    EXPECT_THROW(with_chosen_ground(view, periodic_bed()), KeyError) << "sand";
    Snapshot land = periodic_bed();
    land.landform = Landform::terrain;
    EXPECT_NO_THROW(with_chosen_ground(view, land));
    view.look.cover = LandCover::bare;
    view.look.snow_line = 100.0;
    EXPECT_THROW(with_chosen_ground(view, land), KeyError) << "snow without a cover";
}

TEST(GroundChoice, RefusesASeaWhereItHasNoShore) {
    View view;
    view.look.sea_level = 0.5;
    Snapshot land = periodic_bed();
    land.scale.in_metres = true;
    EXPECT_THROW(with_chosen_ground(view, land), KeyError) << "no edge";
    land.periodic = false;
    EXPECT_NO_THROW(with_chosen_ground(view, land));
    Snapshot in_sites = land;
    in_sites.scale.in_metres = false;
    EXPECT_THROW(with_chosen_ground(view, in_sites), KeyError);
    land.bed = Grid(8, 1, 1.0);
    EXPECT_THROW(with_chosen_ground(view, land), KeyError) << "a profile";
}

}  // namespace
}  // namespace fumon
