#include "figure/layers/seen_layers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include "base/elementary_angle.h"

namespace fumon {

namespace {

/// A part of a line over the bed.
struct GroundPart {
    std::vector<BedPlace> places;
    bool hidden = false;
};

class LayerSight {
  public:
    LayerSight(const LayersAsked& asked, const GroundSight& sight, const LayerSettings& settings)
        : asked_(asked),
          sight_(sight),
          settings_(settings),
          near_(grown(asked.frame, 0.1 * std::max(asked.frame.width, asked.frame.height))) {}

    [[nodiscard]] SeenFeature seen(const LayerFeature& feature) const {
        SeenFeature seen;
        seen.shape = feature.shape;
        seen.width = feature.width;
        seen.label = feature.label;
        if (feature.shape == LayerShape::points) {
            for (const auto& line : feature.lines) add_point(line.front(), seen.parts);
        } else if (settings_.width > 0.0 || settings_.ground_width > 0.0) {
            for (const auto& line : feature.lines) add_line(line, feature.width, seen.parts);
        }
        if (asked_.areas) {
            for (const auto& ring : feature.rings) seen.rings.push_back(points_of(ring));
        }
        if (feature.anchor && !feature.label.empty()) {
            std::vector<SeenPart> anchor;
            add_point(*feature.anchor, anchor);
            if (!anchor.empty()) seen.anchor = std::move(anchor.front());
        }
        return seen;
    }

  private:
    enum class Sight { none, hidden, open };

    [[nodiscard]] Sight sight_of(const BedPlace& place) const {
        const auto at = sight_.at(place);
        if (!at || !within(*at, near_)) return Sight::none;
        if (settings_.hidden == BehindRidges::show || sight_.visible(place)) return Sight::open;
        return settings_.hidden == BehindRidges::hide ? Sight::none : Sight::hidden;
    }

    void add_point(const BedPlace& place, std::vector<SeenPart>& parts) const {
        const Sight sight = sight_of(place);
        if (sight == Sight::none) return;
        parts.push_back({{*sight_.at(place)}, sight == Sight::hidden});
    }

    [[nodiscard]] std::vector<CanvasPoint> points_of(const std::vector<BedPlace>& places) const {
        std::vector<CanvasPoint> points;
        for (const BedPlace& place : places) {
            if (const auto at = sight_.at(place)) points.push_back(*at);
        }
        return points;
    }

    /// Between two places of different sights, where one gives way to the other.
    [[nodiscard]] BedPlace change_between(BedPlace from, BedPlace to, Sight of_from) const {
        constexpr int halvings = 6;
        for (int i = 0; i < halvings; ++i) {
            const BedPlace middle{0.5 * (from[0] + to[0]), 0.5 * (from[1] + to[1])};
            (sight_of(middle) == of_from ? from : to) = middle;
        }
        return from;
    }

    void add_line(const std::vector<BedPlace>& line, double width,
                  std::vector<SeenPart>& parts) const {
        GroundPart part;
        Sight before = Sight::none;
        const auto end_part = [&] {
            if (part.places.size() > 1) add_part(part, width, parts);
            part = {};
        };
        for (std::size_t i = 0; i < line.size(); ++i) {
            const Sight here = sight_of(line[i]);
            if (i > 0 && here != before) {
                const BedPlace change = change_between(line[i - 1], line[i], before);
                if (before != Sight::none) part.places.push_back(change);
                end_part();
                if (here != Sight::none) part.places.push_back(change);
            }
            part.hidden = here == Sight::hidden;
            if (here != Sight::none) part.places.push_back(line[i]);
            before = here;
        }
        end_part();
    }

    void add_part(const GroundPart& part, double width, std::vector<SeenPart>& parts) const {
        if (settings_.ground_width > 0.0) {
            parts.push_back({outline_of(part.places, width), part.hidden});
            return;
        }
        std::vector<CanvasPoint> points = points_of(part.places);
        if (points.size() > 1) parts.push_back({std::move(points), part.hidden});
    }

    /// What a line of a width on the ground covers: along its left and back along its right side.
    [[nodiscard]] std::vector<CanvasPoint> outline_of(const std::vector<BedPlace>& places,
                                                      double width) const {
        const double half = 0.5 * width * settings_.ground_width;
        std::vector<BedPlace> left;
        std::vector<BedPlace> right;
        for (std::size_t i = 0; i < places.size(); ++i) {
            const BedPlace& before = places[i > 0 ? i - 1 : i];
            const BedPlace& after = places[std::min(i + 1, places.size() - 1)];
            const double x = (after[0] - before[0]) * asked_.length_x;
            const double y = (after[1] - before[1]) * asked_.length_y;
            const double length = elementary::hypot(x, y);
            if (!(length > 0.0)) continue;
            const BedPlace aside{-y / length * half / asked_.length_x,
                                 x / length * half / asked_.length_y};
            left.push_back({places[i][0] + aside[0], places[i][1] + aside[1]});
            right.push_back({places[i][0] - aside[0], places[i][1] - aside[1]});
        }
        left.insert(left.end(), right.rbegin(), right.rend());
        return points_of(left);
    }

    const LayersAsked& asked_;
    const GroundSight& sight_;
    const LayerSettings& settings_;
    CanvasBox near_;
};

}  // namespace

std::vector<SeenLayer> seen_layers(const LayersAsked& asked, const GroundSight& sight) {
    std::vector<SeenLayer> layers;
    for (std::size_t n = 0; n < asked.placed.layers.size(); ++n) {
        const LayerSight seen(asked, sight, asked.settings[n]);
        SeenLayer layer;
        for (const LayerFeature& feature : asked.placed.layers[n].features)
            layer.features.push_back(seen.seen(feature));
        layers.push_back(std::move(layer));
    }
    return layers;
}

std::vector<SeenLayer> in_box(std::vector<SeenLayer> layers, const CanvasBox& box) {
    const auto move = [&](std::vector<CanvasPoint>& points) {
        for (CanvasPoint& point : points)
            point = {box.x + box.width * point.x, box.y + box.height * point.y};
    };
    for (SeenLayer& layer : layers) {
        for (SeenFeature& feature : layer.features) {
            for (SeenPart& part : feature.parts) move(part.points);
            for (std::vector<CanvasPoint>& ring : feature.rings) move(ring);
            if (feature.anchor) move(feature.anchor->points);
        }
    }
    return layers;
}

}  // namespace fumon
