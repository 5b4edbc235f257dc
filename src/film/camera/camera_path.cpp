#include "film/camera/camera_path.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "base/elementary.h"

namespace fumon {

namespace {

constexpr int samples_per_path = 6000;  // about as many as a minute has frames, three times over
constexpr int lift_margin_samples = samples_per_path / 12;  // before and after what lifts the way
constexpr std::size_t numbers_per_pose = 10;

/// All numbers of a pose, the focal length as its logarithm.
using PoseNumbers = std::array<double, numbers_per_pose>;

PoseNumbers numbers_of(const CameraPose& pose) {
    return {pose.eye.x,
            pose.eye.y,
            pose.eye.z,
            pose.look_at.x,
            pose.look_at.y,
            pose.look_at.z,
            elementary::log(pose.focal_length),
            pose.sun_azimuth,
            pose.sun_elevation,
            pose.exposure};
}

CameraPose pose_of(const PoseNumbers& n) {
    return {{n[0], n[1], n[2]}, {n[3], n[4], n[5]}, elementary::exp(n[6]), n[7], n[8], n[9]};
}

PoseNumbers mixed(const PoseNumbers& a, const PoseNumbers& b, double share) {
    PoseNumbers mix{};
    for (std::size_t i = 0; i < numbers_per_pose; ++i)
        mix.at(i) = (1.0 - share) * a.at(i) + share * b.at(i);
    return mix;
}

/// Distance by which knots are set and the pace is kept.
double path_distance(const CameraPose& a, const CameraPose& b) {
    const double eye = glm::length(b.eye - a.eye);
    return eye > 1e-9 ? eye : glm::length(b.look_at - a.look_at);
}

/// Barry and Goldman's pyramid over four points with their knots, at a knot between the second and
/// the third.
PoseNumbers between(const std::array<PoseNumbers, 4>& points, const std::array<double, 4>& knots,
                    double at) {
    const auto level = [&](const PoseNumbers& a, const PoseNumbers& b, std::size_t i,
                           std::size_t j) {
        return mixed(a, b, (at - knots.at(i)) / (knots.at(j) - knots.at(i)));
    };
    const PoseNumbers a = level(points[0], points[1], 0, 1);
    const PoseNumbers b = level(points[1], points[2], 1, 2);
    const PoseNumbers c = level(points[2], points[3], 2, 3);
    return level(level(a, b, 0, 2), level(b, c, 1, 3), 1, 2);
}

/// The spline at evenly spaced shares between its poses.
std::vector<CameraPose> sampled(const std::vector<CameraPose>& poses) {
    const std::size_t spans = poses.size() - 1;
    std::vector<PoseNumbers> points;
    points.reserve(poses.size() + 2);
    for (const CameraPose& pose : poses) points.push_back(numbers_of(pose));
    // Ends are mirrored, so that the spline begins and ends in its first and last pose.
    const auto mirrored = [](const PoseNumbers& end, const PoseNumbers& next) {
        return mixed(end, next, -1.0);
    };
    points.insert(points.begin(), mirrored(points[0], points[1]));
    points.push_back(mirrored(points[spans + 1], points[spans]));
    std::vector<double> knots{0.0};
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        const double way = path_distance(pose_of(points[i]), pose_of(points[i + 1]));
        knots.push_back(knots.back() + std::max(std::sqrt(way), 1e-3));
    }
    std::vector<CameraPose> samples;
    const auto in_a_span = static_cast<std::size_t>(samples_per_path) / spans + 1;
    for (std::size_t span = 0; span < spans; ++span) {
        const std::array<PoseNumbers, 4> four{points[span], points[span + 1], points[span + 2],
                                              points[span + 3]};
        const std::array<double, 4> at{knots[span], knots[span + 1], knots[span + 2],
                                       knots[span + 3]};
        for (std::size_t i = 0; i < in_a_span; ++i) {
            const double share = static_cast<double>(i) / static_cast<double>(in_a_span);
            samples.push_back(pose_of(between(four, at, (1.0 - share) * at[1] + share * at[2])));
        }
    }
    samples.push_back(poses.back());
    return samples;
}

/// Lifts what lies below the floor: by the largest lift nearby, averaged over the same stretch, so
/// that it is never less than what is needed. Returns the largest lift that is.
double lift(std::vector<CameraPose>& samples, const CameraPath::Floor& floor) {
    const auto count = static_cast<int>(samples.size());
    std::vector<double> needed;
    needed.reserve(samples.size());
    bool any = false;
    for (const CameraPose& pose : samples) {
        needed.push_back(std::max(0.0, floor(pose.eye.x, pose.eye.y) - pose.eye.z));
        any = any || needed.back() > 0.0;
    }
    if (!any) return 0.0;
    const auto clamped = [count](int i) {
        return static_cast<std::size_t>(std::clamp(i, 0, count - 1));
    };
    std::vector<double> largest(samples.size());
    for (int i = 0; i < count; ++i) {
        double most = 0.0;
        for (int j = i - 2 * lift_margin_samples; j <= i + 2 * lift_margin_samples; ++j)
            most = std::max(most, needed[clamped(j)]);
        largest[clamped(i)] = most;
    }
    for (int pass = 0; pass < 2; ++pass) {  // twice: no kinks
        std::vector<double> mean(samples.size());
        double sum = 0.0;
        for (int j = -lift_margin_samples; j <= lift_margin_samples; ++j)
            sum += largest[clamped(j)];
        for (int i = 0; i < count; ++i) {
            mean[clamped(i)] = sum / (2 * lift_margin_samples + 1);
            sum += largest[clamped(i + 1 + lift_margin_samples)] -
                   largest[clamped(i - lift_margin_samples)];
        }
        largest = std::move(mean);
    }
    for (int i = 0; i < count; ++i)
        samples[clamped(i)].eye.z += std::max(largest[clamped(i)], needed[clamped(i)]);
    return *std::ranges::max_element(needed);
}

}  // namespace

