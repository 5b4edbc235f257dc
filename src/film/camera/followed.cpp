#include "film/camera/followed.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <functional>
#include <string>

#include "base/elementary.h"
#include "base/error.h"
#include "film/camera/landmarks.h"
#include "measure/bed/dunes.h"
#include "measure/network/flow_routing.h"

namespace fumon {

namespace {

constexpr int shot_sample_count = 240;  // at most, at which the dune is looked for
constexpr int shot_position_count = 25;
constexpr double smoothing_span_share = 0.2;   // of the shot, before and after a place
constexpr double volume_jump_ratio = 1.3;      // from which on it is another piece
constexpr double jump_decay_share = 0.06;      // of the shot, in which a leap fades to 1/e
constexpr double search_reach_breadths = 1.5;  // how far a dune may have gone from bed to bed

[[noreturn]] void refuse(const Film& film, std::size_t shot, const char* key,
                         const std::string& why) {
    const std::string path = fmt::format("shot.{}.{}", shot, key);
    throw InputError(fmt::format("{}{}: {}", film.at(path), path, why));
}

std::vector<Dune> dunes_of(const Snapshot& bed) {
    std::vector<Dune> dunes = separate_dunes(bed.bed, bed.periodic).dunes;
    std::ranges::stable_sort(dunes, std::ranges::greater(), &Dune::volume);
    return dunes;
}

/// The shortest way between two places of a periodic line.
double shortest(double way, double period, bool periodic) {
    return periodic ? way - period * std::floor(way / period + 0.5) : way;
}

/// Follows one dune, in sites that go on past the edges of a periodic bed.
class DuneTracker {
  public:
    DuneTracker(const Dune& dune, const Snapshot& bed)
        : dune_(dune), place_(dune.centre_x, dune.centre_y), periodic_(bed.periodic) {}

    /// False where it is lost. `fading`: of what is left of a leap.
    bool take(const Snapshot& bed, double fading) {
        const std::vector<Dune> dunes = dunes_of(bed);
        const double reach =
            std::max(3.0, search_reach_breadths * std::sqrt(static_cast<double>(dune_.area)));
        const auto offset_to = [&](const Dune& dune) {
            return glm::dvec2(shortest(dune.centre_x - dune_.centre_x, bed.bed.nx(), periodic_),
                              shortest(dune.centre_y - dune_.centre_y, bed.bed.ny(), periodic_));
        };
        const auto nearest = std::ranges::min_element(
            dunes, {}, [&](const Dune& dune) { return glm::length(offset_to(dune)); });
        if (nearest == dunes.end() || glm::length(offset_to(*nearest)) > reach) return false;
        const double ratio = nearest->volume / dune_.volume;
        if (std::max(ratio, 1.0 / ratio) > volume_jump_ratio) jump_ -= offset_to(*nearest);
        place_ += offset_to(*nearest);
        jump_ *= fading;
        dune_ = *nearest;
        return true;
    }

    [[nodiscard]] glm::dvec2 place() const { return place_ + jump_; }
    [[nodiscard]] double height() const { return dune_.height; }

