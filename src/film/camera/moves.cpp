#include "film/camera/moves.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

#include "base/elementary.h"
#include "base/error.h"
#include "base/units.h"
#include "film/camera/camera_distance.h"
#include "film/camera/followed.h"
#include "film/camera/kept_clear.h"
#include "film/camera/landmarks.h"
#include "render/view/framing.h"

namespace fumon {

namespace {

constexpr double half_film_millimetres = 12.0;  // mm
constexpr double key_angle_degrees = 6.0;  // degrees between the poses of a move around something

double chosen(const WordOrReal& value, double otherwise) {
    return value.is_word() ? otherwise : value.value;
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
        const CameraSettings& camera = stage.scene.view.camera;
        azimuth_ = chosen(shot.azimuth, camera.azimuth);
        asked_elevation_ = chosen(shot.elevation, std::min(camera.elevation, 89.0));
        elevation_ = composed(asked_elevation_, stage.aspect);
        breadth_ = 0.25 * std::min(stage.block.width_x, stage.block.width_y);
        subject_ = place_of(shot.subject, {0.0, 0.0, stage.block.surface}, breadth_);
        const double half_angle = 0.5 * camera.field_of_view * degree;
        const double usual_lens =
            camera.focal_length.is_word()
                ? half_film_millimetres * elementary::cos(half_angle) / elementary::sin(half_angle)
                : camera.focal_length.value;
        usual_.focal_length = chosen(shot.focal_length, usual_lens);
        const SunSettings& sun = stage.scene.view.sun;
        usual_.sun_azimuth = chosen(shot.sun_azimuth, sun.azimuth);
        usual_.sun_elevation = chosen(shot.sun_elevation, sun.elevation);
        look_exposure_ = stage.scene.view.look.exposure;
        usual_.exposure = shot.exposure.is_word() ? 0.0 : shot.exposure.value - look_exposure_;
        scenes_own_place(view, beds.first());
    }

    [[nodiscard]] std::vector<CameraPose> make() const {
        if (shot_.follow) {
            const FollowedDune subject = followed_subject(film_, number_, stage_, beds_, clock_);
            if (subject.places.size() > 1) return beside(subject);
        }
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

    /// Whether all of the block is seen from all poses.
    [[nodiscard]] bool fit() const {
        const bool stands = shot_.move == Move::still || shot_.move == Move::morning_to_evening;
        return fits_block(shot_) && !(stands && place_);
    }

  private:
    /// What a camera looks at, `otherwise` where none is named, and how broad it is, where it has a
    /// name.
    [[nodiscard]] glm::dvec3 place_of(const ViewTarget& place, const glm::dvec3& otherwise,
                                      double& breadth) const {
        if (place.word.empty() && place.at.empty()) return otherwise;
        if (place.word.empty()) return place_on_stage(stage_, place.at, bed_);
        if (place.word == "middle") return {0.0, 0.0, stage_.block.surface};
        const LandmarkOnStage found =
            landmark_on_stage(stage_, place.word, *beds_.snapshot(clock_.bed_at(1.0)));
        breadth = found.breadth;
        return found.place;
    }

    /// As the move stands to its subject, wherever that is.
    [[nodiscard]] std::vector<CameraPose> beside(const FollowedDune& subject) const {
        const auto last = static_cast<double>(subject.places.size() - 1);
        const double away =
            distance(shot_.distance, subject.places.front(), subject.breadth, azimuth_, elevation_);
        std::vector<CameraPose> poses;
        for (std::size_t i = 0; i < subject.places.size(); ++i) {
            const double share = static_cast<double>(i) / last;
            const double turned = shot_.move == Move::orbit ? shot_.turn * share : 0.0;
            const double nearer = shot_.move == Move::push_in ? 1.0 - 2.0 / 3.0 * share : 1.0;
            CameraPose pose = usual_;
            pose.look_at = subject.places[i];
            pose.eye = pose.look_at + away * nearer * towards(azimuth_ + turned, elevation_);
            poses.push_back(pose);
        }
        return poses;
    }

    /// The place that the scene itself names, unless the shot names another.
    void scenes_own_place(const View& view, const Snapshot& first) {
        const CameraSettings& camera = view.camera;
        const bool named = !camera.at.empty() || camera.framing != Framing::block;
        const bool asked = !shot_.azimuth.is_word() || !shot_.elevation.is_word() ||
                           shot_.distance.word != "fit" || shot_.subject.is_named();
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
        const bool fills = shot_.distance.word == "fill";
        double chosen_distance = 0.0;
        const int looks = 1 + static_cast<int>(std::min(std::abs(turn), 360.0) / key_angle_degrees);
        for (int i = 0; i < looks; ++i) {
            const double turned =
                looks > 1 ? std::copysign(std::min(std::abs(turn), 360.0), turn) * i / (looks - 1)
                          : 0.0;
            const double here = distance(azimuth_ + turned, elevation_);
            const bool first = i == 0;
            chosen_distance = first   ? here
                              : fills ? std::min(chosen_distance, here)
                                      : std::max(chosen_distance, here);
        }
        return chosen_distance;
    }

    /// As near as the shot says of what is looked at from there.
    [[nodiscard]] double distance(double azimuth, double elevation) const {
        return distance(shot_.distance, subject_, breadth_, azimuth, elevation);
    }

    [[nodiscard]] double distance(const WordOrReal& asked, const glm::dvec3& subject,
                                  double breadth, double azimuth, double elevation) const {
        if (!asked.is_word()) return asked.value;
        if (asked.word == "near") return near_distance(breadth, usual_.focal_length);
        if (asked.word == "fit")
            return fit_distance(stage_, subject, azimuth, elevation, usual_.focal_length);
        CameraPose pose = usual_;
        pose.look_at = subject;
        return fill_distance(stage_, bed_, pose, azimuth, elevation);
    }

    [[nodiscard]] CameraPose of_key(const ShotKey& key) const {
        CameraPose pose = usual_;
        double breadth = breadth_;
        pose.look_at = place_of(key.look_at, subject_, breadth);
        if (key.at.empty()) {
            const double azimuth = chosen(key.azimuth, azimuth_);
            const double elevation =
                composed(chosen(key.elevation, asked_elevation_), stage_.aspect);
            const WordOrReal& asked = key.distance.word == "shot" ? shot_.distance : key.distance;
            pose.eye = pose.look_at + distance(asked, pose.look_at, breadth, azimuth, elevation) *
                                          towards(azimuth, elevation);
        } else {
            pose.eye = place_on_stage(stage_, key.at, bed_);
        }
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
    double asked_elevation_ = 0.0;  ///< of a picture as wide as high
    double elevation_ = 0.0;
    double breadth_ = 0.0;  ///< of the subject, block lengths
    double look_exposure_ = 0.0;
    glm::dvec3 subject_{0.0};
    CameraPose usual_;
    std::optional<CameraPose> place_;
};

}  // namespace

bool fits_block(const Shot& shot) {
    if (shot.follow || shot.distance.word != "fit") return false;
    switch (shot.move) {
        case Move::still:
        case Move::morning_to_evening:
            return shot.keys.empty();
        case Move::orbit:
        case Move::crane:
        case Move::map_to_perspective:
            return true;
        default:
            return false;
    }
}

std::vector<CameraPose> poses_of(const Film& film, std::size_t shot, const FilmStage& stage,
                                 const StoredBeds& beds, const BedClock& clock) {
    const ShotPoses poses(film, shot, stage, beds, clock);
    return poses.fit() ? clear_poses(stage, poses.make()) : poses.make();
}

}  // namespace fumon
