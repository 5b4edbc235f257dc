#include "picture/stills/tiff.h"

#include <fmt/format.h>
#include <tiffio.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdarg>
#include <cstddef>
#include <cstdio>
#include <cstring>
#include <memory>

#include "base/error.h"
#include "picture/pixels/srgb_profile.h"
#include "picture/stills/cmyk.h"
#include "picture/stills/xmp.h"

namespace fumon {

namespace {

constexpr std::size_t most_tiff_pixels = std::size_t{1} << 28U;
constexpr std::uint8_t paper_white = 255;

/// A file in memory that libtiff writes or reads, and what it says of errors.
struct TiffMemory {
    std::vector<std::uint8_t> written;
    std::string_view read;  ///< of a file that is read
    bool reading = false;
    std::size_t at = 0;
    std::array<char, 200> message{};

    static TiffMemory& of(thandle_t handle) { return *static_cast<TiffMemory*>(handle); }
    [[nodiscard]] std::size_t size() const { return reading ? read.size() : written.size(); }
};

tmsize_t read_some(thandle_t handle, void* to, tmsize_t wanted) {
    TiffMemory& memory = TiffMemory::of(handle);
    if (!memory.reading || wanted < 0) return 0;
    const std::size_t left = memory.size() - std::min(memory.at, memory.size());
    const std::size_t count = std::min(static_cast<std::size_t>(wanted), left);
    if (count > 0) std::memcpy(to, memory.read.data() + memory.at, count);
    memory.at += count;
    return static_cast<tmsize_t>(count);
}

tmsize_t write_some(thandle_t handle, void* from, tmsize_t given) {
    TiffMemory& memory = TiffMemory::of(handle);
    if (memory.reading || given < 0) return 0;
    const auto count = static_cast<std::size_t>(given);
    if (memory.written.size() < memory.at + count) memory.written.resize(memory.at + count);
    if (count > 0) std::memcpy(memory.written.data() + memory.at, from, count);
    memory.at += count;
    return given;
}

toff_t seek_to(thandle_t handle, toff_t offset, int from) {
    TiffMemory& memory = TiffMemory::of(handle);
    std::size_t base = 0;
    if (from == SEEK_CUR) base = memory.at;
    if (from == SEEK_END) base = memory.size();
    memory.at = base + static_cast<std::size_t>(offset);
    return memory.at;
}

int close_nothing(thandle_t /*handle*/) {
    return 0;
}

toff_t size_of(thandle_t handle) {
    return TiffMemory::of(handle).size();
}

int keep_message(TIFF* /*tiff*/, void* memory, const char* /*module*/, const char* format,
                 va_list values) {
    auto& message = static_cast<TiffMemory*>(memory)->message;
    if (message[0] == '\0') std::vsnprintf(message.data(), message.size(), format, values);
    return 1;
}

int keep_quiet(TIFF* /*tiff*/, void* /*memory*/, const char* /*module*/, const char* /*format*/,
               va_list /*values*/) {
    return 1;
}

using Tiff = std::unique_ptr<TIFF, decltype(&TIFFClose)>;

Tiff open_tiff(TiffMemory& memory, const char* mode) {
    const std::unique_ptr<TIFFOpenOptions, decltype(&TIFFOpenOptionsFree)> options(
        TIFFOpenOptionsAlloc(), &TIFFOpenOptionsFree);
    TIFFOpenOptionsSetErrorHandlerExtR(options.get(), keep_message, &memory);
    TIFFOpenOptionsSetWarningHandlerExtR(options.get(), keep_quiet, &memory);
    TIFFOpenOptionsSetMaxSingleMemAlloc(options.get(), tmsize_t{1} << 30U);
    return {TIFFClientOpenExt("picture", mode, &memory, read_some, write_some, seek_to,
                              close_nothing, size_of, nullptr, nullptr, options.get()),
            &TIFFClose};
}

[[noreturn]] void refuse_damaged_tiff(const std::string& name, const TiffMemory& memory) {
    const std::string why = memory.message[0] == '\0' ? "it ends early" : memory.message.data();
    throw InputError(fmt::format("{}: is a damaged TIFF file ({}); make it again", name, why));
}

/// Opens bytes to be read; throws InputError where they are damaged.
Tiff open_tiff_of(std::string_view bytes, TiffMemory& memory, const std::string& name) {
    memory.reading = true;
    memory.read = bytes;
    Tiff tiff = open_tiff(memory, "rm");
    if (!tiff) refuse_damaged_tiff(name, memory);
    return tiff;
}

/// Rows of channels, one after the other.
struct Channels {
    int count = 3;
    std::vector<std::uint8_t> values;
};

Channels channels_of(const Image& image, const std::string& cmyk_profile) {
    if (!cmyk_profile.empty()) {
        const Image opaque = image.transparent() ? composited_on(image, paper_white) : Image();
        return {4, cmyk_of(image.transparent() ? opaque : image, cmyk_profile)};
    }
    if (!image.transparent()) return {3, image.rgb};
    Channels channels{4, {}};
    channels.values.reserve(4 * image.alpha.size());
    for (std::size_t i = 0; i < image.alpha.size(); ++i) {
        for (std::size_t c = 0; c < 3; ++c) channels.values.push_back(image.rgb[3 * i + c]);
        channels.values.push_back(image.alpha[i]);
    }
    return channels;
}

}  // namespace

std::vector<std::uint8_t> encode_tiff(const Image& image, double dots_per_inch,
                                      const PictureText& texts, const std::string& cmyk_profile) {
    constexpr std::size_t most_bytes = std::size_t{1} << 30U;
    const std::size_t pixels =
        static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
    if (image.width < 1 || image.height < 1 || 4 * pixels > most_bytes)
        throw InputError(
            fmt::format("a picture of {} × {} pixels is too large for TIFF; write a PNG",
                        image.width, image.height));
    Channels channels = channels_of(image, cmyk_profile);
    const std::string profile = cmyk_profile.empty() ? srgb_profile() : cmyk_profile;
    const std::string packet = texts.empty() ? "" : xmp_packet(texts);
    TiffMemory memory;
    bool good = true;
    {
        const Tiff tiff = open_tiff(memory, "wl");  // lowest byte first, of every machine
        if (!tiff) throw Error("cannot begin a TIFF file");
        const auto set = [&](std::uint32_t tag, auto... values) {
            good = good && TIFFSetField(tiff.get(), tag, values...) == 1;
        };
        set(TIFFTAG_IMAGEWIDTH, static_cast<std::uint32_t>(image.width));
        set(TIFFTAG_IMAGELENGTH, static_cast<std::uint32_t>(image.height));
        set(TIFFTAG_BITSPERSAMPLE, 8);
        set(TIFFTAG_SAMPLESPERPIXEL, channels.count);
        set(TIFFTAG_PHOTOMETRIC, cmyk_profile.empty() ? PHOTOMETRIC_RGB : PHOTOMETRIC_SEPARATED);
        if (!cmyk_profile.empty()) {
            set(TIFFTAG_INKSET, INKSET_CMYK);
        } else if (channels.count == 4) {
            std::uint16_t kind = EXTRASAMPLE_UNASSALPHA;
            set(TIFFTAG_EXTRASAMPLES, 1, &kind);
        }
        set(TIFFTAG_PLANARCONFIG, PLANARCONFIG_CONTIG);
        set(TIFFTAG_ORIENTATION, ORIENTATION_TOPLEFT);
        set(TIFFTAG_COMPRESSION, COMPRESSION_LZW);
        set(TIFFTAG_PREDICTOR, PREDICTOR_HORIZONTAL);
        set(TIFFTAG_XRESOLUTION, dots_per_inch);
        set(TIFFTAG_YRESOLUTION, dots_per_inch);
        set(TIFFTAG_RESOLUTIONUNIT, RESUNIT_INCH);
        set(TIFFTAG_ICCPROFILE, static_cast<std::uint32_t>(profile.size()), profile.data());
        if (!packet.empty())
            set(TIFFTAG_XMLPACKET, static_cast<std::uint32_t>(packet.size()), packet.data());
        for (const auto& [keyword, text] : texts) {
            if (keyword == "Software") set(TIFFTAG_SOFTWARE, text.c_str());
        }
        const std::size_t row =
            static_cast<std::size_t>(channels.count) * static_cast<std::size_t>(image.width);
        constexpr std::size_t strip = std::size_t{1} << 18U;  // bytes
        set(TIFFTAG_ROWSPERSTRIP, static_cast<std::uint32_t>(std::clamp<std::size_t>(
                                      strip / row, 1, static_cast<std::size_t>(image.height))));
        for (int y = 0; y < image.height && good; ++y) {
            good = TIFFWriteScanline(tiff.get(),
                                     channels.values.data() + row * static_cast<std::size_t>(y),
                                     static_cast<std::uint32_t>(y), 0) == 1;
        }
        good = good && TIFFFlush(tiff.get()) == 1;
    }
    if (!good) throw Error(fmt::format("cannot write a TIFF file: {}", memory.message.data()));
    return std::move(memory.written);
}

bool is_tiff(std::string_view bytes) {
    for (const std::string_view mark :
         {std::string_view("II*\0", 4), std::string_view("MM\0*", 4), std::string_view("II+\0", 4),
          std::string_view("MM\0+", 4)}) {
        if (bytes.starts_with(mark)) return true;
    }
    return false;
}

PictureText tiff_texts(std::string_view bytes, const std::string& name) {
    TiffMemory memory;
    const Tiff tiff = open_tiff_of(bytes, memory, name);
    std::uint32_t size = 0;
    const void* packet = nullptr;
    if (TIFFGetField(tiff.get(), TIFFTAG_XMLPACKET, &size, &packet) != 1) return {};
    return texts_of_xmp({static_cast<const char*>(packet), size});
}

Image decode_tiff(std::string_view bytes, const std::string& name) {
    TiffMemory memory;
    const Tiff tiff = open_tiff_of(bytes, memory, name);
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    std::uint16_t colours = 0;
    TIFFGetField(tiff.get(), TIFFTAG_IMAGEWIDTH, &width);
    TIFFGetField(tiff.get(), TIFFTAG_IMAGELENGTH, &height);
    if (TIFFGetField(tiff.get(), TIFFTAG_PHOTOMETRIC, &colours) == 1 &&
        colours == PHOTOMETRIC_SEPARATED)
        throw InputError(
            fmt::format("{}: holds colours for print (CMYK); save it with RGB colours", name));
    const std::size_t pixels = std::size_t{width} * height;
    constexpr std::size_t longest = std::size_t{1} << 24U;  // side
    if (width > longest || height > longest || pixels > most_tiff_pixels)
        throw InputError(fmt::format("{}: has {} × {} pixels; at most {} are read", name, width,
                                     height, most_tiff_pixels));
    constexpr std::size_t pixels_of_a_byte = 4096;  // at most
    if (pixels == 0 || pixels / pixels_of_a_byte > bytes.size()) refuse_damaged_tiff(name, memory);
    std::vector<std::uint32_t> rgba(pixels);
    if (TIFFReadRGBAImageOriented(tiff.get(), width, height, rgba.data(), ORIENTATION_TOPLEFT, 1) !=
        1)
        refuse_damaged_tiff(name, memory);
    std::uint16_t extra = 0;
    const std::uint16_t* kinds = nullptr;
    const bool has_transparency =
        TIFFGetField(tiff.get(), TIFFTAG_EXTRASAMPLES, &extra, &kinds) == 1 && extra > 0 &&
        (kinds[0] == EXTRASAMPLE_UNASSALPHA || kinds[0] == EXTRASAMPLE_ASSOCALPHA);
    Image image(static_cast<int>(width), static_cast<int>(height));
    if (has_transparency) image.alpha.resize(pixels);
    for (std::size_t i = 0; i < pixels; ++i) {
        const std::uint32_t alpha = TIFFGetA(rgba[i]);
        const auto whole = [&](std::uint32_t level) {  // libtiff hands them out times the opacity
            const std::uint32_t value =
                has_transparency && alpha > 0 ? (level * 255U + alpha / 2U) / alpha : level;
            return static_cast<std::uint8_t>(std::min(value, 255U));
        };
        image.rgb[3 * i] = whole(TIFFGetR(rgba[i]));
        image.rgb[3 * i + 1] = whole(TIFFGetG(rgba[i]));
        image.rgb[3 * i + 2] = whole(TIFFGetB(rgba[i]));
        if (has_transparency) image.alpha[i] = static_cast<std::uint8_t>(alpha);
    }
    return image;
}

}  // namespace fumon
