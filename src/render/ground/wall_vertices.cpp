#include "render/ground/wall_vertices.h"

namespace fumon {

namespace {

RaySample at_height(double over, const RaySample& on_wall, double slope) {
    const double radius = on_wall.radius + (over - on_wall.over) / slope;
    return {radius, over, over / radius};
}

}  // namespace

void WallVertices::begin_ray() {
    chosen_.clear();
    rising_ = false;
    has_rim_ = false;
}

void WallVertices::take(std::span<const RaySample> ring, std::size_t highest) {
    const bool rim_before = has_rim_;
    if (rim_before && ring[highest].tangent >= chosen_.back().tangent) chosen_.back() = rim_;
    has_rim_ = false;
    bool has_foot = false;
    RaySample foot;
    RaySample steepest_at;
    double steepest = 0.0;
    RaySample before = chosen_.empty() ? ring.front() : last_;
    for (std::size_t k = 0; k < ring.size(); ++k) {
        const RaySample& at = ring[k];
        const double run = at.radius - before.radius;
        const bool steep = at.over - before.over > slope_ * run;
        if (steep && !rising_ && !has_foot && !has_rim_) {
            has_foot = true;
            foot = before;
        }
        if (steep && !has_rim_ && at.over - before.over > steepest * run) {
            steepest = (at.over - before.over) / run;
            steepest_at.radius = 0.5 * (before.radius + at.radius);
            steepest_at.over = 0.5 * (before.over + at.over);
        }
        // A rim at the end of the ring before looks highest there.
        if (!steep && rising_ && k > 0 && !has_rim_) {
            has_rim_ = true;
            rim_ = at_height(before.over, steepest_at, steepest);
        }
        rising_ = steep;
        before = at;
    }
    if (has_foot) foot = at_height(foot.over, steepest_at, steepest);
    const bool may_stand = has_foot && !rim_before && !chosen_.empty();
    if (may_stand && foot.tangent >= chosen_.back().tangent) chosen_.back() = foot;
    last_ = before;
    chosen_.push_back(ring[highest]);
}

}  // namespace fumon
