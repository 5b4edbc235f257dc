// A movie by libavcodec, libavformat and libswscale:
//
//   Image -> rgb -> scaler -> yuv -> codec -> packet -> without_version -+-> container -> NAME.part
//     |      padded to even sides      ^                                 +-> so_far
//     +-> palette indices (GIF) -------+
//
// 1. The same frames give the same bytes: a fixed number of codec threads, the bit-exact flags of
//    codec, container and scaler, and accurate rounding. The units in which x264 and x265 sign
//    their streams with version and settings are filtered out.
// 2. yuv formats are BT.709 of limited range, and are tagged so.
// 3. A key frame comes at least every second (gop_size is the rate), so that players can seek.
// 4. The file appears whole: it is written as NAME.part and renamed when its trailer is written; a
//    movie that is not finished is deleted. `so_far` is a second file that plays at any time
//    (GrowingMovie) and stays; where the disk has no room for both, it is the one that goes.
// 5. Muxers may forget errors of buffered writes; the stream's own error is asked for after each
//    write (check_file).
// 6. The libraries are loaded when the first movie is made: libav() holds their functions.

#include "picture/movie.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "base/error.h"
#include "files/atomic_file.h"
#include "files/input_file.h"
#include "picture/encoder_options.h"
#include "picture/frame_rate.h"
#include "picture/growing_movie.h"
#include "picture/libav_functions.h"
#include "picture/movie_pixels.h"

namespace fumon {

namespace {

/// Fixed: the bytes depend on it. x264, which is held to a rate, asks its other threads how far
/// they are, so that two would give other bytes each time.
int codec_threads(const MovieFormat& format) {
    return format.name == "h264" ? 1 : 2;
}

template <auto release>
struct Release {
    template <class Handle>
    void operator()(Handle* handle) const {
        (libav().*release)(&handle);
    }
};
struct ReleaseScaler {
    void operator()(SwsContext* scaler) const { libav().sws_freeContext(scaler); }
};
/// Closes the file, too, if it is still open.
struct ReleaseContainer {
    void operator()(AVFormatContext* container) const {
        libav().avio_closep(&container->pb);
        libav().avformat_free_context(container);
    }
};

std::string reason(int code) {
    std::array<char, AV_ERROR_MAX_STRING_SIZE> text{};
    libav().av_strerror(code, text.data(), text.size());
    return text.data();
}

/// Where a movie is written until it is whole.
std::filesystem::path temporary_of(const std::filesystem::path& file, const MovieCoding& coding) {
    std::filesystem::path temporary = temporary_name(file);
    if (coding.so_far != temporary) return temporary;
    temporary = file;
    return temporary_name(temporary += ".whole");
}

int even(int side) {
    return side + side % 2;
}

}  // namespace

struct Movie::Parts {
    std::filesystem::path file;
    std::filesystem::path temporary;
    int width = 0;
    int height = 0;
    std::int64_t frames = 0;
    bool failed = false;
    bool finished = false;

    std::unique_ptr<AVFormatContext, ReleaseContainer> container;
    std::unique_ptr<AVCodecContext, Release<&LibavFunctions::avcodec_free_context>> codec;
    std::unique_ptr<AVBSFContext, Release<&LibavFunctions::av_bsf_free>> without_version;
    std::unique_ptr<AVFrame, Release<&LibavFunctions::av_frame_free>> rgb;
    std::unique_ptr<AVFrame, Release<&LibavFunctions::av_frame_free>> yuv;
    std::unique_ptr<AVPacket, Release<&LibavFunctions::av_packet_free>> packet;
    std::unique_ptr<SwsContext, ReleaseScaler> scaler;
    AVStream* stream = nullptr;  ///< the container's
    std::optional<GrowingMovie> so_far;

    MovieCoding coding;

    /// Whether its frames have alpha.
    [[nodiscard]] bool open() const {
        return coding.transparent && !coding.format.open_pixels.empty();
    }

    Parts(const std::filesystem::path& file_, int width_, int height_, const MovieCoding& coding_)
        : file(resolved_link(file_)),
          temporary(temporary_of(file, coding_)),
          width(width_),
          height(height_),
          coding(coding_) {
        if (!takes_a_rename(file)) fail("it is a pipe or a device; a movie needs a file on disk");
    }
    Parts(const Parts&) = delete;
    Parts& operator=(const Parts&) = delete;
    ~Parts() {
        if (finished) return;
        if (so_far && !failed) drain_into_so_far();
        abandon();
    }

