#include "picture/stills/picture_file.h"

#include <fmt/format.h>

#include <string>

#include "base/error.h"
#include "files/input_file.h"
#include "files/png_reader.h"
#include "picture/stills/jpeg.h"
#include "picture/stills/tiff.h"
#include "picture/stills/webp.h"

namespace fumon {

namespace {

[[noreturn]] void refuse_other(const std::filesystem::path& file) {
    throw InputError(
        fmt::format("{}: is not a PNG, JPEG, WebP or TIFF file; name one that is", file.string()));
}

}  // namespace

PictureFormat picture_format(const std::filesystem::path& file) {
    std::string ending = file.extension().string();
    for (char& letter : ending) {
        if (letter >= 'A' && letter <= 'Z') letter = static_cast<char>(letter - 'A' + 'a');
    }
    if (ending == ".jpg" || ending == ".jpeg") return PictureFormat::jpeg;
    if (ending == ".tif" || ending == ".tiff") return PictureFormat::tiff;
    return ending == ".webp" ? PictureFormat::webp : PictureFormat::png;
}

std::string_view name_of(PictureFormat format) {
    if (format == PictureFormat::jpeg) return "JPEG";
    if (format == PictureFormat::tiff) return "TIFF";
    return format == PictureFormat::webp ? "WebP" : "PNG";
}

std::vector<std::uint8_t> encode_picture(const Image& image, PictureFormat format,
                                         const PictureCoding& coding, double dots_per_inch,
                                         const PictureText& texts) {
    if (format == PictureFormat::png) return encode_png(image, dots_per_inch, texts);
    if (!image.rgb16.empty()) {
        throw InputError(
            fmt::format("{} holds 8 bits a channel, not 16; write a PNG", name_of(format)));
    }
    if (format == PictureFormat::tiff) return encode_tiff(image, dots_per_inch, texts);
    if (format == PictureFormat::webp)
        return encode_webp(image, coding.lossless, coding.quality, dots_per_inch, texts);
    if (coding.lossless) throw InputError("JPEG is always lossy; write a WebP or PNG");
    return encode_jpeg(image, coding.quality, dots_per_inch, texts);
}

bool is_picture(std::string_view head) {
    return is_png(head) || is_jpeg(head) || is_webp(head) || is_tiff(head);
}

PictureText read_picture_texts(const std::filesystem::path& file) {
    const std::string bytes = read_input_file(file);
    if (is_png(bytes)) return PngReader(bytes, file.string()).texts();
    if (is_jpeg(bytes)) return jpeg_texts(bytes, file.string());
    if (is_webp(bytes)) return webp_texts(bytes, file.string());
    if (is_tiff(bytes)) return tiff_texts(bytes, file.string());
    refuse_other(file);
}

Image read_picture(const std::filesystem::path& file) {
    const std::string bytes = read_input_file(file);
    if (is_png(bytes)) return PngReader(bytes, file.string()).image();
    if (is_jpeg(bytes)) return decode_jpeg(bytes, file.string());
    if (is_webp(bytes)) return decode_webp(bytes, file.string());
    if (is_tiff(bytes)) return decode_tiff(bytes, file.string());
    refuse_other(file);
}

}  // namespace fumon
