#include "picture/growing_movie.h"

#include <fmt/format.h>

#include <array>
#include <string>

#include "base/error.h"
#include "picture/libav_functions.h"

namespace fumon {

struct GrowingMovie::Parts {
    std::filesystem::path file;
    AVFormatContext* container = nullptr;
    AVStream* stream = nullptr;
    AVPacket* copy = nullptr;
    AVRational frame{1, 1};
    bool begun = false;

    explicit Parts(std::filesystem::path file_) : file(std::move(file_)) {}
    Parts(const Parts&) = delete;
    Parts& operator=(const Parts&) = delete;
    ~Parts() {
        if (begun) libav().av_write_trailer(container);
        if (container != nullptr) libav().avio_closep(&container->pb);
        libav().avformat_free_context(container);
        libav().av_packet_free(&copy);
    }

    void check(int code) const {
        if (code >= 0) return;
        std::array<char, AV_ERROR_MAX_STRING_SIZE> text{};
        libav().av_strerror(code, text.data(), text.size());
        throw Error(fmt::format("cannot write {}: {}", file.string(), text.data()));
    }
};

GrowingMovie::GrowingMovie(const std::filesystem::path& file, const MovieFormat& format,
                           const AVCodecParameters& coded, int numerator, int denominator)
    : parts_(std::make_unique<Parts>(file)) {
    Parts& parts = *parts_;
    const std::string muxer(format.muxer);
    const std::string url = "file:" + file.string();
    parts.check(libav().avformat_alloc_output_context2(&parts.container, nullptr, muxer.c_str(),
                                                       url.c_str()));
    parts.container->flags |= AVFMT_FLAG_BITEXACT | AVFMT_FLAG_FLUSH_PACKETS;
    parts.frame = {numerator, denominator};
    parts.stream = libav().avformat_new_stream(parts.container, nullptr);
    parts.copy = libav().av_packet_alloc();
    if (parts.stream == nullptr || parts.copy == nullptr) parts.check(AVERROR(ENOMEM));
    parts.check(libav().avcodec_parameters_copy(parts.stream->codecpar, &coded));
    parts.stream->time_base = parts.frame;
    parts.stream->avg_frame_rate = av_inv_q(parts.frame);
    parts.check(libav().avio_open(&parts.container->pb, url.c_str(), AVIO_FLAG_WRITE));
    AVDictionary* options = nullptr;
    if (muxer == "mp4" || muxer == "mov")
        libav().av_dict_set(&options, "movflags", "+frag_keyframe+empty_moov+default_base_moof", 0);
    const int written = libav().avformat_write_header(parts.container, &options);
    libav().av_dict_free(&options);
    parts.check(written);
    parts.begun = true;
}

GrowingMovie::~GrowingMovie() = default;

void GrowingMovie::add(const AVPacket& packet) {
    Parts& parts = *parts_;
    parts.check(libav().av_packet_ref(parts.copy, &packet));
    parts.copy->stream_index = parts.stream->index;
    parts.copy->duration = 1;  // frame
    libav().av_packet_rescale_ts(parts.copy, parts.frame, parts.stream->time_base);
    parts.check(libav().av_interleaved_write_frame(parts.container, parts.copy));
    if (parts.container->pb != nullptr) {
        libav().avio_flush(parts.container->pb);
        parts.check(parts.container->pb->error);
    }
}

}  // namespace fumon
