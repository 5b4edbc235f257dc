#include "film/picture_ahead.h"

#include <utility>

#include "base/thread_clock.h"

namespace fumon {

PictureAhead::PictureAhead(int threads) {
    if (threads > 1) pool_.emplace(threads, "fumon-ahead");
}

void PictureAhead::begin(const WantedPicture& wanted, Find find) {
    if (!pool_) return;
    wanted_ = wanted;
    found_ = std::async(std::launch::async, [this, find = std::move(find)] {
        name_this_thread("fumon-ahead");
        return find(*pool_);
    });
}

std::optional<ReadyPicture> PictureAhead::take(const WantedPicture& wanted) {
    if (!found_.valid()) return std::nullopt;
    if (wanted_ == wanted) return found_.get();
    leave();
    return std::nullopt;
}

void PictureAhead::leave() {
    if (found_.valid()) found_.wait();
    found_ = {};  // nor does anybody want what went wrong with it
}

}  // namespace fumon
