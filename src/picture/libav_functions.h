#pragma once

extern "C" {
#include <libavcodec/avcodec.h>
#include <libavcodec/bsf.h>
#include <libavformat/avformat.h>
#include <libavutil/opt.h>
#include <libavutil/pixdesc.h>
#include <libswscale/swscale.h>
}

namespace fumon {

/// The functions of FFmpeg's libraries that are in use. They are loaded when they are first asked
/// for, since they bring seventy other libraries, and only movies need them.
struct LibavFunctions {
    static void* address_of(const char* name);

#define FUMON_LIBAV(name) \
    decltype(&::name) name = reinterpret_cast<decltype(&::name)>(address_of(#name))
    FUMON_LIBAV(av_bsf_free);
    FUMON_LIBAV(av_bsf_init);
    FUMON_LIBAV(av_bsf_list_parse_str);
    FUMON_LIBAV(av_bsf_receive_packet);
    FUMON_LIBAV(av_bsf_send_packet);
    FUMON_LIBAV(av_dict_free);
    FUMON_LIBAV(av_dict_set);
    FUMON_LIBAV(av_frame_alloc);
    FUMON_LIBAV(av_frame_free);
    FUMON_LIBAV(av_frame_get_buffer);
    FUMON_LIBAV(av_frame_make_writable);
    FUMON_LIBAV(av_get_pix_fmt);
    FUMON_LIBAV(av_interleaved_write_frame);
    FUMON_LIBAV(av_log_set_level);
    FUMON_LIBAV(av_opt_set);
    FUMON_LIBAV(av_packet_alloc);
    FUMON_LIBAV(av_packet_free);
    FUMON_LIBAV(av_packet_ref);
    FUMON_LIBAV(av_packet_rescale_ts);
    FUMON_LIBAV(av_strerror);
    FUMON_LIBAV(av_write_trailer);
    FUMON_LIBAV(avcodec_alloc_context3);
    FUMON_LIBAV(avcodec_find_encoder_by_name);
    FUMON_LIBAV(avcodec_free_context);
    FUMON_LIBAV(avcodec_open2);
    FUMON_LIBAV(avcodec_parameters_copy);
    FUMON_LIBAV(avcodec_parameters_from_context);
    FUMON_LIBAV(avcodec_receive_packet);
    FUMON_LIBAV(avcodec_send_frame);
    FUMON_LIBAV(avcodec_version);
    FUMON_LIBAV(avformat_alloc_output_context2);
    FUMON_LIBAV(avformat_free_context);
    FUMON_LIBAV(avformat_new_stream);
    FUMON_LIBAV(avformat_version);
    FUMON_LIBAV(avformat_write_header);
    FUMON_LIBAV(avio_closep);
    FUMON_LIBAV(avio_flush);
    FUMON_LIBAV(avio_open);
    FUMON_LIBAV(sws_freeContext);
    FUMON_LIBAV(sws_getCoefficients);
    FUMON_LIBAV(sws_getContext);
    FUMON_LIBAV(sws_scale);
    FUMON_LIBAV(sws_setColorspaceDetails);
    FUMON_LIBAV(swscale_version);
#undef FUMON_LIBAV
};

/// Throws Error where FFmpeg's libraries cannot be loaded.
const LibavFunctions& libav();

}  // namespace fumon
