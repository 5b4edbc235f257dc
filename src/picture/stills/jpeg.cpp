#include "picture/stills/jpeg.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <new>
#include <optional>
#include <utility>

#include "base/error.h"
#include "picture/stills/exif.h"
#include "picture/stills/jpeg_guard.h"
#include "picture/stills/sides.h"
#include "picture/stills/xmp.h"

namespace fumon {

namespace {

constexpr std::string_view exif_head("Exif\0\0", 6);
constexpr std::string_view xmp_head("http://ns.adobe.com/xap/1.0/\0", 29);
constexpr std::string_view extension_head("http://ns.adobe.com/xmp/extension/\0", 35);
constexpr std::size_t guid_size = 32;
constexpr std::size_t segment_size = 65533;  // bytes of what a segment holds
constexpr std::size_t most_jpeg_pixels = std::size_t{1} << 28;
constexpr std::uint8_t white_ground = 255;

void append_big_endian(std::string& bytes, std::size_t number) {
    for (int shift = 24; shift >= 0; shift -= 8)
        bytes += static_cast<char>(number >> static_cast<unsigned>(shift) & 0xFFU);
}

std::size_t big_endian(std::string_view bytes) {
    std::size_t number = 0;
    for (const char byte : bytes) number = number << 8U | static_cast<unsigned char>(byte);
    return number;
}

/// The contents of the segments APP1.
std::vector<std::string> segments_of(const Image& image, double dots_per_inch,
                                     const PictureText& texts) {
    std::vector<std::string> segments;
    segments.push_back(std::string(exif_head) +
                       exif_block(dots_per_inch, image.width, image.height));
    if (texts.empty()) return segments;
    const XmpParts xmp = xmp_parts(texts, segment_size - xmp_head.size());
    segments.push_back(std::string(xmp_head) + xmp.packet);
    constexpr std::size_t piece = segment_size - extension_head.size() - guid_size - 8;
    for (std::size_t at = 0; at < xmp.extension.size(); at += piece) {
        std::string segment = std::string(extension_head) + xmp.guid;
        append_big_endian(segment, xmp.extension.size());
        append_big_endian(segment, at);
        segments.push_back(segment + xmp.extension.substr(at, piece));
    }
    return segments;
}

/// Gathers a file; give `manager` to libjpeg.
struct Destination {
    jpeg_destination_mgr manager{};  // first: libjpeg hands back a pointer to it
    std::array<JOCTET, 1 << 16> block{};
    std::vector<std::uint8_t> file;

    Destination() {
        manager.init_destination = [](j_compress_ptr jpeg) { of(jpeg).begin_block(); };
        manager.empty_output_buffer = [](j_compress_ptr jpeg) -> boolean {
            of(jpeg).take(jpeg, of(jpeg).block.size());
            return TRUE;
        };
        manager.term_destination = [](j_compress_ptr jpeg) {
            of(jpeg).take(jpeg, of(jpeg).block.size() - of(jpeg).manager.free_in_buffer);
        };
    }

  private:
    static Destination& of(j_compress_ptr jpeg) {
        return *reinterpret_cast<Destination*>(jpeg->dest);
    }
    void begin_block() {
        manager.next_output_byte = block.data();
        manager.free_in_buffer = block.size();
    }
    bool append(std::size_t count) {
        try {
            file.insert(file.end(), block.data(), block.data() + count);
        } catch (const std::bad_alloc&) {
            return false;
        }
        return true;
    }
    void take(j_compress_ptr jpeg, std::size_t count) {
        if (!append(count)) ERREXIT1(jpeg, JERR_OUT_OF_MEMORY, 0);
        begin_block();
    }
};

struct Compressor {
    JpegFailure failure{false};
    jpeg_compress_struct jpeg{};
    Destination destination;

    Compressor() = default;
    ~Compressor() { jpeg_destroy_compress(&jpeg); }
    Compressor(const Compressor&) = delete;
    Compressor& operator=(const Compressor&) = delete;
};

struct Decompressor {
    JpegFailure failure{true};
    jpeg_decompress_struct jpeg{};
    jpeg_progress_mgr progress{};

