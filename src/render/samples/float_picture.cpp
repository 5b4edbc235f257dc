#include "render/samples/float_picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include "base/worker_pool.h"
#include "gl/functions.h"
#include "render/samples/resolve_vectors.h"

namespace fumon {

namespace {

constexpr int float_samples_per_band = 1 << 17;  // read at once: 2 MiB

}  // namespace

void resolve_float(const float* samples, int width, int factor, PixelFormat kind,
                   const float* behind, float* pixels) {
    const bool squares = kind != PixelFormat::radiance;
    const auto columns = static_cast<std::size_t>(width) * static_cast<std::size_t>(factor);
    const int all = factor * factor;
    for (int x = 0; x < width; ++x, pixels += 4) {
        std::array<double, 3> sum{};
        int covered = 0;
        for (int j = 0; j < factor; ++j) {
            for (int i = 0; i < factor; ++i) {
                const float* sample =
                    samples + 4 * (columns * static_cast<std::size_t>(j) +
                                   static_cast<std::size_t>(x) * static_cast<std::size_t>(factor) +
                                   static_cast<std::size_t>(i));
                if (sample[3] == 0.0F) continue;
                ++covered;
                for (std::size_t c = 0; c < 3; ++c) {
                    const double value = static_cast<double>(sample[c]);
                    sum[c] += squares ? value * value : value;
                }
            }
        }
        // Squares are of the covered part alone where nothing is behind it.
        const int shared = behind == nullptr && squares ? std::max(covered, 1) : all;
        for (std::size_t c = 0; c < 3; ++c) {
            if (behind != nullptr) {
                const double back =
                    static_cast<double>(behind[4 * static_cast<std::size_t>(x) + c]);
                sum[c] += (squares ? back * back : back) * (all - covered);
            }
            const double mean = sum[c] / shared;
            pixels[c] = static_cast<float>(squares ? std::sqrt(mean) : mean);
        }
        pixels[3] =
            behind != nullptr ? 1.0F : static_cast<float>(covered) / static_cast<float>(all);
    }
}

FloatPicture::FloatPicture(int width, int height, PixelFormat kind, bool open)
    : width_(width),
      height_(height),
      kind_(kind),
      open_(open),
      channels_(open ? 4 : 3, std::vector<float>(static_cast<std::size_t>(width) *
                                                 static_cast<std::size_t>(height))) {}

void FloatPicture::read_background(const Tile& tile) {
    behind_.resize(4 * static_cast<std::size_t>(tile.width) *
                   static_cast<std::size_t>(tile.height));
    gl::functions().ReadPixels(0, 0, tile.width, tile.height, GL_RGBA, GL_FLOAT, behind_.data());
}

void FloatPicture::resolve(const Tile& tile, int factor, const glm::ivec2& from, WorkerPool& pool) {
    const auto width = static_cast<std::size_t>(tile.width);
    const std::size_t length = 4 * width * static_cast<std::size_t>(factor);
    const int band = std::max(1, float_samples_per_band / (tile.width * factor * factor));
    samples_.resize(length * static_cast<std::size_t>(band * factor));
    for (int upper = 0; upper < tile.height; upper += band) {
        const int rows = std::min(band, tile.height - upper);
        const int lowest = from.y + (tile.height - upper - rows) * factor;
        gl::functions().ReadPixels(from.x, lowest, tile.width * factor, rows * factor, GL_RGBA,
                                   GL_FLOAT, samples_.data());
        pool.for_ranges(rows, [&](int begin, int end) {
            std::vector<float> pixels(4 * width);
            for (int y = begin; y < end; ++y) {
                const int row_of_tile = upper + y;
                const auto in_tile = static_cast<std::size_t>(row_of_tile);
                const int above = (rows - 1 - y) * factor;
                resolve_float(
                    samples_.data() + length * static_cast<std::size_t>(above), tile.width, factor,
                    kind_, open_ ? nullptr : behind_.data() + 4 * width * in_tile, pixels.data());
                const std::size_t first = (static_cast<std::size_t>(tile.y) + in_tile) *
                                              static_cast<std::size_t>(width_) +
                                          static_cast<std::size_t>(tile.x);
                for (std::size_t c = 0; c < channels_.size(); ++c) {
                    for (std::size_t x = 0; x < width; ++x)
                        channels_[c][first + x] = pixels[4 * x + c];
                }
            }
        });
    }
}

void FloatPicture::put(const AccumulatedLight& light) {
    const Tile& tile = light.tile();
    for (int y = 0; y < tile.height; ++y) {
        const float* pixel = light.row(y);
        const std::size_t first =
            static_cast<std::size_t>(tile.y + y) * static_cast<std::size_t>(width_) +
            static_cast<std::size_t>(tile.x);
        for (std::size_t x = 0; x < static_cast<std::size_t>(tile.width); ++x, pixel += 4) {
            for (std::size_t c = 0; c < channels_.size(); ++c) channels_[c][first + x] = pixel[c];
        }
    }
}

Image FloatPicture::display() const {
    Image image(width_, height_);
    if (open_) image = with_alpha(std::move(image));
    image.rgb16.resize(image.rgb.size());
    for (std::size_t i = 0; i < channels_[0].size(); ++i) {
        for (std::size_t c = 0; c < 3; ++c) {
            const double value = std::clamp(static_cast<double>(channels_[c][i]), 0.0, 1.0);
            const auto level = static_cast<std::uint16_t>(std::lround(65535.0 * value));
            image.rgb16[3 * i + c] = level;
            image.rgb[3 * i + c] = rounded_to_8(level);
        }
        if (open_) {
            image.alpha[i] = static_cast<std::uint8_t>(
                std::lround(255.0 * static_cast<double>(channels_[3][i])));
        }
    }
    if (!open_) return image;
    dilate_colours(image);
    for (std::size_t i = 0; i < image.rgb16.size(); ++i) {
        if (image.alpha[i / 3] == 0)
            image.rgb16[i] = static_cast<std::uint16_t>(257U * image.rgb[i]);
    }
    return image;
}

std::vector<ImageLayer> FloatPicture::take_channels() {
    constexpr std::array names{"R", "G", "B", "A"};
    std::vector<ImageLayer> layers;
    for (std::size_t c = 0; c < channels_.size(); ++c)
        layers.push_back({names.at(c), "", true, std::move(channels_[c])});
    return layers;
}

}  // namespace fumon
