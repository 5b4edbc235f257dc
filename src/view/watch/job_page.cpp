#include "view/watch/job_page.h"

#include <csignal>
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
        watch_.state(client == request.query.end() ? "" : client->second.substr(0, longest_client));
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
        const std::vector<std::uint8_t> bytes =
            encode_picture(*picture, PictureFormat::jpeg, {job_picture_quality, false}, 96.0, {});
        bytes_.assign(bytes.begin(), bytes.end());
        encoded_ = picture;
    }
    HttpAnswer answer;
    answer.type = "image/jpeg";
    answer.body = bytes_;
    return answer;
}

}  // namespace fumon
