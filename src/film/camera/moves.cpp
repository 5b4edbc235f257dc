#include "film/camera/moves.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

#include "base/elementary.h"
#include "base/error.h"
#include "base/units.h"
#include "film/camera/followed.h"
#include "render/view/framing.h"

namespace fumon {

namespace {

constexpr double half_film_millimetres = 12.0;  // mm
constexpr double key_angle_degrees = 6.0;  // degrees between the poses of a move around something

double chosen(const WordOrReal& value, double otherwise) {
    return value.is_word() ? otherwise : value.value;
}

/// A unit vector from what is looked at to a camera that stands there.
glm::dvec3 towards(double azimuth, double elevation) {
    const double c = elementary::cos(elevation * degree);
    return {elementary::sin(azimuth * degree) * c, elementary::cos(azimuth * degree) * c,
            elementary::sin(elevation * degree)};
}

/// The elevation of a camera before a picture higher than wide: steeper, so that the bed, which
/// just fits across, reaches up and down as well.
double composed(double elevation, double aspect) {
    constexpr double steep = 62.0;             // degrees
    constexpr double tall = 16.0 / 9.0 - 1.0;  // of pictures from which on it is that steep
    const double share = std::clamp((1.0 / aspect - 1.0) / tall, 0.0, 1.0);
    return std::max(elevation, elevation + share * (steep - elevation));
}

/// What the poses of a shot start from.
class ShotPoses {
  public:
    ShotPoses(const Film& film, std::size_t number, const FilmStage& stage, const StoredBeds& beds,
              const BedClock& clock)
        : film_(film),
          number_(number),
          shot_(film.shots[number]),
          stage_(stage),
          beds_(beds),
          clock_(clock),
          first_(beds.snapshot(clock.bed_at(0.0))),
          bed_(*first_) {
        const Shot& shot = shot_;
        const View& view = beds.scene().view;
        azimuth_ = chosen(shot.azimuth, view.camera.azimuth);
        elevation_ =
            composed(chosen(shot.elevation, std::min(view.camera.elevation, 89.0)), stage.aspect);
        subject_ = shot.subject.empty() ? glm::dvec3(0.0, 0.0, stage.block.surface)
                                        : place_on_stage(stage, shot.subject, bed_);
        const double half_angle = 0.5 * view.camera.field_of_view * degree;
        const double usual_lens =
            view.camera.focal_length.is_word()
                ? half_film_millimetres * elementary::cos(half_angle) / elementary::sin(half_angle)
                : view.camera.focal_length.value;
        usual_.focal_length = chosen(shot.focal_length, usual_lens);
        const SunSettings& sun = stage.scene.view.sun;
        usual_.sun_azimuth = chosen(shot.sun_azimuth, sun.azimuth);
        usual_.sun_elevation = chosen(shot.sun_elevation, sun.elevation);
        look_exposure_ = stage.scene.view.look.exposure;
        usual_.exposure = shot.exposure.is_word() ? 0.0 : shot.exposure.value - look_exposure_;
        scenes_own_place(view, beds.first());
    }

    [[nodiscard]] std::vector<CameraPose> make() const {
        switch (shot_.move) {
            case Move::still:
                return {standing()};
            case Move::keys:
                return of_keys();
            case Move::orbit:
                return orbit();
            case Move::push_in:
                return {around(azimuth_, elevation_, distance()),
                        around(azimuth_, elevation_, distance() / 3.0)};
            case Move::crane:
                return crane();
            case Move::fly_over:
                return fly_over();
            case Move::along_crest:
                return along_crest();
            case Move::map_to_perspective:
                return map_to_perspective();
            case Move::morning_to_evening:
                return day();
            case Move::follow_dune:
                return follow_dune();
            case Move::follow_stream:
                return follow_stream();
        }
        return {standing()};
    }

  private:
    /// The place that the scene itself names, unless the shot names another.
    void scenes_own_place(const View& view, const Snapshot& first) {
        const CameraSettings& camera = view.camera;
        const bool named = !camera.at.empty() || camera.framing != Framing::block;
        const bool asked = !shot_.azimuth.is_word() || !shot_.elevation.is_word() ||
                           !shot_.distance.is_word() || !shot_.subject.empty();
        if (!named || asked) return;
        View own = stage_.scene.view;
        own.camera.at = camera.at;
        own.camera.look_at = camera.look_at;
        own.camera.framing = camera.framing;
        const Block block = framed_block(own, first);
        if (!block.eye) return;
        CameraPose pose = usual_;
        pose.eye = *block.eye;
        pose.look_at =
            block.look_at.value_or(*block.eye - towards(camera.azimuth, camera.elevation));
        place_ = pose;
    }

    [[nodiscard]] CameraPose standing() const {
        if (!shot_.keys.empty()) return of_key(shot_.keys.front());
        if (place_) return *place_;
        return around(azimuth_, elevation_, distance());
    }

