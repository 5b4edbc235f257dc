#include "film/film_frames.h"

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "base/error.h"

namespace fumon {

namespace {

/// The same of images with alpha: colours by how much of each is seen.
Image mixed_open(Image first, const Image& second, double share) {
    for (std::size_t i = 0; i < first.alpha.size(); ++i) {
        const double of_first = (1.0 - share) * first.alpha[i];
        const double of_second = share * second.alpha[i];
        const double both = of_first + of_second;
        const double part = both > 0.0 ? of_second / both : share;
        for (std::size_t at = 3 * i; at < 3 * i + 3; ++at)
            first.rgb[at] = static_cast<std::uint8_t>(
                std::lround((1.0 - part) * first.rgb[at] + part * second.rgb[at]));
        first.alpha[i] = static_cast<std::uint8_t>(std::lround(both));
    }
    return first;
}

}  // namespace

LayeredImage FilmFrames::light(std::int64_t /*frame*/) {
    throw Error("a film of several runs has no light of its own");
}

LayeredImage mixed(LayeredImage first, const LayeredImage& second, double share) {
    for (std::size_t layer = 0; layer < first.layers.size(); ++layer) {
        std::vector<float>& values = first.layers[layer].values;
        const std::vector<float>& others = second.layers[layer].values;
        for (std::size_t i = 0; i < values.size(); ++i)
            values[i] = static_cast<float>((1.0 - share) * values[i] + share * others[i]);
    }
    return first;
}

Image mixed(Image first, const Image& second, double share) {
    if (first.transparent() || second.transparent())
        return mixed_open(with_alpha(std::move(first)), with_alpha(second), share);
    for (std::size_t i = 0; i < first.rgb.size(); ++i) {
        const double value = (1.0 - share) * first.rgb[i] + share * second.rgb[i];
        first.rgb[i] = static_cast<std::uint8_t>(std::lround(value));
    }
    return first;
}

}  // namespace fumon
