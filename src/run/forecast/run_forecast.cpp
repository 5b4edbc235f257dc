#include "run/forecast/run_forecast.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "base/elementary.h"
#include "base/elementary_power.h"
#include "base/error.h"
#include "base/stopwatch.h"
#include "files/netcdf/netcdf_layout.h"
#include "models/shared/model.h"
#include "run/terminal/progress.h"
#include "scene/schedule.h"

namespace fumon {

namespace {

constexpr double steady_power = 1.15;  // below it, steps are as long as one another
constexpr double largest_power = 1.35;

/// The power of the number of steps with which their seconds grow: over the second half of them.
double power_of(const std::vector<double>& after) {
    const std::size_t half = after.size() / 2;
    if (half == 0) return 1.0;
    const double grown = after.back() / after[half - 1];
    const double more = static_cast<double>(after.size()) / static_cast<double>(half);
    const double power = elementary::log(grown) / elementary::log(more);
    return power > steady_power ? std::min(power, largest_power) : 1.0;
}

std::string size_text(std::int64_t bytes) {
    constexpr double mega = 1e6;
    constexpr double giga = 1e9;
    const auto size = static_cast<double>(bytes);
    return size < giga ? fmt::format("{:.0f} MB", std::ceil(size / mega))
                       : fmt::format("{:.1f} GB", size / giga);
}

}  // namespace

double forecast_seconds(const std::vector<double>& after, std::int64_t steps) {
    const auto tried = static_cast<double>(after.size());
    const auto all = static_cast<double>(steps);
    const double power = power_of(after);
    if (power > 1.0) return after.back() * elementary::pow(all / tried, power);
    const std::size_t half = after.size() / 2;  // the first steps fetch memory
    if (half == 0) return after.back() * all;
    const double a_step = (after.back() - after[half - 1]) / (tried - static_cast<double>(half));
    return after.back() + a_step * (all - tried);
}

std::optional<RunForecast> forecast_run(const PreparedRun& run, double most_seconds) {
    constexpr std::size_t few = 8;
    constexpr double share_of_steady = 0.2;
    const Scene& scene = run.scene;
    RunForecast forecast;
    forecast.threads = run.pool->size();
    const Snapshot first = run.model->snapshot();
    const std::int64_t records = fields_schedule(scene).count();
    if (records > 0) forecast.fields_bytes = header_room(first, {}) + records * record_room(first);
    if (scene.output.frames) {
        constexpr std::int64_t bytes_a_pixel = 3;
        forecast.frames_bytes = frame_schedule(scene).count() * bytes_a_pixel *
                                scene.view.image.width * scene.view.image.height;
    }
    std::vector<double> after;
    const Stopwatch watch;
    try {
        while (std::cmp_less(after.size(), scene.run.steps) && watch.seconds() < most_seconds) {
            run.model->step();
            after.push_back(watch.seconds());
            const bool soon = after.back() > share_of_steady * most_seconds;
            if (soon && after.size() >= few && power_of(after) == 1.0) break;
        }
    } catch (const Error&) {
        return std::nullopt;
    }
    if (!after.empty()) forecast.seconds = forecast_seconds(after, scene.run.steps);
    forecast.steps_tried = static_cast<std::int64_t>(after.size());
    return forecast;
}

std::string forecast_text(const RunForecast& forecast) {
    constexpr double soon = 2.0;                // s
    constexpr std::int64_t small = 20'000'000;  // bytes
    std::string text;
    const auto add = [&](const std::string& part) { text += (text.empty() ? "" : ", ") + part; };
    if (forecast.seconds >= soon) {
        add(fmt::format("about {} in steps on {} {}", clock_text(forecast.seconds),
                        forecast.threads, forecast.threads == 1 ? "thread" : "threads"));
    }
    if (forecast.fields_bytes >= small)
        add(fmt::format("at most {} of fields", size_text(forecast.fields_bytes)));
    if (!text.empty() && forecast.frames_bytes >= small)
        add(fmt::format("at most {} of frames", size_text(forecast.frames_bytes)));
    return text;
}

}  // namespace fumon