  private:
    Dune dune_;
    glm::dvec2 place_;
    glm::dvec2 jump_{0.0};
    bool periodic_;
};

/// The value at `share` of the line through values at even shares, those nearby counting most.
glm::dvec3 smoothed(const std::vector<glm::dvec3>& values, double share) {
    const double last = std::max(1.0, static_cast<double>(values.size() - 1));
    const double reach = std::max(smoothing_span_share, 1.5 / last);
    double weights = 0.0;
    double first = 0.0;
    double second = 0.0;
    glm::dvec3 sum(0.0);
    glm::dvec3 moment(0.0);
    for (std::size_t i = 0; i < values.size(); ++i) {
        const double from = static_cast<double>(i) / last - share;
        const double near = 1.0 - from * from / (reach * reach);
        if (near <= 0.0) continue;
        const double weight = near * near;
        weights += weight;
        first += weight * from;
        second += weight * from * from;
        sum += weight * values[i];
        moment += weight * from * values[i];
    }
    const double spread = weights * second - first * first;
    if (spread <= 1e-12 * weights * weights) return sum / weights;
    return (second * sum - first * moment) / spread;
}

/// The cells of the stream that drains most, downstream: up from its outlet by the larger of the
/// areas that meet, as far as a hundredth of its area drains there.
std::vector<std::int32_t> main_stream(const FlowRouting& routing) {
    constexpr double least_share = 0.01;
    std::vector<std::int32_t> cells;
    if (routing.upward.empty()) return cells;
    const Grid areas = drainage_area(routing);
    const auto area = [&](std::int32_t cell) {
        return areas.values()[static_cast<std::size_t>(cell)];
    };
    std::vector<std::int32_t> largest(areas.size(), FlowRouting::outlet);  // into each cell
    std::int32_t mouth = routing.upward.front();
    for (const std::int32_t cell : routing.upward) {
        if (area(cell) > area(mouth)) mouth = cell;
        const std::int32_t receiver = routing.receiver.values()[static_cast<std::size_t>(cell)];
        if (receiver == FlowRouting::outlet) continue;
        std::int32_t& donor = largest[static_cast<std::size_t>(receiver)];
        if (donor == FlowRouting::outlet || area(cell) > area(donor)) donor = cell;
    }
    for (std::int32_t cell = mouth;
         cell != FlowRouting::outlet && area(cell) >= least_share * area(mouth);
         cell = largest[static_cast<std::size_t>(cell)])
        cells.push_back(cell);
    std::ranges::reverse(cells);
    return cells;
}

}  // namespace

FollowedDune followed_dune(const Film& film, std::size_t shot, const FilmStage& stage,
                           const StoredBeds& beds, const BedClock& clock) {
    const auto number = static_cast<std::size_t>(film.shots[shot].dune);
    const auto first = beds.snapshot(clock.bed_at(0.0));
    const std::vector<Dune> dunes = dunes_of(*first);
    if (number > dunes.size()) {
        refuse(film, shot, "dune",
               fmt::format("there is no dune number {} at step {}, which has {} isolated dunes",
                           number, first->step, dunes.size()));
    }
    const Dune& dune = dunes[number - 1];
    const bool goes_on = stage.repeats;
    const auto on_stage = [&](const glm::dvec2& sites, double height) {
        const Block& block = stage.block;
        const glm::dvec2 place = stage.copies.ground_position_of(
            {((sites.x + 0.5) / first->bed.nx() - 0.5) * block.width_x,
             ((sites.y + 0.5) / first->bed.ny() - 0.5) * block.width_y});
        return glm::dvec3(place,
                          stage.copies.raised(stage.copies.at(place), block.z(0.5 * height)));
    };
    const int moments = static_cast<int>(
        std::min<std::size_t>(shot_sample_count, clock.latest() - clock.earliest()));
    DuneTracker tracker(dune, *first);
    std::vector<glm::dvec3> places{on_stage(tracker.place(), tracker.height())};
    const double fading = moments > 0 ? elementary::exp(-1.0 / (jump_decay_share * moments)) : 1.0;
    std::size_t shown = clock.bed_at(0.0);
    for (int i = 1; i <= moments; ++i) {
        const std::size_t next = clock.bed_at(static_cast<double>(i) / moments);
        // No bed is left out, so that a dune does not go further than its breadth at once.
        while (shown != next) {
            shown = next > shown ? shown + 1 : shown - 1;
            const auto bed = beds.snapshot(shown);
            if (tracker.take(*bed, shown == next ? fading : 1.0)) continue;
            refuse(
                film, shot, "dune",
                fmt::format("dune {} is lost at step {}; end the shot earlier, or store more beds",
                            number, bed->step));
        }
        places.push_back(on_stage(tracker.place(), tracker.height()));
        const glm::dvec3& at = places.back();
        const bool inside = std::abs(at.x) <= 0.5 * stage.block.width_x &&
                            std::abs(at.y) <= 0.5 * stage.block.width_y;
        if (!inside && !goes_on) {
            refuse(film, shot, "dune",
                   fmt::format("dune {} leaves the block at step {}; end the shot earlier, or draw "
                               "endless ground (look.ground of the run)",
                               number, beds.beds()[shown].step));
        }
    }
    FollowedDune followed;
    followed.breadth =
        std::sqrt(static_cast<double>(dune.area) /
                  static_cast<double>(first->bed.nx() * std::int64_t{first->bed.ny()}) *
                  stage.block.width_x * stage.block.width_y);
    const int count = moments > 0 ? shot_position_count : 1;
    for (int i = 0; i < count; ++i)
        followed.places.push_back(
            smoothed(places, count > 1 ? static_cast<double>(i) / (count - 1) : 0.0));
    return followed;
}

FollowedDune followed_subject(const Film& film, std::size_t shot, const FilmStage& stage,
                              const StoredBeds& beds, const BedClock& clock) {
    const std::string& name = film.shots[shot].subject.word;
    int count = clock.latest() > clock.earliest() ? shot_position_count : 1;
    if (name == "largest dune") {
        try {
            return followed_dune(film, shot, stage, beds, clock);
        } catch (const InputError&) {
            count = 1;  // there is none, or it is lost: the camera stays
        }
    }
    std::vector<glm::dvec3> found;
    FollowedDune followed;
    for (int i = 0; i < count; ++i) {
        const double share = count > 1 ? static_cast<double>(i) / (count - 1) : 1.0;
        const LandmarkOnStage here =
            landmark_on_stage(stage, name, *beds.snapshot(clock.bed_at(share)));
        found.push_back(here.place);
        followed.breadth = std::max(followed.breadth, here.breadth);
    }
    for (int i = 0; i < count; ++i)
        followed.places.push_back(
            smoothed(found, count > 1 ? static_cast<double>(i) / (count - 1) : 0.0));
    return followed;
}

std::vector<glm::dvec3> followed_stream(const Film& film, std::size_t shot, const FilmStage& stage,
                                        const Snapshot& bed) {
    const int nx = bed.bed.nx();
    const Block& block = stage.block;
    std::vector<glm::dvec3> points;
    int turns = 0;  // round a bed whose western and eastern edges are one
    int last_x = 0;
    for (const std::int32_t cell : main_stream(route_flow(bed))) {
        const int x = cell % nx;
        const int y = cell / nx;
        if (!points.empty() && std::abs(x - last_x) > nx / 2) turns += x < last_x ? 1 : -1;
        last_x = x;
        points.emplace_back(((x + 0.5) / nx - 0.5 + turns) * block.width_x,
                            ((y + 0.5) / bed.bed.ny() - 0.5) * block.width_y,
                            block.z(bed.bed(x, y)));
    }
    double length = 0.0;
    for (std::size_t i = 0; i + 1 < points.size(); ++i)
        length += glm::length(points[i + 1] - points[i]);
    constexpr double shortest_stream = 0.1;
    if (length < shortest_stream) {
        refuse(film, shot, "move",
               fmt::format("there is no stream at step {}: the one with the largest catchment has "
                           "only {:.2g} of the length of the bed's longer side",
                           bed.step, length));
    }
    std::vector<glm::dvec3> smooth;
    constexpr int stream_position_count = 13;
    smooth.reserve(stream_position_count);
    for (int i = 0; i < stream_position_count; ++i)
        smooth.push_back(smoothed(points, static_cast<double>(i) / (stream_position_count - 1)));
    return smooth;
}

}  // namespace fumon