CameraPath::CameraPath(const std::vector<CameraPose>& poses, const Floor& floor, Timing timing)
    : timing_(timing) {
    samples_ = poses.size() > 1 ? sampled(poses) : poses;
    if (floor) lifted_ = lift(samples_, floor);
    distances_.push_back(0.0);
    for (std::size_t i = 0; i + 1 < samples_.size(); ++i) {
        length_ += glm::length(samples_[i + 1].eye - samples_[i].eye);
        distances_.push_back(distances_.back() + path_distance(samples_[i], samples_[i + 1]));
    }
}

CameraPose CameraPath::at(double share) const {
    const double clamped = std::clamp(share, 0.0, 1.0);
    if (samples_.size() == 1) return samples_.front();
    const auto last = static_cast<double>(samples_.size() - 1);
    double place = clamped * last;  // where neither the eye nor what it looks at moves
    if (timing_ == Timing::distance && distances_.back() > 1e-6) {
        const double wanted = clamped * distances_.back();
        const auto after = std::ranges::upper_bound(distances_, wanted);
        const auto next = std::clamp<std::size_t>(
            static_cast<std::size_t>(after - distances_.begin()), 1, distances_.size() - 1);
        const double step = distances_[next] - distances_[next - 1];
        place = static_cast<double>(next - 1) +
                (step > 0.0 ? std::min(1.0, (wanted - distances_[next - 1]) / step) : 0.0);
    }
    const auto before = std::min(static_cast<std::size_t>(place), samples_.size() - 2);
    return pose_of(mixed(numbers_of(samples_[before]), numbers_of(samples_[before + 1]),
                         place - static_cast<double>(before)));
}

double eased(double share) {
    const double u = std::clamp(share, 0.0, 1.0);
    return u * u * (3.0 - 2.0 * u);
}

}  // namespace fumon
