#include "render/samples/packed_samples.h"

#include <algorithm>
#include <cstddef>

#include "gl/functions.h"

namespace fumon {

namespace {

// Pixels listed at once.
constexpr int columns = 512;
constexpr int rows = 128;
constexpr std::size_t most = std::size_t{columns} * rows;

const gl::TextureLayout list_layout{GL_RG32F, GL_RG, GL_FLOAT, GL_NEAREST, 0, GL_CLAMP_TO_EDGE};
const gl::TextureLayout samples_layout{GL_RGBA8,   GL_RGBA, GL_UNSIGNED_BYTE,
                                       GL_NEAREST, 0,       GL_CLAMP_TO_EDGE};

}  // namespace

PackedSamples::PackedSamples(int factor)
    : factor_(factor),
      listed_(columns, rows, list_layout),
      target_(columns * factor, rows * factor, samples_layout),
      first_samples_(most) {}

void PackedSamples::read_pixels(const Tile& tile, const glm::ivec2& first,
                                const PixelClasses& kinds) {
    width_ = tile.width;
    first_ = first;
    pixels_.resize(static_cast<std::size_t>(tile.width) * static_cast<std::size_t>(tile.height));
    gl::functions().ReadPixels(0, 0, tile.width, tile.height, GL_RGBA, GL_UNSIGNED_INT_8_8_8_8_REV,
                               pixels_.data());
    for (EdgePixels& edges : edges_) edges.pixels.clear();
    for (std::size_t i = 0; i < pixels_.size(); ++i) {
        const std::uint32_t kind = kinds.numbers()[i];
        if (kind >= pixel_class_vectors::first_single_surface) continue;
        pixels_[i] = 0;
        const auto number = static_cast<std::uint32_t>(i);
        if ((kind & pixel_class_vectors::near_samples) != 0) edges_[0].pixels.push_back(number);
        if ((kind & pixel_class_vectors::far_samples) != 0) edges_[1].pixels.push_back(number);
    }
}

void PackedSamples::colour(Ground ground,
                           const std::function<void(const gl::Texture2D& listed)>& draw) {
    EdgePixels& edges = edges_[ground == Ground::near ? 0 : 1];
    const auto factor = static_cast<std::size_t>(factor_);
    const std::size_t length = columns * factor;
    edges.samples.resize(edges.pixels.size() * factor * factor);
    std::uint32_t* sample = edges.samples.data();
    for (std::size_t from = 0; from < edges.pixels.size(); from += most) {
        const std::size_t count = std::min(most, edges.pixels.size() - from);
        for (std::size_t i = 0; i < count; ++i) {
            const auto pixel = static_cast<int>(edges.pixels[from + i]);
            first_samples_[i] = first_ + factor_ * glm::ivec2(pixel % width_, pixel / width_);
        }
        listed_.upload(first_samples_.data());
        target_.bind();
        const auto high = static_cast<int>((count + columns - 1) / columns) * factor_;
        gl::functions().Viewport(0, 0, target_.width(), high);
        draw(listed_);
        packed_read_.resize(length * static_cast<std::size_t>(high));
        gl::functions().ReadPixels(0, 0, target_.width(), high, GL_RGBA,
                                   GL_UNSIGNED_INT_8_8_8_8_REV, packed_read_.data());
        for (std::size_t i = 0; i < count; ++i) {
            const std::uint32_t* packed =
                packed_read_.data() + i / columns * factor * length + i % columns * factor;
            for (std::size_t j = 0; j < factor; ++j)
                sample = std::copy_n(packed + j * length, factor, sample);
        }
    }
}

void PackedSamples::write_row(int y, std::uint32_t* samples) const {
    const auto factor = static_cast<std::size_t>(factor_);
    const auto width = static_cast<std::size_t>(width_);
    const std::size_t length = width * factor;
    const std::size_t first = static_cast<std::size_t>(y) * width;
    for (std::size_t x = 0; x < width; ++x)
        std::fill_n(samples + factor * x, factor, pixels_[first + x]);
    for (std::size_t j = 1; j < factor; ++j) std::copy_n(samples, length, samples + j * length);
    for (const EdgePixels& edges : edges_) {
        const auto begin =
            std::ranges::lower_bound(edges.pixels, static_cast<std::uint32_t>(first));
        for (auto edge = begin; edge != edges.pixels.end() && *edge < first + width; ++edge) {
            const std::uint32_t* own =
                edges.samples.data() +
                static_cast<std::size_t>(edge - edges.pixels.begin()) * factor * factor;
            std::uint32_t* at = samples + factor * (*edge - first);
            for (std::size_t j = 0; j < factor; ++j)
                for (std::size_t i = 0; i < factor; ++i) at[j * length + i] |= own[j * factor + i];
        }
    }
}

}  // namespace fumon