    [[nodiscard]] CameraPose around(double azimuth, double elevation, double away) const {
        CameraPose pose = usual_;
        pose.look_at = subject_;
        pose.eye = subject_ + away * towards(azimuth, elevation);
        return pose;
    }

    [[nodiscard]] double distance() const {
        const double turn = shot_.move == Move::orbit ? shot_.turn : 0.0;
        double most = 0.0;
        const int looks = 1 + static_cast<int>(std::min(std::abs(turn), 360.0) / key_angle_degrees);
        for (int i = 0; i < looks; ++i) {
            const double turned =
                looks > 1 ? std::copysign(std::min(std::abs(turn), 360.0), turn) * i / (looks - 1)
                          : 0.0;
            most = std::max(most, distance(azimuth_ + turned, elevation_));
        }
        return most;
    }

    /// As near as the whole block stays in the picture, or as the shot says.
    [[nodiscard]] double distance(double azimuth, double elevation) const {
        if (!shot_.distance.is_word()) return shot_.distance.value;
        const glm::dvec3 back = towards(azimuth, elevation);
        const glm::dvec3 right(-elementary::cos(azimuth * degree),
                               elementary::sin(azimuth * degree), 0.0);
        const glm::dvec3 up = glm::cross(back, right);
        const double room = 1.0 - 2.0 * stage_.scene.view.camera.margin;
        const double narrow = room * half_film_millimetres / usual_.focal_length;
        const double half_x = narrow * std::max(1.0, stage_.aspect) * (1.0 + stage_.overrun);
        const double half_y = narrow * std::max(1.0, 1.0 / stage_.aspect);
        double least = 0.05;
        for (const glm::dvec3& corner : block_corners(stage_.block)) {
            const glm::dvec3 from = corner - subject_;
            const double nearer = glm::dot(from, back);
            least = std::max({least, std::abs(glm::dot(from, right)) / half_x + nearer,
                              std::abs(glm::dot(from, up)) / half_y + nearer});
        }
        return least;
    }

    [[nodiscard]] CameraPose of_key(const ShotKey& key) const {
        CameraPose pose = usual_;
        pose.eye = place_on_stage(stage_, key.at, bed_);
        pose.look_at = key.look_at.empty() ? subject_ : place_on_stage(stage_, key.look_at, bed_);
        pose.focal_length = chosen(key.focal_length, usual_.focal_length);
        pose.sun_azimuth = chosen(key.sun_azimuth, usual_.sun_azimuth);
        pose.sun_elevation = chosen(key.sun_elevation, usual_.sun_elevation);
        if (!key.exposure.is_word()) pose.exposure = key.exposure.value - look_exposure_;
        return pose;
    }

    [[nodiscard]] std::vector<CameraPose> of_keys() const {
        std::vector<CameraPose> poses;
        for (const ShotKey& key : shot_.keys) poses.push_back(of_key(key));
        return poses;
    }

    [[nodiscard]] std::vector<CameraPose> orbit() const {
        const int count =
            std::max(2, static_cast<int>(std::abs(shot_.turn) / key_angle_degrees) + 1);
        const double away = distance();
        std::vector<CameraPose> poses;
        for (int i = 0; i <= count; ++i)
            poses.push_back(around(azimuth_ + shot_.turn * i / count, elevation_, away));
        return poses;
    }

    [[nodiscard]] std::vector<CameraPose> crane() const {
        constexpr double low = 5.0;  // degrees
        constexpr double high = 40.0;
        constexpr int count = 8;
        const double top = std::max(composed(high, stage_.aspect), elevation_);
        const double away = distance(azimuth_, top);
        std::vector<CameraPose> poses;
        for (int i = 0; i <= count; ++i)
            poses.push_back(around(azimuth_, low + (top - low) * i / count, away));
        return poses;
    }

    [[nodiscard]] std::vector<CameraPose> fly_over() const {
        const double height = chosen(shot_.distance, 0.07);
        const glm::dvec3 ahead = -towards(azimuth_, 0.0);
        std::vector<CameraPose> poses;
        for (const double place : {-0.45, -0.2, 0.05, 0.3}) {
            CameraPose pose = usual_;
            pose.eye = subject_ + place * ahead + glm::dvec3(0.0, 0.0, height);
            pose.look_at = subject_ + (place + 0.4) * ahead;
            poses.push_back(pose);
        }
        return poses;
    }

    [[nodiscard]] std::vector<CameraPose> along_crest() const {
        View view = stage_.scene.view;
        view.camera.framing = Framing::along_crest;
        const Block seen = framed_block(view, bed_);
        if (!seen.eye || !seen.look_at) return {standing()};
        const auto on_stage = [&](glm::dvec3 point) {
            point.z = stage_.block.z(seen.reference + point.z / seen.height_scale);
            return point;
        };
        CameraPose pose = usual_;
        pose.eye = on_stage(*seen.eye);
        pose.look_at = on_stage(*seen.look_at);
        glm::dvec3 way = 0.7 * (pose.look_at - pose.eye);
        way.z = 0.0;
        CameraPose last = pose;
        last.eye += way;
        last.look_at += way;
        return {pose, last};
    }

