#include "render/samples/triangle_bins.h"

#include <algorithm>
#include <utility>

#include "base/worker_pool.h"

namespace fumon {

void TriangleBins::bin_share(std::size_t share, std::size_t shares,
                             const rasteriser_vectors::ProjectedVertices& vertices, int first_row,
                             int bands, int band_rows) {
    BinShare& own = shares_[share];
    own.listed.resize(std::max(own.listed.size(), static_cast<std::size_t>(bands) * parts_.size()));
    for (std::vector<std::uint32_t>& list : own.listed) list.clear();
    own.needing_clipping.assign(parts_.size(), {});
    const std::int32_t lowest = 256 * first_row;
    const std::int32_t in_band = 256 * band_rows;
    for (std::size_t p = 0; p < parts_.size(); ++p) {
        const TriangleGroup& part = parts_[p];
        const std::size_t triangles = part.triangles.size() / 3;
        const std::size_t first = triangles * share / shares;
        const std::size_t last = triangles * (share + 1) / shares;
        const std::int32_t* y = vertices.y.data() + part.first_vertex;
        const float* reversed_z = vertices.reversed_z.data() + part.first_vertex;
        for (std::size_t i = first; i < last; ++i) {
            const std::uint32_t* of = part.triangles.data() + 3 * i;
            if (reversed_z[of[0]] == 0.0F || reversed_z[of[1]] == 0.0F ||
                reversed_z[of[2]] == 0.0F) {
                own.needing_clipping[p].push_back(static_cast<std::uint32_t>(i));
                continue;
            }
            const auto [low, high] = std::minmax({y[of[0]], y[of[1]], y[of[2]]});
            const std::int32_t from = std::max(low - lowest, 0) / in_band;
            if (high < lowest) continue;
            const std::int32_t to = std::min((high - lowest) / in_band, bands - 1);
            for (std::int32_t band = from; band <= to; ++band)
                own.listed[static_cast<std::size_t>(band) * parts_.size() + p].push_back(
                    static_cast<std::uint32_t>(i));
        }
    }
}

void TriangleBins::bin(const rasteriser_vectors::ProjectedVertices& vertices,
                       std::vector<TriangleGroup> parts, int first_row, int rows, int band_rows,
                       WorkerPool& pool) {
    parts_ = std::move(parts);
    const int bands = (rows + band_rows - 1) / band_rows;
    const auto shares = static_cast<std::size_t>(pool.size());
    shares_.resize(shares);
    pool.for_ranges(pool.size(), [&](int begin, int end) {
        for (int share = begin; share < end; ++share)
            bin_share(static_cast<std::size_t>(share), shares, vertices, first_row, bands,
                      band_rows);
    });
}

std::vector<std::uint32_t> TriangleBins::needing_clipping(std::size_t part) const {
    std::vector<std::uint32_t> all;
    for (const BinShare& share : shares_)
        all.insert(all.end(), share.needing_clipping[part].begin(),
                   share.needing_clipping[part].end());
    return all;
}

void TriangleBins::rasterise(int band, const rasteriser_vectors::ProjectedVertices& vertices,
                             const rasteriser_vectors::Band& of) const {
    for (const BinShare& share : shares_) {
        for (std::size_t p = 0; p < parts_.size(); ++p) {
            const std::vector<std::uint32_t>& list =
                share.listed[static_cast<std::size_t>(band) * parts_.size() + p];
            if (list.empty()) continue;
            const TriangleGroup& part = parts_[p];
            rasteriser_vectors::rasterise(vertices,
                                          {part.triangles.data(), part.first_vertex, list.data(),
                                           list.size(), part.kind, part.double_sided},
                                          of);
        }
    }
}

}  // namespace fumon