    Decompressor() = default;
    ~Decompressor() { jpeg_destroy_decompress(&jpeg); }
    Decompressor(const Decompressor&) = delete;
    Decompressor& operator=(const Decompressor&) = delete;
};

/// A small file may make work without end by scans of nothing.
void limit_scans(j_common_ptr jpeg) {
    constexpr int most_scans = 500;
    if (reinterpret_cast<j_decompress_ptr>(jpeg)->input_scan_number > most_scans)
        ERREXIT(jpeg, JERR_CANT_SUSPEND);
}

[[noreturn]] void refuse_damaged_jpeg(const std::string& name, std::string_view why) {
    throw InputError(fmt::format("{}: is a damaged JPEG file ({}); make it again", name, why));
}

/// The segments APP1 of a file before its picture; throws where it is cut short.
std::vector<std::string_view> segments_of_file(std::string_view bytes, const std::string& name) {
    constexpr auto end_of_image = std::string_view("\xFF\xD9");
    std::vector<std::string_view> segments;
    const auto code_at = [bytes](std::size_t at) {
        return at < bytes.size() ? static_cast<unsigned char>(bytes[at]) : 0U;
    };
    for (std::size_t at = 2; at + 4 <= bytes.size();) {
        if (code_at(at) != 0xFF) refuse_damaged_jpeg(name, "its segments are inconsistent");
        const unsigned marker = code_at(at + 1);
        if (marker == 0xFF) {  // fills
            ++at;
            continue;
        }
        const std::size_t length = big_endian(bytes.substr(at + 2, 2));
        if (length < 2 || length > bytes.size() - at - 2) break;
        constexpr unsigned start_of_scan = 0xDA;
        constexpr unsigned app1 = 0xE1;
        if (marker == start_of_scan) {
            if (bytes.find(end_of_image, at) == std::string_view::npos) break;
            return segments;
        }
        if (marker == app1) segments.push_back(bytes.substr(at + 4, length - 2));
        at += 2 + length;
    }
    refuse_damaged_jpeg(name, "the file ends early");
}

/// The extension of that GUID, whole; nothing where parts of it are missing.
std::optional<std::string> extension_in(const std::vector<std::string_view>& segments,
                                        std::string_view guid) {
    constexpr std::size_t head = extension_head.size() + guid_size + 8;
    std::map<std::size_t, std::string_view> pieces;
    std::size_t whole = 0;
    for (const std::string_view segment : segments) {
        if (segment.size() < head || !segment.starts_with(extension_head)) continue;
        if (segment.substr(extension_head.size(), guid_size) != guid) continue;
        whole = big_endian(segment.substr(head - 8, 4));
        pieces[big_endian(segment.substr(head - 4, 4))] = segment.substr(head);
    }
    std::string extension;
    for (const auto& [at, piece] : pieces) {
        if (at != extension.size()) return std::nullopt;
        extension += piece;
    }
    if (extension.size() != whole) return std::nullopt;
    return extension;
}

}  // namespace

std::vector<std::uint8_t> encode_jpeg(const Image& image, int quality, double dots_per_inch,
                                      const PictureText& texts) {
    check_sides(image, longest_jpeg_side, "JPEG");
    const Image opaque = image.transparent() ? composited_on(image, white_ground) : Image();
    const Image& shown = image.transparent() ? opaque : image;
    const std::vector<std::string> segments = segments_of(image, dots_per_inch, texts);
    constexpr double largest_density = 65535.0;
    const auto density =
        static_cast<UINT16>(std::clamp(std::round(dots_per_inch), 1.0, largest_density));
    Compressor compressor;
    const bool written = ends_without_jpeg_error(compressor.failure, [&] {
        jpeg_compress_struct& jpeg = compressor.jpeg;
        jpeg.err = &compressor.failure.manager;
        jpeg_create_compress(&jpeg);
        jpeg.dest = &compressor.destination.manager;
        jpeg.image_width = static_cast<JDIMENSION>(image.width);
        jpeg.image_height = static_cast<JDIMENSION>(image.height);
        jpeg.input_components = 3;
        jpeg.in_color_space = JCS_RGB;
        jpeg_set_defaults(&jpeg);
        jpeg_set_quality(&jpeg, quality, TRUE);
        jpeg.dct_method = JDCT_ISLOW;  // in whole numbers: the same on every processor
        jpeg.optimize_coding = TRUE;
        for (int i = 0; i < jpeg.num_components; ++i)
            jpeg.comp_info[i].h_samp_factor = jpeg.comp_info[i].v_samp_factor = 1;
        jpeg_simple_progression(&jpeg);
        jpeg.density_unit = 1;  // an inch
        jpeg.X_density = density;
        jpeg.Y_density = density;
        jpeg_start_compress(&jpeg, TRUE);
        for (const std::string& segment : segments) {
            jpeg_write_marker(&jpeg, JPEG_APP0 + 1, reinterpret_cast<const JOCTET*>(segment.data()),
                              static_cast<unsigned>(segment.size()));
        }
        while (jpeg.next_scanline < jpeg.image_height) {
            auto* row = const_cast<JSAMPROW>(shown.row(static_cast<int>(jpeg.next_scanline)));
            jpeg_write_scanlines(&jpeg, &row, 1);
        }
        jpeg_finish_compress(&jpeg);
    });
    if (compressor.failure.out_of_memory) throw std::bad_alloc();
    if (!written)
        throw Error(
            fmt::format("cannot encode a JPEG picture: {}", compressor.failure.message.data()));
    return std::move(compressor.destination.file);
}

bool is_jpeg(std::string_view bytes) {
    return bytes.starts_with("\xFF\xD8\xFF");
}

PictureText jpeg_texts(std::string_view bytes, const std::string& name) {
    const std::vector<std::string_view> segments = segments_of_file(bytes, name);
    PictureText texts;
    std::string guid;
    for (const std::string_view segment : segments) {
        if (!segment.starts_with(xmp_head)) continue;
        const std::string_view xmp = segment.substr(xmp_head.size());
        texts = texts_of_xmp(xmp);
        guid = extension_of_xmp(xmp);
        break;
    }
    if (guid.empty()) return texts;
    const auto extension = extension_in(segments, guid);
    if (!extension) refuse_damaged_jpeg(name, "a part of its metadata is missing");
    for (auto& text : texts_of_xmp(*extension)) texts.push_back(std::move(text));
    return texts;
}

Image decode_jpeg(std::string_view bytes, const std::string& name) {
    Decompressor decompressor;
    jpeg_decompress_struct& jpeg = decompressor.jpeg;
    const auto refuse = [&] {
        if (decompressor.failure.out_of_memory) throw std::bad_alloc();
        refuse_damaged_jpeg(name, decompressor.failure.message.data());
    };
    if (!ends_without_jpeg_error(decompressor.failure, [&] {
            jpeg.err = &decompressor.failure.manager;
            jpeg_create_decompress(&jpeg);
            decompressor.progress.progress_monitor = limit_scans;
            jpeg.progress = &decompressor.progress;
            jpeg_mem_src(&jpeg, reinterpret_cast<const unsigned char*>(bytes.data()),
                         static_cast<unsigned long>(bytes.size()));
            jpeg_read_header(&jpeg, TRUE);
        }))
        refuse();
    if (jpeg.num_components > 3)
        throw InputError(
            fmt::format("{}: holds colours for print (CMYK); save it with RGB colours", name));
    const std::size_t pixels = std::size_t{jpeg.image_width} * jpeg.image_height;
    constexpr std::size_t pixels_of_a_byte = 1024;  // at most: every block takes a bit or more
    if (pixels > most_jpeg_pixels)
        throw InputError(fmt::format("{}: has {} × {} pixels; at most {} are read", name,
                                     jpeg.image_width, jpeg.image_height, most_jpeg_pixels));
    if (pixels / pixels_of_a_byte > bytes.size())
        refuse_damaged_jpeg(name, fmt::format("{} × {} pixels in {} bytes", jpeg.image_width,
                                              jpeg.image_height, bytes.size()));
    Image image(static_cast<int>(jpeg.image_width), static_cast<int>(jpeg.image_height));
    if (!ends_without_jpeg_error(decompressor.failure, [&] {
            jpeg.out_color_space = JCS_RGB;
            jpeg.dct_method = JDCT_ISLOW;
            jpeg_start_decompress(&jpeg);
            while (jpeg.output_scanline < jpeg.output_height) {
                JSAMPROW row = image.row(static_cast<int>(jpeg.output_scanline));
                jpeg_read_scanlines(&jpeg, &row, 1);
            }
            jpeg_finish_decompress(&jpeg);
        }))
        refuse();
    return image;
}

}  // namespace fumon
