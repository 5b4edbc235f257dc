#include <fmt/format.h>

#include <algorithm>

#include "film/camera/kept_clear.h"
#include "film/camera/moves.h"

namespace fumon {

namespace {

bool goes_with_subject(const Shot& shot) {
    return shot.follow || shot.move == Move::follow_dune;
}

/// The least height of the camera over the ground, block lengths.
double clearance_of(const Shot& shot, const FilmStage& stage) {
    // Lengths upward are exaggerated as heights are.
    const double upward = stage.block.exaggeration / stage.block.side;
    if (!shot.clearance.is_word()) return shot.clearance.value * upward;
    double clearance = 0.01;
    for (const ShotKey& key : shot.keys) {
        if (key.at.empty()) continue;
        clearance = std::min(clearance, std::max(0.0, key.at[2]) * upward);
    }
    return clearance;
}

CameraPath path_of(const Film& film, std::size_t number, const FilmStage& stage,
                   const FilmRuns& runs, const BedClock& clock) {
    const StoredBeds& beds = runs.first();
    const Shot& shot = film.shots[number];
    const std::vector<CameraPose> poses = poses_of(film, number, stage, beds, clock);
    const auto timing =
        goes_with_subject(shot) ? CameraPath::Timing::poses : CameraPath::Timing::distance;
    const double clearance = clearance_of(shot, stage);
    const bool low = std::ranges::any_of(poses, [&](const CameraPose& pose) {
        return pose.eye.z < stage.block.top + 2.0 * clearance;
    });
    if (!low) return CameraPath(poses, {}, timing);
    HighestGround ground(stage);
    for (std::size_t run = 0; run < runs.size(); ++run) {
        const std::size_t first = runs.in_step(run, clock.earliest(), shot.clock);
        const std::size_t last = runs.in_step(run, clock.latest(), shot.clock);
        const std::size_t stride = stride_over(last - first + 1, film);
        for (std::size_t i = first; i < last; i += stride) ground.add(*runs.beds(run).heights(i));
        ground.add(*runs.beds(run).heights(last));
    }
    return CameraPath(
        poses, [&](double x, double y) { return ground.at(x, y) + clearance; }, timing);
}

}  // namespace

StagedShot::StagedShot(const Film& film, std::size_t shot, const FilmStage& stage,
                       const FilmRuns& runs)
    : clock_(film, shot, runs.first()),
      path_(path_of(film, shot, stage, runs, clock_)),
      // What is followed goes its own pace.
      speed_(goes_with_subject(film.shots[shot]) ? CameraSpeed::constant : film.shots[shot].speed) {
    constexpr const char* covered =
        "shot {}: what is written over several pictures covers the ground in one of them; take a "
        "larger film.size, a smaller film.cap_height, fewer overlays, or a longer shot.distance";
    if (fits_block(film.shots[shot]) &&
        (is_covered(stage, path_.at(0.0)) || is_covered(stage, path_.at(1.0))))
        note_ = fmt::format(covered, shot + 1);
    const double upward = stage.block.exaggeration / stage.block.side;
    const double clearance = clearance_of(film.shots[shot], stage);
    if (film.shots[shot].keys.empty() || !(path_.lifted() > clearance)) return;
    note_ = fmt::format(
        "shot {}: the way through its keys (shot.key.at) lies up to {:.3g} below the ground, and "
        "was lifted to shot.clearance, {:.3g} above it",
        shot + 1, (path_.lifted() - clearance) / upward, clearance / upward);
}

CameraPose StagedShot::pose_at(double share) const {
    return path_.at(speed_ == CameraSpeed::eased ? eased(share) : share);
}

}  // namespace fumon