    /// A disk without room for both movies has the one that counts.
    void add_to_so_far() {
        if (!so_far) return;
        try {
            so_far->add(*packet);
        } catch (const Error&) {
            so_far.reset();
            ::unlink(coding.so_far.c_str());
        }
    }

    /// What the encoder still holds.
    void drain_into_so_far() {
        try {
            encode(nullptr);
        } catch (const Error&) {
            return;  // it plays up to where it could be written
        }
    }

    [[noreturn]] void fail(std::string_view why) {
        failed = true;
        throw Error(fmt::format("cannot write {}: {}", file.string(), why));
    }
    void check(int code) {
        if (code < 0) fail(reason(code));
    }
    /// Errors of buffered writes are kept in the stream, and some muxers forget to pass them on.
    void check_file() {
        if (container->pb != nullptr) check(container->pb->error);
    }
    template <class Pointer>
    Pointer checked(Pointer pointer) {
        if (pointer == nullptr) fail("out of memory");
        return pointer;
    }
    void abandon() {
        const bool opened = container != nullptr;
        container.reset();
        if (opened) ::unlink(temporary.c_str());
    }

    void open_codec(AVRational rate);
    void open_converter();
    void open_container(AVRational rate);
    void open_filter();
    void encode(const AVFrame* frame);
    void write_filtered(AVPacket* input);
};

void Movie::Parts::open_codec(AVRational rate) {
    const std::string name(coding.format.encoder);
    const AVCodec* encoder = libav().avcodec_find_encoder_by_name(name.c_str());
    if (encoder == nullptr) {
        fail(
            fmt::format("libavcodec has no encoder {} for {}; install Debian's libavcodec, or an "
                        "FFmpeg built with it, or write no such movie",
                        name, coding.format.name));
    }
    codec.reset(checked(libav().avcodec_alloc_context3(encoder)));
    const bool even_sides = coding.format.even_sides;
    codec->width = even_sides ? even(width) : width;
    codec->height = even_sides ? even(height) : height;
    const std::string_view pixels = open() ? coding.format.open_pixels : coding.format.pixels;
    codec->pix_fmt = libav().av_get_pix_fmt(std::string(pixels).c_str());
    codec->time_base = av_inv_q(rate);
    codec->framerate = rate;
    if (pixels.starts_with("yuv")) {
        codec->colorspace = AVCOL_SPC_BT709;
        codec->color_primaries = AVCOL_PRI_BT709;
        codec->color_trc = AVCOL_TRC_BT709;
        codec->color_range = AVCOL_RANGE_MPEG;
        codec->chroma_sample_location = AVCHROMA_LOC_LEFT;
    }
    codec->thread_count = codec_threads(coding.format);
    codec->gop_size = std::max(1, static_cast<int>(std::lround(av_q2d(rate))));
    codec->flags |= AV_CODEC_FLAG_BITEXACT;
    if (coding.format.muxer != "gif" && coding.format.muxer != "webp")
        codec->flags |= AV_CODEC_FLAG_GLOBAL_HEADER;
    for (const auto& [option, value] : encoder_options(coding.format, {width, height, av_q2d(rate)},
                                                       coding.quality, coding.quickly)) {
        if (option == "tag") {
            codec->codec_tag = 0;
            for (std::size_t i = value.size(); i-- > 0;)
                codec->codec_tag = codec->codec_tag << 8U | static_cast<unsigned char>(value[i]);
        } else {
            check(libav().av_opt_set(codec.get(), option.c_str(), value.c_str(),
                                     AV_OPT_SEARCH_CHILDREN));
        }
    }
    if (open() && coding.format.name == "webm")  // whose frames of alpha have no hidden ones
        check(libav().av_opt_set(codec.get(), "auto-alt-ref", "0", AV_OPT_SEARCH_CHILDREN));
    ::setenv("SVT_LOG", "0", 0);  // SVT-AV1 else tells of itself on standard error
    check(libav().avcodec_open2(codec.get(), encoder, nullptr));
}

void Movie::Parts::open_converter() {
    rgb.reset(checked(libav().av_frame_alloc()));
    yuv.reset(checked(libav().av_frame_alloc()));
    packet.reset(checked(libav().av_packet_alloc()));
    const AVPixelFormat rgb_format = open() ? AV_PIX_FMT_RGBA : AV_PIX_FMT_RGB24;
    for (AVFrame* frame : {rgb.get(), yuv.get()}) {
        frame->width = codec->width;
        frame->height = codec->height;
        frame->format = frame == rgb.get() ? rgb_format : codec->pix_fmt;
        check(libav().av_frame_get_buffer(frame, 0));
    }
    // ProRes tells the colours of each frame in the frame.
    yuv->colorspace = codec->colorspace;
    yuv->color_primaries = codec->color_primaries;
    yuv->color_trc = codec->color_trc;
    yuv->color_range = codec->color_range;
    yuv->chroma_location = codec->chroma_sample_location;
    if (coding.colours != nullptr) return;
    constexpr int accurate = SWS_BILINEAR | SWS_ACCURATE_RND | SWS_BITEXACT | SWS_FULL_CHR_H_INP;
    scaler.reset(checked(libav().sws_getContext(codec->width, codec->height, rgb_format,
                                                codec->width, codec->height, codec->pix_fmt,
                                                accurate, nullptr, nullptr, nullptr)));
    const std::string_view into = open() ? coding.format.open_pixels : coding.format.pixels;
    if (!into.starts_with("yuv")) return;
    const int* bt709 = libav().sws_getCoefficients(SWS_CS_ITU709);
    constexpr int full_range = 1;
    constexpr int limited_range = 0;
    constexpr int unchanged = 1 << 16;  // contrast and saturation, 16.16 fixed point
    if (libav().sws_setColorspaceDetails(scaler.get(), bt709, full_range, bt709, limited_range, 0,
                                         unchanged, unchanged) < 0)
        fail("libswscale cannot convert to BT.709");
}

void Movie::Parts::open_container(AVRational rate) {
    std::error_code ignored;
    if (std::filesystem::exists(file, ignored) && !std::filesystem::is_regular_file(file, ignored))
        fail("there is something other than a regular file");
    AVFormatContext* made = nullptr;
    // "file:" keeps libavformat from reading a protocol out of a name with a colon.
    const std::string url = "file:" + temporary.string();
    const std::string muxer(coding.format.muxer);
    check(libav().avformat_alloc_output_context2(&made, nullptr, muxer.c_str(), url.c_str()));
    container.reset(made);
    container->flags |= AVFMT_FLAG_BITEXACT;
    stream = checked(libav().avformat_new_stream(container.get(), nullptr));
    check(libav().avcodec_parameters_from_context(stream->codecpar, codec.get()));
    stream->time_base = codec->time_base;
    stream->avg_frame_rate = rate;
    stream->r_frame_rate = rate;
    ::unlink(temporary.c_str());  // what an interrupted run may have left
    check(libav().avio_open(&container->pb, url.c_str(), AVIO_FLAG_WRITE));
    AVDictionary* options = nullptr;
    if (muxer == "mp4" || muxer == "mov")
        libav().av_dict_set(&options, "movflags", "+faststart+use_metadata_tags", 0);
    if (muxer == "webp") libav().av_dict_set(&options, "loop", "0", 0);
    if (muxer == "apng") libav().av_dict_set(&options, "plays", "0", 0);
    const int written = libav().avformat_write_header(container.get(), &options);
    libav().av_dict_free(&options);
    check(written);
    check_file();
}

/// x264 signs its streams with a version and its settings, in a SEI unit (type 6); x265 likewise
/// (types 39 and 40).
void Movie::Parts::open_filter() {
    AVBSFContext* made = nullptr;
    const char* filter = coding.format.name == "h264"   ? "filter_units=remove_types=6"
                         : coding.format.name == "hevc" ? "filter_units=remove_types=39|40"
                                                        : "null";
    check(libav().av_bsf_list_parse_str(filter, &made));
    without_version.reset(made);
    check(libav().avcodec_parameters_copy(without_version->par_in, stream->codecpar));
    without_version->time_base_in = codec->time_base;
    check(libav().av_bsf_init(without_version.get()));
}

void Movie::Parts::write_filtered(AVPacket* input) {
    check(libav().av_bsf_send_packet(without_version.get(), input));
    for (;;) {
        const int code = libav().av_bsf_receive_packet(without_version.get(), packet.get());
        if (code == AVERROR(EAGAIN) || code == AVERROR_EOF) return;
        check(code);
        add_to_so_far();
        packet->stream_index = stream->index;
        packet->duration = 1;  // frame; the last one would have none
        libav().av_packet_rescale_ts(packet.get(), codec->time_base, stream->time_base);
        check(libav().av_interleaved_write_frame(container.get(), packet.get()));
        check_file();
    }
}

/// One frame, or nullptr to drain the encoder.
void Movie::Parts::encode(const AVFrame* frame) {
    check(libav().avcodec_send_frame(codec.get(), frame));
    for (;;) {
        const int code = libav().avcodec_receive_packet(codec.get(), packet.get());
        if (code == AVERROR(EAGAIN)) return;
        if (code == AVERROR_EOF) break;
        check(code);
        write_filtered(packet.get());
    }
    write_filtered(nullptr);
}

Movie::Movie(const std::filesystem::path& file, int width, int height, double frames_per_second,
             int quality)
    : Movie(file, width, height, frames_per_second, MovieCoding{movie_formats().front(), quality}) {
}

Movie::Movie(const std::filesystem::path& file, int width, int height, double frames_per_second,
             const MovieCoding& coding)
    : parts_(std::make_unique<Parts>(file, width, height, coding)) {
    libav().av_log_set_level(AV_LOG_QUIET);
    if (width < 1 || height < 1 || !(frames_per_second > 0.0) || !std::isfinite(frames_per_second))
        parts_->fail(fmt::format("a movie of {} × {} pixels at {} frames per second cannot be made",
                                 width, height, frames_per_second));
    const FrameRate rate = frame_rate(frames_per_second);
    const AVRational rational{rate.frames, rate.seconds};
    parts_->open_codec(rational);
    parts_->open_converter();
    parts_->open_container(rational);
    parts_->open_filter();
    if (!coding.so_far.empty()) {
        const Parts& parts = *parts_;
        parts_->so_far.emplace(coding.so_far, coding.format, *parts.stream->codecpar,
                               parts.codec->time_base.num, parts.codec->time_base.den);
    }
}

Movie::~Movie() = default;

int Movie::padded_width() const {
    return parts_->codec->width;
}
int Movie::padded_height() const {
    return parts_->codec->height;
}

void Movie::add(const Image& image) {
    Parts& parts = *parts_;
    if (image.transparent() != parts.open())
        return add(parts.open() ? with_alpha(image) : composited_on(image, 255));
    if (parts.failed || parts.finished) parts.fail("it is already closed");
    if (image.width != parts.width || image.height != parts.height)
        parts.fail(fmt::format("a frame has {} × {} pixels, the movie {} × {}", image.width,
                               image.height, parts.width, parts.height));
    parts.check(libav().av_frame_make_writable(parts.yuv.get()));
    if (parts.coding.colours != nullptr) {
        copy_indexed(image, *parts.coding.colours, *parts.yuv);
    } else {
        if (parts.open()) {
            copy_padded_open(image, *parts.rgb);
        } else {
            copy_padded(image, *parts.rgb);
        }
        const int lines =
            libav().sws_scale(parts.scaler.get(), parts.rgb->data, parts.rgb->linesize, 0,
                              parts.rgb->height, parts.yuv->data, parts.yuv->linesize);
        if (lines != parts.yuv->height) parts.fail("libswscale did not convert a frame");
    }
    parts.yuv->pts = parts.frames++;
    parts.encode(parts.yuv.get());
}

void Movie::finish(const PictureText& texts) {
    Parts& parts = *parts_;
    if (parts.finished) return;
    if (parts.failed) parts.fail("an earlier write failed");
    if (parts.frames == 0) {
        parts.abandon();
        parts.finished = true;
        return;
    }
    parts.encode(nullptr);
    for (const auto& [keyword, text] : texts)
        parts.check(
            libav().av_dict_set(&parts.container->metadata, keyword.c_str(), text.c_str(), 0));
    parts.check(libav().av_write_trailer(parts.container.get()));
    parts.check_file();
    parts.check(libav().avio_closep(&parts.container->pb));
    parts.so_far.reset();
    std::error_code error;
    std::filesystem::rename(parts.temporary, parts.file, error);
    if (error) parts.fail(error.message());
    parts.finished = true;
}

std::string movie_encoder() {
    const auto version = [](unsigned number) {
        return fmt::format("{}.{}.{}", AV_VERSION_MAJOR(number), AV_VERSION_MINOR(number),
                           AV_VERSION_MICRO(number));
    };
    return fmt::format("libavcodec {}, libavformat {}, libswscale {}",
                       version(libav().avcodec_version()), version(libav().avformat_version()),
                       version(libav().swscale_version()));
}

}  // namespace fumon
