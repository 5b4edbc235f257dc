#include "render/edges/edges.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/worker_pool.h"
#include "render/edges/brink_vectors.h"

namespace fumon {

namespace {

/// Some way from an edge to another, whose vector may point to either end.
Edge between(const Edge& edge, const Edge& other, float away) {
    const bool turned = edge.east * other.east + edge.north * other.north < 0.0F;
    const float sign = turned ? -1.0F : 1.0F;
    return {edge.share + away * (other.share - edge.share), 0.0F,
            edge.east + away * (sign * other.east - edge.east),
            edge.north + away * (sign * other.north - edge.north)};
}

/// The edges about the fine cells of a row, between those about coarse ones.
class EdgesOfRow {
  public:
    EdgesOfRow(const Field<Edge>& edge, int refinement)
        : edge_(edge),
          refinement_(refinement),
          coarse_(static_cast<std::size_t>(edge.nx())),
          share_(size()),
          east_(size()),
          north_(size()) {}

    /// Of a fine row; whether there is any.
    bool take(int v) {
        const int y = v / refinement_;
        const float away = part(v % refinement_);
        const auto own = edge_.row(y);
        const auto other = edge_.row(std::clamp(y + (away < 0.0F ? -1 : 1), 0, edge_.ny() - 1));
        bool any = false;
        for (std::size_t x = 0; x < coarse_.size(); ++x) {
            if (own[x].share == 0.0F && other[x].share == 0.0F) {
                coarse_[x] = own[x];
                continue;
            }
            any = true;
            coarse_[x] = between(own[x], other[x], std::abs(away));
        }
        if (any) {
            for (std::size_t x = 0; x < coarse_.size(); ++x) fill(x);
        }
        return any;
    }
    [[nodiscard]] brink_vectors::RowOfEdges row() const {
        return {share_.data(), east_.data(), north_.data()};
    }

  private:
    /// The fine cells of a coarse one.
    void fill(std::size_t x) {
        const std::size_t before = x == 0 ? 0 : x - 1;
        const std::size_t after = std::min(x + 1, coarse_.size() - 1);
        const bool none = coarse_[before].share == 0.0F && coarse_[x].share == 0.0F &&
                          coarse_[after].share == 0.0F;
        for (int i = 0; i < refinement_; ++i) {
            const float away = part(i);
            const Edge at =
                none ? Edge{}
                     : between(coarse_[x], coarse_[away < 0.0F ? before : after], std::abs(away));
            const std::size_t u =
                x * static_cast<std::size_t>(refinement_) + static_cast<std::size_t>(i);
            share_[u] = at.share;
            east_[u] = at.east;
            north_[u] = at.north;
        }
    }
    [[nodiscard]] std::size_t size() const {
        return coarse_.size() * static_cast<std::size_t>(refinement_);
    }
    /// From a coarse cell's middle to that of one of its fine cells, coarse cells.
    [[nodiscard]] float part(int i) const {
        return (static_cast<float>(i) + 0.5F) / static_cast<float>(refinement_) - 0.5F;
    }

    const Field<Edge>& edge_;
    int refinement_;
    std::vector<Edge> coarse_;
    std::vector<float> share_;
    std::vector<float> east_;
    std::vector<float> north_;
};

}  // namespace

void smooth_along_edges(const Field<Edge>& edge, int refinement, float cells_aside,
                        Field<float>& fine, WorkerPool& pool) {
    const float step = cells_aside * static_cast<float>(refinement) /
                       static_cast<float>(brink_vectors::positions_aside);
    const auto pairs = brink_vectors::pairs_of(fine.data(), static_cast<int>(fine.size()));
    pool.for_ranges(fine.ny(), [&](int begin, int end) {
        EdgesOfRow edges(edge, refinement);
        for (int v = begin; v < end; ++v) {
            if (!edges.take(v)) continue;
            brink_vectors::mix_means_along({pairs.data(), fine.nx(), fine.ny()}, v, edges.row(),
                                           step, fine.row(v).data());
        }
    });
}

}  // namespace fumon
