#include "scene/schedule.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/elementary.h"

namespace fumon {

namespace {

std::vector<std::int64_t> logarithmic_steps(std::int64_t count, std::int64_t last_step) {
    std::vector<std::int64_t> steps{0};
    if (last_step < 1) return steps;
    const double logarithm = elementary::log(static_cast<double>(last_step));
    for (std::int64_t k = 0; k < count; ++k) {
        const double share =
            count == 1 ? 1.0 : static_cast<double>(k) / static_cast<double>(count - 1);
        steps.push_back(std::min(last_step, static_cast<std::int64_t>(std::floor(
                                                elementary::exp(share * logarithm) + 0.5))));
    }
    return steps;
}

}  // namespace

Schedule::Schedule(std::int64_t every, std::vector<std::int64_t> at, std::int64_t last_step)
    : every_(every), at_(std::move(at)), last_step_(last_step) {
    std::sort(at_.begin(), at_.end());
    at_.erase(std::unique(at_.begin(), at_.end()), at_.end());
    std::erase_if(at_, [&](std::int64_t step) { return step > last_step; });
}

bool Schedule::due(std::int64_t step) const {
    if (step < 0 || step > last_step_) return false;
    return (every_ > 0 && step % every_ == 0) || std::binary_search(at_.begin(), at_.end(), step);
}

std::int64_t Schedule::count() const {
    if (every_ <= 0) return static_cast<std::int64_t>(at_.size());
    const auto listed_only = std::count_if(
        at_.begin(), at_.end(), [this](std::int64_t step) { return step % every_ != 0; });
    return last_step_ / every_ + 1 + listed_only;
}

Schedule frame_schedule(const Scene& scene) {
    const FrameSettings& frames = scene.frames;
    const std::int64_t last_step = scene.run.steps;
    if (frames.logarithmic > 0)
        return {0, logarithmic_steps(frames.logarithmic, last_step), last_step};
    if (!frames.at.empty()) return {0, frames.at, last_step};
    const std::int64_t hundredth = std::max<std::int64_t>(1, last_step / 100);
    return {frames.every > 0 ? frames.every : hundredth, {}, last_step};
}

Schedule bed_schedule(const Scene& scene) {
    return {scene.output.bed_every, scene.output.bed_at, scene.run.steps};
}

Schedule fields_schedule(const Scene& scene) {
    return {scene.output.fields_every, scene.output.fields_at, scene.run.steps};
}

Schedule measurement_schedule(const Scene& scene) {
    if (scene.output.measure_every > 0) return {scene.output.measure_every, {}, scene.run.steps};
    return frame_schedule(scene);
}

}  // namespace fumon
