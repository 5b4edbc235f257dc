#include "picture/exr.h"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfInputFile.h>
#include <ImfOutputFile.h>
#include <ImfStandardAttributes.h>
#include <ImfStringAttribute.h>
#include <fmt/format.h>
#include <half.h>

#include <algorithm>
#include <bit>
#include <cstddef>
#include <exception>
#include <string>

#include "base/error.h"
#include "files/input_file.h"

namespace fumon {

namespace {

constexpr std::string_view magic = "\x76\x2f\x31\x01";
constexpr const char* units_keyword = "fumon:units";
constexpr int zip_level = 2;        // of zlib's: half the time of OpenEXR's usual 4
constexpr int rows_of_a_band = 64;  // written at once; a multiple of ZIP's 16

class MemoryFile : public Imf::OStream {
  public:
    MemoryFile() : OStream("a picture") {}

    void write(const char bytes[], int count) override {
        const std::size_t end = at_ + static_cast<std::size_t>(count);
        if (end > bytes_.size()) bytes_.resize(end);
        std::copy_n(bytes, count, bytes_.begin() + static_cast<std::ptrdiff_t>(at_));
        at_ = end;
    }
    std::uint64_t tellp() override { return at_; }
    void seekp(std::uint64_t place) override { at_ = place; }

    std::vector<std::uint8_t> take() { return std::move(bytes_); }

  private:
    std::vector<std::uint8_t> bytes_;
    std::size_t at_ = 0;
};

Imath::M44f matrix(const std::array<float, 16>& numbers) {
    Imath::M44f result;
    for (std::size_t row = 0; row < 4; ++row) {
        for (std::size_t column = 0; column < 4; ++column)
            result[static_cast<int>(row)][static_cast<int>(column)] = numbers[4 * row + column];
    }
    return result;
}

void check(const LayeredImage& image) {
    const auto pixels =
        static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
    const bool whole = image.width > 0 && image.height > 0 && !image.layers.empty() &&
                       std::ranges::all_of(image.layers, [&](const ImageLayer& layer) {
                           return layer.values.size() == pixels && !layer.name.empty();
                       });
    if (!whole)
        throw Error(
            fmt::format("a picture of {} × {} pixels and {} layers cannot be written as "
                        "OpenEXR",
                        image.width, image.height, image.layers.size()));
}

Imf::Header header_of(const LayeredImage& image, double dots_per_inch, const PictureText& texts) {
    Imf::Header header(image.width, image.height);
    header.compression() = Imf::ZIP_COMPRESSION;
    header.zipCompressionLevel() = zip_level;
    Imf::addChromaticities(header, Imf::Chromaticities());
    Imf::addXDensity(header, static_cast<float>(dots_per_inch));
    Imf::addWorldToCamera(header, matrix(image.world_to_camera));
    Imf::addWorldToNDC(header, matrix(image.world_to_picture));
    std::string units;
    for (const ImageLayer& layer : image.layers) {
        header.channels().insert(layer.name, Imf::Channel(layer.half ? Imf::HALF : Imf::FLOAT));
        if (!layer.unit.empty()) units += fmt::format("{}: {}\n", layer.name, layer.unit);
    }
    header.insert(units_keyword, Imf::StringAttribute(units));
    for (const auto& [keyword, text] : texts) header.insert(keyword, Imf::StringAttribute(text));
    return header;
}

/// Rows of a layer as they are stored.
struct Band {
    std::vector<half> halves;
    std::vector<float> floats;

    void fill(const ImageLayer& layer, std::size_t first, std::size_t count) {
        const float* from = layer.values.data() + first;
        if (layer.half) {
            halves.assign(from, from + count);
        } else {
            floats.assign(from, from + count);
        }
    }
    [[nodiscard]] const void* data() const {
        return halves.empty() ? static_cast<const void*>(floats.data()) : halves.data();
    }
};

void write_rows(Imf::OutputFile& file, const LayeredImage& image) {
    const auto width = static_cast<std::size_t>(image.width);
    std::vector<Band> bands(image.layers.size());
    for (int y = 0; y < image.height; y += rows_of_a_band) {
        const int rows = std::min(rows_of_a_band, image.height - y);
        Imf::FrameBuffer buffer;
        for (std::size_t i = 0; i < bands.size(); ++i) {
            const ImageLayer& layer = image.layers[i];
            bands[i].fill(layer, width * static_cast<std::size_t>(y),
                          width * static_cast<std::size_t>(rows));
            buffer.insert(layer.name,
                          Imf::Slice::Make(layer.half ? Imf::HALF : Imf::FLOAT, bands[i].data(),
                                           Imath::V2i(0, y), image.width, rows));
        }
        file.setFrameBuffer(buffer);
        file.writePixels(rows);
    }
}

}  // namespace

std::vector<std::uint8_t> encode_exr(const LayeredImage& image, double dots_per_inch,
                                     const PictureText& texts) {
    check(image);
    MemoryFile memory;
    try {
        Imf::OutputFile file(memory, header_of(image, dots_per_inch, texts));
        write_rows(file, image);
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const std::exception& failure) {
        throw Error(fmt::format("cannot encode an OpenEXR picture: {}", failure.what()));
    }
    return memory.take();
}

bool is_exr(std::string_view head) {
    return head.starts_with(magic);
}

PictureText read_exr_texts(const std::filesystem::path& file) {
    if (!is_exr(start_of_input_file(file, magic.size())))
        throw InputError(fmt::format("{}: is not an OpenEXR file", file.string()));
    constexpr int longest_side = 65535;  // pixels; as of PNG
    try {
        Imf::Header::setMaxImageSize(longest_side, longest_side);
        const Imf::InputFile picture(file.string().c_str());
        PictureText texts;
        const Imf::Header& header = picture.header();
        for (auto one = header.begin(); one != header.end(); ++one) {
            if (const auto* text = dynamic_cast<const Imf::StringAttribute*>(&one.attribute()))
                texts.emplace_back(one.name(), text->value());
        }
        return texts;
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const std::exception& failure) {
        throw InputError(fmt::format("{}: is a damaged OpenEXR file ({}); take an untouched copy",
                                     file.string(), failure.what()));
    }
}

Sha256 layers_hash(const LayeredImage& image) {
    Sha256Stream hash;
    hash.add_little_endian(static_cast<std::uint32_t>(image.width));
    hash.add_little_endian(static_cast<std::uint32_t>(image.height));
    const auto width = static_cast<std::size_t>(image.width);
    std::vector<std::uint8_t> bytes;
    const auto add = [&bytes](std::uint32_t value, int count) {
        for (; count > 0; --count, value >>= 8U) bytes.push_back(static_cast<std::uint8_t>(value));
    };
    for (const ImageLayer& layer : image.layers) {
        hash.add(layer.name.data(), layer.name.size());
        for (std::size_t at = 0; at < layer.values.size(); at += width) {
            bytes.clear();
            for (std::size_t x = at; x < at + width; ++x) {
                if (layer.half) {
                    add(half(layer.values[x]).bits(), 2);
                } else {
                    add(std::bit_cast<std::uint32_t>(layer.values[x]), 4);
                }
            }
            hash.add(bytes.data(), bytes.size());
        }
    }
    return hash.finish();
}

}  // namespace fumon
