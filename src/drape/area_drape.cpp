#include "drape/area_drape.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace fumon {

namespace {

constexpr int texels_of_cell = 4;    // along a side
constexpr int longest_drape = 8192;  // texels
constexpr int lines_of_texel = 4;    // on which the inside is found, in each row of texels

/// How much of each texel of a row the inside of rings covers, 0 … 1 (even-odd).
class RowCover {
  public:
    RowCover(const std::vector<std::vector<BedPlace>>& rings, int width, int height)
        : width_(width), cover_(static_cast<std::size_t>(width)) {
        for (const auto& ring : rings) {
            for (std::size_t i = 0; i < ring.size(); ++i) {
                const BedPlace& a = ring[i];
                const BedPlace& b = ring[(i + 1) % ring.size()];
                if (a[1] == b[1]) continue;
                const bool up = a[1] < b[1];
                const BedPlace& low = up ? a : b;
                const BedPlace& high = up ? b : a;
                sides_.push_back(
                    {low[0] * width, low[1] * height, high[0] * width, high[1] * height});
            }
        }
        std::ranges::sort(sides_, {}, &Side::low_y);
    }

    /// Rows are asked for from the lowest on.
    const std::vector<double>& of_row(int row) {
        std::ranges::fill(cover_, 0.0);
        while (next_ < sides_.size() && sides_[next_].low_y < row + 1)
            active_.push_back(sides_[next_++]);
        std::erase_if(active_, [row](const Side& side) { return side.high_y <= row; });
        for (int line = 0; line < lines_of_texel; ++line) {
            const double y = row + (line + 0.5) / lines_of_texel;
            crossings_.clear();
            for (const Side& side : active_) {
                if (side.low_y <= y && y < side.high_y)
                    crossings_.push_back(std::lerp(side.low_x, side.high_x,
                                                   (y - side.low_y) / (side.high_y - side.low_y)));
            }
            std::ranges::sort(crossings_);
            for (std::size_t i = 0; i + 1 < crossings_.size(); i += 2)
                add(crossings_[i], crossings_[i + 1]);
        }
        return cover_;
    }

    [[nodiscard]] bool ended() const { return active_.empty() && next_ == sides_.size(); }

  private:
    struct Side {
        double low_x, low_y, high_x, high_y;
    };

    void add(double from, double to) {
        const int first = std::clamp(static_cast<int>(std::floor(from)), 0, width_ - 1);
        const int last = std::clamp(static_cast<int>(std::floor(to)), 0, width_ - 1);
        for (int x = first; x <= last; ++x) {
            const double part = std::min(to, x + 1.0) - std::max(from, static_cast<double>(x));
            cover_[static_cast<std::size_t>(x)] += std::max(part, 0.0) / lines_of_texel;
        }
    }

    int width_;
    std::vector<double> cover_;
    std::vector<Side> sides_;
    std::vector<Side> active_;
    std::size_t next_ = 0;
    std::vector<double> crossings_;
};

void lay(std::uint8_t* texel, const std::array<double, 3>& colour, double opacity) {
    constexpr double full = 255.0;
    const double under = texel[3] / full * (1.0 - opacity);
    const double sum = opacity + under;
    if (sum <= 0.0) return;
    for (std::size_t channel = 0; channel < 3; ++channel)
        texel[channel] = static_cast<std::uint8_t>(
            std::lround((full * colour[channel] * opacity + texel[channel] * under) / sum));
    texel[3] = static_cast<std::uint8_t>(std::lround(full * sum));
}

Drape ground_of(const std::shared_ptr<const Drape>& under, double strength, const BedCells& bed) {
    Drape drape;
    if (under) {
        drape = *under;
        for (std::size_t at = 3; at < drape.texels.size(); at += 4)
            drape.texels[at] = static_cast<std::uint8_t>(std::lround(strength * drape.texels[at]));
    } else {
        double texels = texels_of_cell;
        while (texels * std::max(bed.nx, bed.ny) > longest_drape ||
               texels * bed.nx * texels * bed.ny > static_cast<double>(most_drape_pixels))
            texels *= 0.5;
        drape.width = std::max(1, static_cast<int>(texels * bed.nx));
        drape.height = std::max(1, static_cast<int>(texels * bed.ny));
        drape.texels.resize(4 * static_cast<std::size_t>(drape.width) *
                            static_cast<std::size_t>(drape.height));
    }
    drape.strength_counts = false;
    return drape;
}

}  // namespace

std::shared_ptr<const Drape> with_areas(const std::shared_ptr<const Drape>& under, double strength,
                                        std::span<const FilledAreas> areas, const BedCells& bed) {
    const auto is_area = [](const LayerFeature& feature) { return !feature.rings.empty(); };
    const bool some = std::ranges::any_of(areas, [&](const FilledAreas& filled) {
        return filled.opacity > 0.0 && std::ranges::any_of(filled.layer->features, is_area);
    });
    if (!some) return nullptr;
    Drape drape = ground_of(under, strength, bed);
    for (const FilledAreas& filled : areas) {
        for (const LayerFeature& feature : filled.layer->features) {
            if (!is_area(feature)) continue;
            RowCover cover(feature.rings, drape.width, drape.height);
            for (int y = 0; y < drape.height && !cover.ended(); ++y) {
                const std::vector<double>& row = cover.of_row(y);
                for (std::size_t x = 0; x < row.size(); ++x) {
                    if (row[x] <= 0.0) continue;
                    lay(drape.texels.data() + 4 * (static_cast<std::size_t>(y) * row.size() + x),
                        filled.colour, filled.opacity * std::min(row[x], 1.0));
                }
            }
        }
    }
    return std::make_shared<const Drape>(std::move(drape));
}

}  // namespace fumon
