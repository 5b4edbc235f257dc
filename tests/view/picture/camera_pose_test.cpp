#include "view/picture/camera_pose.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <memory>
#include <string>

#include "support/viewed_run.h"
#include "view/picture/look_changes.h"

namespace fumon {
namespace {

TEST(CameraPlace, SettingsPutTheCameraWhereItIsWanted) {
    for (const char* view : {"", "[look]\nexaggeration = 3\n", "[look]\nground = \"endless\"\n"}) {
        const auto subject = viewed_subject(view);
        const LookChanges changes(subject->scene(), subject->first(), false);
        const Snapshot& first = subject->first();
        const CameraPlace wanted{{-10.0, -25.0, 30.0}, {25.0, 12.0, 1.0}};
        const Scene placed = changes.with(settings_of(wanted, subject->scene(), first, first));
        const CameraFacts got = camera_facts(placed, first, first);
        for (std::size_t i = 0; i < 3; ++i) {
            EXPECT_NEAR(got.place.eye.at(i), wanted.eye.at(i), 0.02) << view << i;
            EXPECT_NEAR(got.place.target.at(i), wanted.target.at(i), 0.02) << view << i;
        }
    }
}

TEST(CameraPlace, IsThatOfTheFittedCamera) {
    const auto subject = viewed_subject("[camera]\nazimuth = 130\nelevation = 41\n");
    const CameraFacts facts = camera_facts(subject->scene(), subject->first(), subject->first());
    EXPECT_NEAR(facts.azimuth, 130.0, 1e-9);
    EXPECT_NEAR(facts.elevation, 41.0, 1e-9);
    EXPECT_EQ(facts.side, 40.0);
    const double east = facts.place.eye[0] - facts.place.target[0];
    const double north = facts.place.eye[1] - facts.place.target[1];
    EXPECT_NEAR(std::atan2(east, north) * 180.0 / 3.141592653589793, 130.0, 1e-6);
}

}  // namespace
}  // namespace fumon
