// A WebP file is RIFF: "RIFF", the size of what follows, "WEBP", and chunks, each its name (4
// letters), its size (uint32, little-endian) and its content, filled up to an even number of bytes
// (RFC 9649). Texts stand behind the picture.

#include "picture/stills/webp.h"

#include <fmt/format.h>
#include <webp/decode.h>
#include <webp/encode.h>

#include <algorithm>
#include <memory>
#include <new>
#include <optional>

#include "base/error.h"
#include "picture/stills/exif.h"
#include "picture/stills/sides.h"
#include "picture/stills/xmp.h"

namespace fumon {

namespace {

constexpr std::size_t chunk_head = 8;  // bytes
constexpr std::size_t file_head = 12;
constexpr std::string_view extended = "VP8X";
constexpr unsigned has_alpha = 0x10;
constexpr unsigned has_exif = 0x08;
constexpr unsigned has_xmp = 0x04;

void append_little_endian(std::string& bytes, std::size_t number, int count) {
    for (; count > 0; --count, number >>= 8U) bytes += static_cast<char>(number & 0xFFU);
}

std::size_t little_endian(std::string_view bytes) {
    std::size_t number = 0;
    for (auto byte = bytes.rbegin(); byte != bytes.rend(); ++byte)
        number = number << 8U | static_cast<unsigned char>(*byte);
    return number;
}

void append_chunk(std::string& bytes, std::string_view name, std::string_view content) {
    bytes += name;
    append_little_endian(bytes, content.size(), 4);
    bytes += content;
    if (content.size() % 2 != 0) bytes += '\0';
}

[[noreturn]] void refuse_damaged_webp(const std::string& name, std::string_view why) {
    throw InputError(fmt::format("{}: is a damaged WebP file ({}); make it again", name, why));
}

struct Chunk {
    std::string_view name;
    std::string_view content;
};

/// The chunks of a whole file.
std::vector<Chunk> chunks_of(std::string_view bytes, const std::string& name) {
    const std::size_t size = bytes.size() < file_head ? 0 : little_endian(bytes.substr(4, 4));
    if (size < 4 || size > bytes.size() - chunk_head)
        refuse_damaged_webp(name, "the file ends early");
    std::vector<Chunk> chunks;
    for (std::string_view left = bytes.substr(file_head, size - 4); !left.empty();) {
        if (left.size() < chunk_head) refuse_damaged_webp(name, "its chunks are inconsistent");
        const std::size_t length = little_endian(left.substr(4, 4));
        if (length > left.size() - chunk_head)
            refuse_damaged_webp(name, "its chunks are inconsistent");
        chunks.push_back({left.substr(0, 4), left.substr(chunk_head, length)});
        left.remove_prefix(std::min(chunk_head + length + length % 2, left.size()));
    }
    return chunks;
}

/// Frees what libwebp holds of a picture.
struct Picture {
    WebPPicture webp{};
    WebPMemoryWriter writer{};