    [[nodiscard]] std::vector<CameraPose> map_to_perspective() const {
        constexpr double above = 89.3;  // degrees
        constexpr double north_up = 180.0;
        constexpr int count = 10;
        double turn = azimuth_ - north_up;
        turn -= 360.0 * std::round(turn / 360.0);
        std::vector<CameraPose> poses;
        for (int i = 0; i <= count; ++i) {
            const double share = static_cast<double>(i) / count;
            const double azimuth = north_up + turn * share;
            const double elevation = above + (elevation_ - above) * share;
            const double away =
                (1.0 - share) * distance(north_up, above) + share * distance(azimuth_, elevation_);
            poses.push_back(around(azimuth, elevation, away));
        }
        return poses;
    }

    [[nodiscard]] std::vector<CameraPose> day() const {
        constexpr double low = 6.0;  // degrees of the sun
        constexpr double usual_noon = 50.0;
        constexpr int count = 12;
        const double noon = chosen(shot_.sun_elevation, usual_noon);
        std::vector<CameraPose> poses;
        for (int i = 0; i <= count; ++i) {
            const double share = static_cast<double>(i) / count;
            CameraPose pose = standing();
            pose.sun_azimuth = 90.0 + 180.0 * share;
            pose.sun_elevation = low + (noon - low) * elementary::sin(180.0 * share * degree);
            poses.push_back(pose);
        }
        return poses;
    }

    /// At one height and distance beside the dune, wherever it is.
    [[nodiscard]] std::vector<CameraPose> follow_dune() const {
        constexpr double usual_elevation = 16.0;  // degrees
        constexpr double breadths_away = 4.5;
        const FollowedDune dune = followed_dune(film_, number_, stage_, beds_, clock_);
        const double away = chosen(shot_.distance, std::max(0.06, breadths_away * dune.breadth));
        const double elevation = composed(chosen(shot_.elevation, usual_elevation), stage_.aspect);
        std::vector<CameraPose> poses;
        for (const glm::dvec3& place : dune.places) {
            CameraPose pose = usual_;
            pose.look_at = place;
            pose.eye = place + away * towards(azimuth_, elevation);
            poses.push_back(pose);
        }
        return poses;
    }

    /// Over the stream, with a view of what comes.
    [[nodiscard]] std::vector<CameraPose> follow_stream() const {
        constexpr double usual_height = 0.09;  // block lengths
        constexpr std::size_t ahead = 3;       // places
        const std::vector<glm::dvec3> places = followed_stream(film_, number_, stage_, bed_);
        const double height = chosen(shot_.distance, usual_height);
        std::vector<CameraPose> poses;
        for (std::size_t i = 0; i + ahead < places.size(); ++i) {
            CameraPose pose = usual_;
            pose.eye = places[i] + glm::dvec3(0.0, 0.0, height);
            pose.look_at = places[i + ahead];
            poses.push_back(pose);
        }
        return poses;
    }

    const Film& film_;
    std::size_t number_;
    const Shot& shot_;
    const FilmStage& stage_;
    const StoredBeds& beds_;
    const BedClock& clock_;
    std::shared_ptr<const Snapshot> first_;
    const Snapshot& bed_;
    double azimuth_ = 0.0;
    double elevation_ = 0.0;
    double look_exposure_ = 0.0;
    glm::dvec3 subject_{0.0};
    CameraPose usual_;
    std::optional<CameraPose> place_;
};

/// The least height of the camera over the ground, block lengths.
double clearance_of(const Shot& shot, const FilmStage& stage) {
    // Lengths upward are exaggerated as heights are.
    const double upward = stage.block.exaggeration / stage.block.side;
    if (!shot.clearance.is_word()) return shot.clearance.value * upward;
    double clearance = 0.01;
    for (const ShotKey& key : shot.keys)
        clearance = std::min(clearance, std::max(0.0, key.at[2]) * upward);
    return clearance;
}

CameraPath path_of(const Film& film, std::size_t number, const FilmStage& stage,
                   const FilmRuns& runs, const BedClock& clock) {
    const StoredBeds& beds = runs.first();
    const Shot& shot = film.shots[number];
    const std::vector<CameraPose> poses = poses_of(film, number, stage, beds, clock);
    const auto timing =
        shot.move == Move::follow_dune ? CameraPath::Timing::poses : CameraPath::Timing::distance;
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

std::vector<CameraPose> poses_of(const Film& film, std::size_t shot, const FilmStage& stage,
                                 const StoredBeds& beds, const BedClock& clock) {
    return ShotPoses(film, shot, stage, beds, clock).make();
}

StagedShot::StagedShot(const Film& film, std::size_t shot, const FilmStage& stage,
                       const FilmRuns& runs)
    : clock_(film, shot, runs.first()),
      path_(path_of(film, shot, stage, runs, clock_)),
      // A dune goes its own pace.
      speed_(film.shots[shot].move == Move::follow_dune ? CameraSpeed::constant
                                                        : film.shots[shot].speed) {
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
