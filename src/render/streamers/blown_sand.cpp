#include "render/streamers/blown_sand.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>

#include "base/elementary.h"
#include "base/error.h"
#include "base/units.h"
#include "numerics/percentile.h"
#include "render/streamers/smoothstep.h"
#include "render/view/bilinear_height.h"
#include "render/view/ground_choice.h"

namespace fumon {

namespace {

constexpr double metres_per_cell = 0.4;  // of beds without metres
constexpr double heights_per_plume = 2.0;
constexpr double shortest_plume = 3.0;  // metres
constexpr double longest_plume = 30.0;
constexpr float full_shadow = 0.1763F;  // tan 10°
constexpr float no_shadow = 0.2679F;    // tan 15°
constexpr double least_leaving = 0.02;  // of the flux over level ground

/// The wind of the snapshot's step where it tells one; else the prevailing one.
HorizontalDirection blowing_way(const Snapshot& snapshot) {
    const auto from = number_of(snapshot, "wind_from");
    if (!from) return prevailing_direction(snapshot);
    return {-elementary::sin(*from * degree), -elementary::cos(*from * degree)};
}

/// How high dunes stand over the ground between them, model heights.
double relief_of(const Grid& bed) {
    std::vector<double> heights(bed.values().begin(), bed.values().end());
    const double high = percentile(heights, 0.99);
    return high - percentile(heights, 0.02);
}

/// A bed's cells as places.
class Cells {
  public:
    Cells(const Block& block, int nx, int ny) : size_(block.width_x / nx, block.width_y / ny) {}

    [[nodiscard]] glm::dvec2 size() const { return size_; }
    [[nodiscard]] glm::dvec2 middle(int x, int y) const { return size_ * (glm::dvec2(x, y) + 0.5); }

  private:
    glm::dvec2 size_;
};

/// Looks from places over the bed towards the sun.
class SunOverBed {
  public:
    SunOverBed(const BlownSand& sand, const Block& block, const SunDirection& sun)
        : sand_(sand),
          extent_(block.width_x, block.width_y),
          step_(block.width_x / sand.z.nx()),
          highest_(*std::max_element(sand.z.values().begin(), sand.z.values().end())),
          to_sun_(static_cast<double>(sun.east), static_cast<double>(sun.north)),
          lower_(static_cast<double>(sun.lower_limb)),
          upper_(static_cast<double>(sun.upper_limb)) {}

    [[nodiscard]] float share(const glm::dvec2& position, double z) const {
        double seen = 1.0;
        double away = step_;
        const auto top = static_cast<double>(highest_);
        for (double step = step_; z + away * lower_ < top && seen > 0.0; step *= 1.1) {
            const glm::dvec2 at = (position + away * to_sun_) / extent_;
            const bool beside =
                !sand_.repeats && (at.x < 0.0 || at.y < 0.0 || at.x > 1.0 || at.y > 1.0);
            if (beside) break;
            const double rise =
                (static_cast<double>(bilinear_height(sand_.z, at, sand_.repeats)) - z) / away;
            seen = std::min(seen, (upper_ - rise) / (upper_ - lower_));
            away += step;
        }
        return static_cast<float>(std::max(seen, 0.0));
    }

