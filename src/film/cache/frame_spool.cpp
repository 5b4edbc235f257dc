#include "film/cache/frame_spool.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <cstddef>
#include <vector>

#include "base/error.h"
#include "files/atomic_file.h"

namespace fumon {

namespace {

constexpr std::size_t channel_count = 3;

/// How much of each pixel of a line goes into each pixel of another.
struct Share {
    int from;
    double weight;
};

std::vector<std::vector<Share>> shares_of(int from, int to) {
    std::vector<std::vector<Share>> all(static_cast<std::size_t>(to));
    const double ratio = static_cast<double>(from) / to;
    for (int i = 0; i < to; ++i) {
        const double begin = i * ratio;
        const double end = (i + 1) * ratio;
        for (int k = static_cast<int>(begin); k < from && k < end; ++k) {
            const double covered = std::min(end, k + 1.0) - std::max(begin, static_cast<double>(k));
            if (covered > 0.0) all[static_cast<std::size_t>(i)].push_back({k, covered / ratio});
        }
    }
    return all;
}

/// Of images with alpha.
Image resized_open(const Image& image, int width, int height) {
    const auto columns = shares_of(image.width, width);
    const auto rows = shares_of(image.height, height);
    Image small = with_alpha(Image(width, height));
    std::size_t n = 0;
    for (const auto& row : rows) {
        for (const auto& column : columns) {
            std::array<double, channel_count> colours{};
            std::array<double, channel_count> unseen{};
            double alpha = 0.0;
            for (const Share& down : row) {
                const std::uint8_t* line = image.row(down.from);
                const std::uint8_t* opacities =
                    image.alpha.data() + std::ptrdiff_t{down.from} * image.width;
                for (const Share& across : column) {
                    const double weight = down.weight * across.weight;
                    const double seen = weight * opacities[across.from];
                    alpha += seen;
                    for (std::size_t c = 0; c < channel_count; ++c) {
                        const double value =
                            line[channel_count * static_cast<std::size_t>(across.from) + c];
                        colours.at(c) += seen * value;
                        unseen.at(c) += weight * value;
                    }
                }
            }
            for (std::size_t c = 0; c < channel_count; ++c) {
                const double value = alpha > 0.0 ? colours.at(c) / alpha : unseen.at(c);
                small.rgb[channel_count * n + c] =
                    static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0, 255.0)));
            }
            small.alpha[n++] =
                static_cast<std::uint8_t>(std::lround(std::clamp(alpha, 0.0, 255.0)));
        }
    }
    return small;
}

bool write_all(const std::vector<std::uint8_t>& bytes, std::FILE* file) {
    return bytes.empty() || std::fwrite(bytes.data(), 1, bytes.size(), file) == bytes.size();
}

bool read_all(std::vector<std::uint8_t>& bytes, std::FILE* file) {
    return bytes.empty() || std::fread(bytes.data(), 1, bytes.size(), file) == bytes.size();
}

}  // namespace

FrameSpool::FrameSpool(const std::filesystem::path& beside, int width, int height, bool transparent)
    : name_(temporary_name(beside.string() + ".frames")),
      width_(width),
      height_(height),
      transparent_(transparent) {
    const int descriptor =
        ::open(name_.c_str(), O_RDWR | O_CREAT | O_TRUNC | O_CLOEXEC, S_IRUSR | S_IWUSR);
    if (descriptor < 0) refuse_to_write(name_, errno);
    ::unlink(name_.c_str());
    file_.reset(::fdopen(descriptor, "w+b"));
    if (!file_) refuse_to_write(name_, errno);
}

void FrameSpool::add(const Image& image) {
    if (transparent_ && !image.transparent()) return add(with_alpha(image));
    if (std::fseek(file_.get(), 0, SEEK_END) != 0 || !write_all(image.rgb, file_.get()) ||
        !write_all(image.alpha, file_.get()) || std::fflush(file_.get()) != 0)
        refuse_to_write(name_, errno);
    ++frames_;
}

Image FrameSpool::frame(std::int64_t number) const {
    Image image(width_, height_);
    if (transparent_) image = with_alpha(std::move(image));
    const auto at =
        static_cast<off_t>(number) * static_cast<off_t>(image.rgb.size() + image.alpha.size());
    if (::fseeko(file_.get(), at, SEEK_SET) != 0 || !read_all(image.rgb, file_.get()) ||
        !read_all(image.alpha, file_.get()))
        throw Error(name_.string() + ": a frame stored there cannot be read");
    return image;
}

Image resized(const Image& image, int width, int height) {
    if (image.width == width && image.height == height) return image;
    if (image.transparent()) return resized_open(image, width, height);
    const auto columns = shares_of(image.width, width);
    const auto rows = shares_of(image.height, height);
    std::vector<double> narrow(channel_count * static_cast<std::size_t>(width) *
                               static_cast<std::size_t>(image.height));
    auto* out = narrow.data();
    for (int y = 0; y < image.height; ++y) {
        const std::uint8_t* in = image.row(y);
        for (const auto& column : columns) {
            for (std::size_t c = 0; c < channel_count; ++c) {
                double sum = 0.0;
                for (const Share& share : column)
                    sum +=
                        share.weight * in[channel_count * static_cast<std::size_t>(share.from) + c];
                *out++ = sum;
            }
        }
    }
    Image small(width, height);
    const std::size_t line = channel_count * static_cast<std::size_t>(width);
    for (int y = 0; y < height; ++y) {
        std::uint8_t* pixel = small.row(y);
        for (std::size_t i = 0; i < line; ++i) {
            double sum = 0.0;
            for (const Share& share : rows[static_cast<std::size_t>(y)])
                sum += share.weight * narrow[line * static_cast<std::size_t>(share.from) + i];
            pixel[i] = static_cast<std::uint8_t>(std::lround(std::clamp(sum, 0.0, 255.0)));
        }
    }
    return small;
}

}  // namespace fumon
