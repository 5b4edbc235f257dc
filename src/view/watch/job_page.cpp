#include "view/watch/job_page.h"

#include <algorithm>
#include <csignal>
#include <cstddef>
#include <nlohmann/json.hpp>
#include <vector>

#include "picture/stills/picture_file.h"
#include "run/terminal/interrupt.h"
#include "scene/json.h"
#include "view/server/pages.h"

namespace fumon {

namespace {

constexpr std::size_t longest_client = 64;
constexpr int job_picture_quality = 85;
constexpr int job_picture_width = 960;

/// A picture of about that width at most, each pixel one of some: quick.
Image small_picture(const Image& whole) {
    const int factor = (whole.width + job_picture_width - 1) / job_picture_width;
    if (factor <= 1) return whole;
    Image small(whole.width / factor, std::max(1, whole.height / factor));
    for (int y = 0; y < small.height; ++y) {
        const std::uint8_t* const from = whole.row(std::min(y * factor, whole.height - 1));
        std::uint8_t* const to = small.row(y);
        for (int x = 0; x < small.width; ++x) {
            std::copy_n(from + 3 * static_cast<std::ptrdiff_t>(x) * factor, 3,
                        to + 3 * static_cast<std::ptrdiff_t>(x));
        }
    }
    return small;
}

}  // namespace

std::optional<HttpAnswer> JobPage::answer(const HttpRequest& request) {
    if (request.method == "GET" && request.path == "job") return state_answer(request);
    if (request.method == "GET" && request.path == "job-picture") return picture_answer();
    if (request.method == "POST" && request.path == "stop") {
        if (interrupting_signal() == 0) request_stop(SIGINT);
        return plain_answer(200, "stopping");
    }
    return std::nullopt;
}

HttpAnswer JobPage::state_answer(const HttpRequest& request) {
    const auto client = request.query.find("client");
    const JobState state =
        watch_.state(client == request.query.end() ? "" : client->second.substr(0, longest_client),
                     request.query.contains("last"));
    nlohmann::ordered_json json;
    json["stages"] = nlohmann::ordered_json::array();
    for (const JobStage& stage : state.stages) {
        json["stages"].push_back(
            {{"name", stage.name}, {"done", stage.done}, {"all", stage.all}, {"pace", stage.pace}});
    }
    json["seconds_left"] = state.seconds_left;
    json["messages"] = state.messages;
    json["pictures"] = state.pictures;
    json["picture"] = state.picture_name;
    json["stopping"] = interrupting_signal() != 0;
    json["outcome"] = state.outcome;
    HttpAnswer answer;
    answer.type = "application/json";
    answer.body = json_text(json);
    return answer;
}

HttpAnswer JobPage::picture_answer() {
    constexpr int not_found = 404;
    const std::shared_ptr<const Image> picture = watch_.picture();
    if (!picture) return plain_answer(not_found, "there is no picture yet");
    const std::lock_guard lock(mutex_);
    if (encoded_ != picture) {
        const std::vector<std::uint8_t> bytes = encode_picture(
            small_picture(*picture), PictureFormat::jpeg, {job_picture_quality, false}, 96.0, {});
        bytes_.assign(bytes.begin(), bytes.end());
        encoded_ = picture;
    }
    HttpAnswer answer;
    answer.type = "image/jpeg";
    answer.body = bytes_;
    return answer;
}

}  // namespace fumon
