#include "render/samples/triangle_bands.h"

#include <algorithm>
#include <utility>

#include "base/worker_pool.h"

namespace fumon {

void TriangleBands::sort_share(std::size_t share, std::size_t shares,
                               const triangle_vectors::Corners& corners, int first_row, int bands,
                               int band_rows) {
    Share& own = shares_[share];
    own.listed.resize(std::max(own.listed.size(), static_cast<std::size_t>(bands) * parts_.size()));
    for (std::vector<std::uint32_t>& list : own.listed) list.clear();
    own.unplaced.assign(parts_.size(), {});
    const std::int32_t lowest = 256 * first_row;
    const std::int32_t in_band = 256 * band_rows;
    for (std::size_t p = 0; p < parts_.size(); ++p) {
        const TrianglePart& part = parts_[p];
        const std::size_t triangles = part.triangles.size() / 3;
        const std::size_t first = triangles * share / shares;
        const std::size_t last = triangles * (share + 1) / shares;
        const std::int32_t* y = corners.y.data() + part.first_corner;
        const float* nearness = corners.nearness.data() + part.first_corner;
        for (std::size_t i = first; i < last; ++i) {
            const std::uint32_t* of = part.triangles.data() + 3 * i;
            if (nearness[of[0]] == 0.0F || nearness[of[1]] == 0.0F || nearness[of[2]] == 0.0F) {
                own.unplaced[p].push_back(static_cast<std::uint32_t>(i));
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

void TriangleBands::sort(const triangle_vectors::Corners& corners, std::vector<TrianglePart> parts,
                         int first_row, int rows, int band_rows, WorkerPool& pool) {
    parts_ = std::move(parts);
    const int bands = (rows + band_rows - 1) / band_rows;
    const auto shares = static_cast<std::size_t>(pool.size());
    shares_.resize(shares);
    pool.for_ranges(pool.size(), [&](int begin, int end) {
        for (int share = begin; share < end; ++share)
            sort_share(static_cast<std::size_t>(share), shares, corners, first_row, bands,
                       band_rows);
    });
}

std::vector<std::uint32_t> TriangleBands::unplaced(std::size_t part) const {
    std::vector<std::uint32_t> all;
    for (const Share& share : shares_)
        all.insert(all.end(), share.unplaced[part].begin(), share.unplaced[part].end());
    return all;
}

void TriangleBands::draw(int band, const triangle_vectors::Corners& corners,
                         const triangle_vectors::Band& of) const {
    for (const Share& share : shares_) {
        for (std::size_t p = 0; p < parts_.size(); ++p) {
            const std::vector<std::uint32_t>& list =
                share.listed[static_cast<std::size_t>(band) * parts_.size() + p];
            if (list.empty()) continue;
            const TrianglePart& part = parts_[p];
            triangle_vectors::draw(corners,
                                   {part.triangles.data(), part.first_corner, list.data(),
                                    list.size(), part.kind, part.both_faces},
                                   of);
        }
    }
}

}  // namespace fumon
