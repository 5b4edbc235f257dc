#include "film/picture_prefetch.h"

#include <utility>

#include "base/thread_clock.h"

namespace fumon {

PicturePrefetch::PicturePrefetch(int threads) {
    if (threads > 1) pool_.emplace(threads, "fumon-ahead");
}

void PicturePrefetch::begin(const PictureRequest& wanted, Find find) {
    if (!pool_) return;
    wanted_ = wanted;
    found_ = std::async(std::launch::async, [this, find = std::move(find)] {
        name_this_thread("fumon-ahead");
        return find(*pool_);
    });
}

std::optional<ReadyPicture> PicturePrefetch::take(const PictureRequest& wanted) {
    if (!found_.valid()) return std::nullopt;
    if (wanted_ == wanted) return found_.get();
    wait_idle();
    return std::nullopt;
}

void PicturePrefetch::wait_idle() {
    if (found_.valid()) found_.wait();
    found_ = {};  // nor does anybody want what went wrong with it
}

}  // namespace fumon
