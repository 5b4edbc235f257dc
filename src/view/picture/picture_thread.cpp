#include "view/picture/picture_thread.h"

#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <memory>
#include <utility>

#include "base/error.h"
#include "base/stopwatch.h"
#include "base/worker_pool.h"
#include "picture/stills/picture_file.h"
#include "run/still.h"
#include "scene/overlay_keys.h"
#include "view/picture/draft_painter.h"

namespace fumon {

namespace {

constexpr std::size_t most_waiting = 32;  // fewer than the threads of the server
constexpr int draft_quality = 82;

std::string text_of(const std::vector<std::uint8_t>& bytes) {
    return {bytes.begin(), bytes.end()};
}

/// A flat figure, which no renderer draws.
bool is_flat(const Scene& scene, const Snapshot& first) {
    return first.section && scene.view.look.mode == ViewMode::figure;
}

std::string media_type(PictureFormat format) {
    switch (format) {
        case PictureFormat::jpeg:
            return "image/jpeg";
        case PictureFormat::webp:
            return "image/webp";
        case PictureFormat::tiff:
            return "image/tiff";
        case PictureFormat::png:
            break;
    }
    return "image/png";
}

}  // namespace

PictureThread::PictureThread(ViewSubject& subject, const LookChanges& changes,
                             const WorkOptions& work)
    : subject_(subject),
      changes_(changes),
      options_(work),
      drafts_([this] { this->work(true); }),
      pictures_([this] { this->work(false); }) {}

PictureThread::~PictureThread() {
    cancel_all();
    drafts_.join();
    pictures_.join();
}

void PictureThread::cancel_all() {
    {
        const std::lock_guard lock(mutex_);
        ended_ = true;
        DrawnPicture cancelled;
        cancelled.outcome = RequestOutcome::superseded;
        for (Waiting& left : waiting_) left.promise.set_value(cancelled);
        waiting_.clear();
    }
    wake_.notify_all();
}

DrawnPicture PictureThread::draw(ViewRequest request) {
    std::future<DrawnPicture> made;
    {
        const std::lock_guard lock(mutex_);
        DrawnPicture cancelled;
        cancelled.outcome = RequestOutcome::superseded;
        for (auto old = waiting_.begin(); old != waiting_.end();) {
            if (old->request.client == request.client) {
                old->promise.set_value(cancelled);
                old = waiting_.erase(old);
            } else {
                ++old;
            }
        }
        if (ended_) return cancelled;
        if (waiting_.size() >= most_waiting) {
            cancelled.outcome = RequestOutcome::too_many;
            return cancelled;
        }
        waiting_.push_back({std::move(request), {}});
        made = waiting_.back().promise.get_future();
    }
    wake_.notify_all();  // either thread may be meant
    return made.get();
}

PictureThread::Settled PictureThread::settled(const ViewRequest& request,
                                              const Snapshot& snapshot) const {
    std::vector<std::string> settings = request.settings;
    const auto size = [&](const char* key, int pixels) {
        if (pixels > 0 && !request.draft)
            settings.push_back(fmt::format("image.{}={}", key, pixels));
    };
    size("width", request.width);
    size("height", request.height);
    Settled settled{changes_.with(settings), {}};
    if (request.place) {
        settled.camera = settings_of(*request.place, settled.scene, subject_.first(), snapshot);
        settings.insert(settings.end(), settled.camera.begin(), settled.camera.end());
        settled.scene = changes_.with(settings);
    }
    return settled;
}

DrawnPicture PictureThread::drawn(const ViewRequest& request, DraftPainter& drafts,
                                  WorkerPool& pool) {
    const Stopwatch watch;
    DrawnPicture picture;
    const std::shared_ptr<const Snapshot> snapshot = subject_.snapshot(request.moment);
    if (!snapshot) {
        picture.outcome = RequestOutcome::computing;
        return picture;
    }
    auto [scene, camera] = settled(request, *snapshot);
    const Snapshot& first = subject_.first();
    picture.camera = std::move(camera);
    picture.step = snapshot->step;
    const PictureFormat format = picture_format("x" + request.ending);
    if (request.draft) {
        scene = draft_of(std::move(scene), request.width, request.height);
        const Image image = is_flat(scene, first)
                                ? make_frame_painter(scene, first, options_.backend, pool,
                                                     PaintedContent::one_picture)
                                      ->paint(*snapshot, {})
                                : drafts.paint(scene, first, snapshot);
        picture.type = "image/jpeg";
        picture.bytes =
            text_of(encode_picture(image, PictureFormat::jpeg, {draft_quality, false}, 96.0, {}));
    } else {
        check_still(scene, *snapshot, "x" + request.ending);
        const MeasuredRows rows = subject_.rows(plotted_columns(scene), request.moment);
        stand_on_drawn_ground(scene.view, first, *snapshot);
        const Drawing drawing =
            draw_snapshot({scene, subject_.inputs(), rows}, first, *snapshot, options_);
        picture.type = media_type(format);
        picture.bytes = text_of(still_file(scene, subject_.inputs(), snapshot->step, drawing,
                                           format, subject_.results()));
    }
    picture.seconds = watch.seconds();
    return picture;
}

void PictureThread::work(bool of_drafts) {
    WorkerPool pool(options_.threads, "fumon-view");
    DraftPainter drafts(options_.backend, pool);
    std::unique_lock lock(mutex_);
    for (;;) {
        auto next = waiting_.end();
        wake_.wait(lock, [&] {
            next = std::ranges::find_if(
                waiting_, [&](const Waiting& one) { return one.request.draft == of_drafts; });
            return ended_ || next != waiting_.end();
        });
        if (ended_) return;
        Waiting taken = std::move(*next);
        waiting_.erase(next);
        lock.unlock();
        try {
            taken.promise.set_value(drawn(taken.request, drafts, pool));
        } catch (...) {
            taken.promise.set_exception(std::current_exception());
        }
        lock.lock();
    }
}

}  // namespace fumon