  private:
    const BlownSand& sand_;
    glm::dvec2 extent_;
    double step_;
    float highest_;
    glm::dvec2 to_sun_;
    double lower_;
    double upper_;
};

void find_brinks(BlownSand& sand, const Grid& flux, const Field<float>& reached, const Block& block,
                 const SunOverBed& light) {
    const int nx = flux.nx();
    const int ny = flux.ny();
    const Cells cells(block, nx, ny);
    const glm::dvec2 way(sand.way.x, sand.way.y);
    const double on = 1.0 / std::max(std::abs(way.x) / cells.size().x,
                                     std::abs(way.y) / cells.size().y);  // a cell downwind
    const glm::dvec2 extent(block.width_x, block.width_y);
    for (int y = 0; y < ny; ++y) {
        for (int x = 0; x < nx; ++x) {
            const glm::dvec2 here = cells.middle(x, y);
            const glm::dvec2 next = here + on * way;
            const bool beyond =
                next.x < 0.0 || next.y < 0.0 || next.x > extent.x || next.y > extent.y;
            if (beyond && !sand.repeats) continue;
            const double behind =
                static_cast<double>(bilinear_height(reached, next / extent, sand.repeats));
            const double leaving = flux(x, y) * (static_cast<double>(reached(x, y)) - behind);
            if (leaving < least_leaving) continue;
            Brink brink;
            brink.position = here + 0.5 * on * way;
            brink.z = static_cast<double>(sand.z(x, y));
            brink.flux = leaving;
            brink.id = static_cast<std::uint32_t>(y * nx + x);
            for (int part = 0; part < 3; ++part) {
                const double gone = 0.4 * part;
                const double sunk = 0.04 - 0.25 * gone * gone;
                brink.sun[part] = light.share(brink.position + gone * sand.length * way,
                                              brink.z + sunk * sand.length);
            }
            sand.brinks.push_back(brink);
        }
    }
}

}  // namespace

void check_streamers(const View& view, const Snapshot& first) {
    if (view.streamers.strength == 0.0) return;
    const std::string key = "streamers.strength";
    const auto refuse = [&](const std::string& why) {
        throw KeyError(key, "streamers show sand driven by a model's wind, " + why);
    };
    if (!first.saltation_flux)
        refuse("and this model has no such wind; take one of sand or dunes, or leave them out");
    if (first.bed.ny() < 2) refuse("and are for beds of more than one row");
    if (!is_endless(view, first))
        refuse("and are drawn over endless ground; look.ground = \"endless\" makes it so");
}

BlownSand blown_sand(const Snapshot& snapshot, const View& view, const Block& block,
                     const SunDirection& sun) {
    const int nx = snapshot.bed.nx();
    const int ny = snapshot.bed.ny();
    const Cells cells(block, nx, ny);
    const StreamerSettings& asked = view.streamers;
    BlownSand sand;
    sand.way = blowing_way(snapshot);
    sand.repeats = snapshot.periodic;
    const double cell = std::min(cells.size().x, cells.size().y);
    sand.metre = snapshot.scale.in_metres ? 1.0 / block.side : cell / metres_per_cell;
    sand.width = std::abs(sand.way.x) * cells.size().y + std::abs(sand.way.y) * cells.size().x;
    const double asked_unit = 1.0 / block.side;
    sand.length = asked.length.is_word()
                      ? std::clamp(heights_per_plume * relief_of(snapshot.bed) * block.height_scale,
                                   shortest_plume * sand.metre, longest_plume * sand.metre)
                      : asked.length.value * asked_unit;
    sand.travel = asked.travel * asked_unit;
    sand.z = Field<float>(nx, ny);
    std::ranges::transform(snapshot.bed.values(), sand.z.values().begin(),
                           [&](double height) { return static_cast<float>(block.z(height)); });

    const Grid flux = snapshot.saltation_flux(snapshot);
    const SunDirection upwind{static_cast<float>(-sand.way.x), static_cast<float>(-sand.way.y),
                              full_shadow, no_shadow};
    const LatticeBorder border = sand.repeats ? LatticeBorder::periodic : LatticeBorder::open;
    const auto dx = static_cast<float>(cells.size().x);
    const auto dy = static_cast<float>(cells.size().y);
    const Field<float> reached = sun_visibility(sand.z, dx, dy, upwind, {}, border);
    sand.sun = sun_visibility(sand.z, dx, dy, sun, {}, border);
    sand.open = Field<float>(nx, ny);
    for (std::size_t i = 0; i < flux.size(); ++i) {
        const double there = flux.values()[i];
        sand.open.values()[i] = static_cast<float>(there * smoothstep(0.5, 1.0, there) *
                                                   static_cast<double>(reached.values()[i]));
    }
    find_brinks(sand, flux, reached, block, SunOverBed(sand, block, sun));
    return sand;
}

}  // namespace fumon