    Picture() {
        if (WebPPictureInit(&webp) == 0)
            throw Error("libwebp cannot be started: another version is installed");
        WebPMemoryWriterInit(&writer);
    }
    ~Picture() {
        WebPPictureFree(&webp);
        WebPMemoryWriterClear(&writer);
    }
    Picture(const Picture&) = delete;
    Picture& operator=(const Picture&) = delete;
};

WebPConfig config_of(bool lossless, int quality) {
    WebPConfig config;
    if (WebPConfigInit(&config) == 0)
        throw Error("libwebp cannot be started: another version is installed");
    config.quality = static_cast<float>(quality);
    config.use_sharp_yuv = 1;  // colours have half the resolution: edges of text stay clean
    if (lossless) {
        constexpr int level = 3;  // of 0 … 9: twice as fast as 6, a few hundredths larger
        WebPConfigLosslessPreset(&config, level);
        config.exact = 1;  // also colours that nobody sees
    }
    return config;
}

/// The RIFF file that libwebp makes, without metadata.
std::string bare_file(const Image& image, bool lossless, int quality) {
    Picture picture;
    WebPPicture& webp = picture.webp;
    const WebPConfig config = config_of(lossless, quality);
    webp.use_argb = 1;
    webp.width = image.width;
    webp.height = image.height;
    webp.writer = WebPMemoryWrite;
    webp.custom_ptr = &picture.writer;
    bool taken = false;
    if (image.transparent()) {
        std::vector<std::uint8_t> pixels(4 * image.alpha.size());
        for (std::size_t i = 0; i < image.alpha.size(); ++i) {
            std::copy_n(image.rgb.data() + 3 * i, 3, pixels.data() + 4 * i);
            pixels[4 * i + 3] = image.alpha[i];
        }
        taken = WebPPictureImportRGBA(&webp, pixels.data(), 4 * image.width) != 0;
    } else {
        taken = WebPPictureImportRGB(&webp, image.rgb.data(), 3 * image.width) != 0;
    }
    if (!taken || WebPEncode(&config, &webp) == 0) {
        if (webp.error_code == VP8_ENC_ERROR_OUT_OF_MEMORY ||
            webp.error_code == VP8_ENC_ERROR_BITSTREAM_OUT_OF_MEMORY)
            throw std::bad_alloc();
        throw Error(fmt::format("cannot encode a WebP picture: libwebp's error {}",
                                static_cast<int>(webp.error_code)));
    }
    return {reinterpret_cast<const char*>(picture.writer.mem), picture.writer.size};
}

}  // namespace

std::vector<std::uint8_t> encode_webp(const Image& image, bool lossless, int quality,
                                      double dots_per_inch, const PictureText& texts) {
    check_sides(image, longest_webp_side, "WebP");
    const std::string bare = bare_file(image, lossless, quality);
    std::string content = "WEBP";
    std::string flags_and_size;
    append_little_endian(
        flags_and_size,
        has_exif | (texts.empty() ? 0U : has_xmp) | (image.transparent() ? has_alpha : 0U), 4);
    append_little_endian(flags_and_size, static_cast<std::size_t>(image.width) - 1, 3);
    append_little_endian(flags_and_size, static_cast<std::size_t>(image.height) - 1, 3);
    append_chunk(content, extended, flags_and_size);
    for (const Chunk& chunk : chunks_of(bare, "a picture")) {
        if (chunk.name != extended) append_chunk(content, chunk.name, chunk.content);
    }
    append_chunk(content, "EXIF", exif_block(dots_per_inch, image.width, image.height));
    if (!texts.empty()) append_chunk(content, "XMP ", xmp_packet(texts));
    std::string file = "RIFF";
    append_little_endian(file, content.size(), 4);
    file += content;
    return {file.begin(), file.end()};
}

bool is_webp(std::string_view bytes) {
    return bytes.starts_with("RIFF") &&
           bytes.substr(std::min<std::size_t>(8, bytes.size())).starts_with("WEBP");
}

PictureText webp_texts(std::string_view bytes, const std::string& name) {
    for (const Chunk& chunk : chunks_of(bytes, name)) {
        if (chunk.name == "XMP ") return texts_of_xmp(chunk.content);
    }
    return {};
}

Image decode_webp(std::string_view bytes, const std::string& name) {
    chunks_of(bytes, name);
    const auto* data = reinterpret_cast<const std::uint8_t*>(bytes.data());
    WebPBitstreamFeatures features{};
    if (WebPGetFeatures(data, bytes.size(), &features) != VP8_STATUS_OK)
        refuse_damaged_webp(name, "it has no picture");
    if (features.has_animation != 0)
        throw InputError(fmt::format("{}: is an animated WebP; take a still picture", name));
    Image image(features.width, features.height);
    if (features.has_alpha == 0) {
        if (WebPDecodeRGBInto(data, bytes.size(), image.rgb.data(), image.rgb.size(),
                              3 * image.width) == nullptr)
            refuse_damaged_webp(name, "its picture cannot be decoded");
        return image;
    }
    image = with_alpha(std::move(image));
    std::vector<std::uint8_t> pixels(4 * image.alpha.size());
    if (WebPDecodeRGBAInto(data, bytes.size(), pixels.data(), pixels.size(), 4 * image.width) ==
        nullptr)
        refuse_damaged_webp(name, "its picture cannot be decoded");
    for (std::size_t i = 0; i < image.alpha.size(); ++i) {
        std::copy_n(pixels.data() + 4 * i, 3, image.rgb.data() + 3 * i);
        image.alpha[i] = pixels[4 * i + 3];
    }
    return image;
}

}  // namespace fumon
