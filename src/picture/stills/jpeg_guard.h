#pragma once

#include <cstddef>
#include <cstdio>
// after them, which it needs
#include <jerror.h>
#include <jpeglib.h>

#include <array>
#include <csetjmp>

namespace fumon {

/// What libjpeg said when it gave up, and where to go on; give `manager` to libjpeg. `strict`: what
/// it warns of ends its work too, as a truncated file does.
struct JpegFailure {
    jpeg_error_mgr manager{};  // first: libjpeg hands back a pointer to it
    std::array<char, JMSG_LENGTH_MAX> message{};
    std::jmp_buf back{};
    bool strict = false;
    bool out_of_memory = false;

    explicit JpegFailure(bool strict_) : strict(strict_) {
        jpeg_std_error(&manager);
        manager.error_exit = exit_on_error;
        manager.emit_message = warn;
        manager.output_message = [](j_common_ptr /*jpeg*/) {};
    }

  private:
    [[noreturn]] static void exit_on_error(j_common_ptr jpeg) {
        auto* failure = reinterpret_cast<JpegFailure*>(jpeg->err);
        failure->manager.format_message(jpeg, failure->message.data());
        failure->out_of_memory = failure->manager.msg_code == JERR_OUT_OF_MEMORY;
        std::longjmp(failure->back, 1);  // NOLINT(cert-err52-cpp)
    }
    static void warn(j_common_ptr jpeg, int level) {
        if (level < 0 && reinterpret_cast<JpegFailure*>(jpeg->err)->strict) exit_on_error(jpeg);
    }
};

/// Calls work() and says whether it ended without an error of libjpeg's. libjpeg reports errors by
/// longjmp, which skips destructors: work may call libjpeg only while no object with a destructor
/// lives inside it.
template <class Work>
bool ends_without_jpeg_error(JpegFailure& failure, const Work& work) {
    if (setjmp(failure.back) != 0) return false;  // NOLINT(cert-err52-cpp)
    work();
    return true;
}

}  // namespace fumon
