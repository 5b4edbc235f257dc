#include "picture/colour_table.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

namespace fumon {

namespace {

constexpr unsigned count_bits = 5;
constexpr unsigned look_bits = 6;
constexpr std::size_t channels = 3;
using Colour = std::array<double, channels>;

struct CountedColour {
    Colour colour{};
    double weight = 0.0;
};

/// Colours that become one.
struct ColourBox {
    std::span<CountedColour> colours;
    Colour mean{};
    std::size_t widest = 0;  ///< channel with the largest sum of squares
    double squares = 0.0;    ///< of distances from the mean, in that channel
};

ColourBox box_of(std::span<CountedColour> colours) {
    ColourBox box{colours, {}, 0, 0.0};
    double weight = 0.0;
    Colour sum{};
    Colour squares{};
    for (const CountedColour& one : colours) {
        weight += one.weight;
        for (std::size_t c = 0; c < channels; ++c) {
            sum.at(c) += one.weight * one.colour.at(c);
            squares.at(c) += one.weight * one.colour.at(c) * one.colour.at(c);
        }
    }
    for (std::size_t c = 0; c < channels; ++c) {
        box.mean.at(c) = sum.at(c) / weight;
        const double spread = squares.at(c) - sum.at(c) * box.mean.at(c);
        if (spread <= box.squares) continue;
        box.squares = spread;
        box.widest = c;
    }
    return box;
}

/// Cuts a box in two along its widest channel, where the sum of squares of both is least.
std::size_t best_cut(ColourBox& box) {
    const std::size_t channel = box.widest;
    std::ranges::stable_sort(box.colours, [channel](const auto& one, const auto& other) {
        return one.colour.at(channel) < other.colour.at(channel);
    });
    double weight = 0.0;
    double sum = 0.0;
    for (const CountedColour& one : box.colours) {
        weight += one.weight;
        sum += one.weight * one.colour.at(channel);
    }
    double below = 0.0;
    double sum_below = 0.0;
    double best = -1.0;
    std::size_t cut = box.colours.size() / 2;
    for (std::size_t i = 0; i + 1 < box.colours.size(); ++i) {
        below += box.colours[i].weight;
        sum_below += box.colours[i].weight * box.colours[i].colour.at(channel);
        const double above = weight - below;
        const double gain =
            sum_below * sum_below / below + (sum - sum_below) * (sum - sum_below) / above;
        if (gain <= best) continue;
        best = gain;
        cut = i + 1;
    }
    return cut;
}

double squared_distance(const Colour& a, const Colour& b) {
    double sum = 0.0;
    for (std::size_t c = 0; c < channels; ++c) sum += (a.at(c) - b.at(c)) * (a.at(c) - b.at(c));
    return sum;
}

/// −0.5 … 0.5: place of a pixel in Bayer's 8 x 8 matrix.
double bayer(unsigned x, unsigned y) {
    unsigned value = 0;
    const unsigned mixed = x ^ y;
    for (unsigned bit = 0; bit < 3; ++bit)
        value |= (mixed >> bit & 1U) << (5U - 2U * bit) | (y >> bit & 1U) << (4U - 2U * bit);
    return (value + 0.5) / 64.0 - 0.5;
}

}  // namespace

void ColourCounts::add(const Image& image) {
    constexpr unsigned drop = 8 - count_bits;
    for (std::size_t i = 0; i + 2 < image.rgb.size(); i += channels) {
        const std::size_t place = (static_cast<std::size_t>(image.rgb[i] >> drop) << 10U) |
                                  (static_cast<std::size_t>(image.rgb[i + 1] >> drop) << 5U) |
                                  static_cast<std::size_t>(image.rgb[i + 2] >> drop);
        ++counts_[place];
    }
}

ColourTable::ColourTable(const ColourCounts& counts) {
    std::vector<CountedColour> found;
    for (std::size_t place = 0; place < counts.counts_.size(); ++place) {
        if (counts.counts_[place] == 0) continue;
        const auto channel = [place](unsigned shift) {
            return static_cast<double>((place >> shift & 31U) * 8U + 4U);
        };
        // Rare colours count for more than their share, or small things lose theirs.
        found.push_back({{channel(10), channel(5), channel(0)},
                         std::sqrt(static_cast<double>(counts.counts_[place]))});
    }
    std::vector<ColourBox> boxes;
    if (!found.empty()) boxes.push_back(box_of(found));
    while (!boxes.empty() && boxes.size() < most_colours) {
        const auto largest = std::ranges::max_element(boxes, {}, &ColourBox::squares);
        if (largest->squares <= 0.0 || largest->colours.size() < 2) break;
        const std::span<CountedColour> whole = largest->colours;
        const std::size_t cut = best_cut(*largest);
        *largest = box_of(whole.first(cut));
        boxes.push_back(box_of(whole.subspan(cut)));
    }
    std::vector<Colour> table;
    table.reserve(boxes.size() + 1);
    for (const ColourBox& box : boxes) table.push_back(box.mean);
    if (table.empty()) table.push_back({});
    count_ = static_cast<int>(table.size());
    for (std::size_t i = 0; i < table.size(); ++i) {
        std::uint32_t colour = 0xFFU;
        for (const double part : table[i])
            colour = colour << 8U | static_cast<std::uint32_t>(std::lround(part));
        colours_.at(i) = colour;
    }
    double distances = 0.0;
    for (const Colour& colour : table) {
        double least = std::numeric_limits<double>::max();
        for (const Colour& other : table)
            if (&other != &colour) least = std::min(least, squared_distance(colour, other));
        if (table.size() > 1) distances += std::sqrt(least / channels);
    }
    spread_ = distances / static_cast<double>(table.size());

    nearest_.resize(std::size_t{1} << 3 * look_bits);
    for (std::size_t place = 0; place < nearest_.size(); ++place) {
        const auto channel = [place](unsigned shift) {
            return static_cast<double>(place >> shift & 63U) * 255.0 / 63.0;
        };
        const Colour colour{channel(12), channel(6), channel(0)};
        double least = std::numeric_limits<double>::max();
        for (std::size_t i = 0; i < table.size(); ++i) {
            const double distance = squared_distance(colour, table[i]);
            if (distance >= least) continue;
            least = distance;
            nearest_[place] = static_cast<std::uint8_t>(i);
        }
    }
}

std::vector<std::uint8_t> ColourTable::indices(const Image& image) const {
    std::vector<std::uint8_t> indices(image.rgb.size() / channels);
    std::size_t n = 0;
    for (int y = 0; y < image.height; ++y) {
        const std::uint8_t* pixel = image.row(y);
        for (int x = 0; x < image.width; ++x) {
            const double shift =
                spread_ * bayer(static_cast<unsigned>(x), static_cast<unsigned>(y));
            std::size_t place = 0;
            for (std::size_t c = 0; c < channels; ++c, ++pixel) {
                const double value = std::clamp((*pixel + shift) * 63.0 / 255.0, 0.0, 63.0);
                place = place << look_bits | static_cast<std::size_t>(value + 0.5);
            }
            indices[n++] = nearest_[place];
        }
    }
    return indices;
}

}  // namespace fumon
