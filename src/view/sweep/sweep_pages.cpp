#include "view/sweep/sweep_pages.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <iterator>
#include <nlohmann/json.hpp>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "base/error.h"
#include "base/stopwatch.h"
#include "film/beds/stored_beds.h"
#include "picture/stills/picture_file.h"
#include "run/frame_painter.h"
#include "scene/json.h"
#include "view/page_files.h"
#include "view/picture/draft_painter.h"
#include "view/subject/stored_subject.h"
#include "view/view_page.h"

namespace fumon {

namespace {

using Json = nlohmann::ordered_json;

constexpr int unknown_page = 404;
constexpr int later = 202;
constexpr std::size_t most_open_runs = 4;
constexpr std::size_t most_kept_pictures = 10'000;
constexpr int small_width = 320;
constexpr int small_height = 180;
constexpr int small_quality = 85;

HttpAnswer json_page(const Json& json) {
    HttpAnswer answer;
    answer.type = "application/json";
    answer.body = json_text(json);
    return answer;
}

std::optional<std::int64_t> number_in(std::string_view text) {
    std::int64_t number = 0;
    const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (fault != std::errc{} || end != text.data() + text.size() || number < 1) return std::nullopt;
    return number;
}

}  // namespace

SweepPages::SweepPages(const std::filesystem::path& folder, ViewOptions options)
    : options_(std::move(options)), listing_(folder), pool_(options_.work.threads, "fumon-view") {}

HttpAnswer SweepPages::answer(const HttpRequest& request) {
    constexpr std::string_view of_run = "run/";
    if (request.path.starts_with(of_run)) {
        HttpRequest rest = request;
        rest.path.erase(0, of_run.size());
        return run_answer(std::move(rest));
    }
    if (request.method == "GET") {
        if (request.path == "about") return about_answer();
        if (request.path == "sweep") return sweep_answer();
        if (request.path == "picture") {
            const auto run = request.query.find("run");
            const auto number = run == request.query.end() ? std::nullopt : number_in(run->second);
            return number ? picture_answer(*number) : plain_answer(unknown_page, "no such run");
        }
        if (auto file = page_file(request.path, "watch.html")) return *std::move(file);
    }
    return plain_answer(unknown_page, "no such page");
}

void SweepPages::cancel_all() {
    const std::lock_guard lock(open_mutex_);
    cancelled_ = true;
    for (const OpenRun& run : open_) run.pages->cancel_all();
}

HttpAnswer SweepPages::about_answer() {
    const std::lock_guard lock(listing_mutex_);  // a sweep that has grown is read again
    const std::string name = listing_.folder().string();
    return json_page({{"title", listing_.title().empty() ? name : listing_.title()},
                      {"job", options_.watch != nullptr},
                      {"sweep", true}});
}

HttpAnswer SweepPages::sweep_answer() {
    const std::lock_guard lock(listing_mutex_);
    const std::vector<ListedRun>& runs = listing_.runs();
    Json json;
    json["axes"] = Json::array();
    for (const ListedAxis& axis : listing_.axes())
        json["axes"].push_back(
            {{"label", axis.label}, {"unit", axis.unit}, {"values", axis.values}});
    json["runs"] = Json::array();
    for (const ListedRun& run : runs) {
        json["runs"].push_back({{"number", run.number},
                                {"at", run.at},
                                {"status", run.status},
                                {"message", run.message},
                                {"stored", run.stored}});
    }
    return json_page(json);
}

void SweepPages::check_shown(std::int64_t number) {
    const std::lock_guard lock(listing_mutex_);
    const std::vector<ListedRun>& runs = listing_.runs();
    if (number > static_cast<std::int64_t>(runs.size()))
        throw InputError(fmt::format("run {}: the sweep has {}", number, runs.size()));
    const ListedRun& run = runs[static_cast<std::size_t>(number) - 1];
    if (run.status != "done" || !run.stored)
        throw InputError(fmt::format("run {}: there is no bed of it to show", number));
}

HttpAnswer SweepPages::picture_answer(std::int64_t number) {
    check_shown(number);
    const std::lock_guard lock(picture_mutex_);  // one at a time
    auto known = pictures_.find(number);
    if (known == pictures_.end()) {
        if (options_.watch != nullptr && !options_.watch->may_draw())
            return plain_answer(later, "it would hold up the sweep; ask again");
        const Stopwatch stopwatch;
        const StoredBeds beds =
            StoredBeds::of_sweep(listing_.folder(), number, options_.work.threads);
        const auto last = beds.snapshot(beds.beds().size() - 1);
        const Scene scene = draft_of(beds.scene(), small_width, small_height);
        const bool flat = beds.first().section && scene.view.look.mode == ViewMode::figure;
        DraftPainter painter(options_.work.backend, pool_);
        const Image image = flat ? make_frame_painter(scene, beds.first(), options_.work.backend,
                                                      pool_, PaintedContent::one_picture)
                                       ->paint(*last, {})
                                 : painter.paint(scene, beds.first(), last);
        const std::vector<std::uint8_t> bytes =
            encode_picture(image, PictureFormat::jpeg, {small_quality, false}, 96.0, {});
        if (pictures_.size() >= most_kept_pictures) pictures_.clear();
        known = pictures_.emplace(number, std::string(bytes.begin(), bytes.end())).first;
        if (options_.watch != nullptr) options_.watch->spend(stopwatch.seconds());
    }
    HttpAnswer answer;
    answer.type = "image/jpeg";
    answer.body = known->second;
    return answer;
}

HttpAnswer SweepPages::run_answer(HttpRequest request) {
    const std::size_t end = request.path.find('/');
    const auto number = number_in(std::string_view(request.path).substr(0, end));
    if (!number || end == std::string::npos) return plain_answer(unknown_page, "no such run");
    request.path.erase(0, end + 1);
    return pages_of(*number)->answer(request);
}

std::shared_ptr<Pages> SweepPages::pages_of(std::int64_t number) {
    check_shown(number);
    std::list<OpenRun> closed;  // which ends what it draws, after the lock
    const std::lock_guard lock(open_mutex_);
    const auto known = std::ranges::find(open_, number, &OpenRun::number);
    if (known != open_.end()) {
        open_.splice(open_.begin(), open_, known);
        return open_.front().pages;
    }
    ViewOptions options = options_;
    options.watch = nullptr;
    auto pages = std::make_shared<SubjectPages>(
        stored_subject(StoredBeds::of_sweep(listing_.folder(), number, options_.work.threads),
                       listing_.folder() / "runs" / fmt::format("{:04}.csv", number)),
        options);
    if (cancelled_) pages->cancel_all();
    open_.push_front({number, std::move(pages)});
    if (open_.size() > most_open_runs) {
        open_.back().pages->cancel_all();  // whoever still asks it asks again
        closed.splice(closed.begin(), open_, std::prev(open_.end()));
    }
    return open_.front().pages;
}

}  // namespace fumon
