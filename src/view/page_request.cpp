#include "view/page_request.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/limits.h"
#include "files/json_text.h"

namespace fumon {

namespace {

using Json = nlohmann::ordered_json;

/// Runs what reads JSON, whose faults are the page's.
template <class Read>
auto read_from_page(const Read& read) {
    try {
        return read();
    } catch (const nlohmann::json::exception& fault) {
        throw InputError(
            fmt::format("a request that no page of this fumon sends: {}", fault.what()));
    }
}

int pixels_in(const Json& json, const char* name) {
    constexpr int most = 16384;
    if (!json.contains(name)) return 0;
    const std::int64_t pixels = whole_number(json.at(name));
    if (pixels < 0 || pixels > most)
        throw InputError(fmt::format("{} is from 0 to {}, not {}", name, most, pixels));
    return static_cast<int>(pixels);
}

std::array<double, 3> point_in(const Json& json, const char* name) {
    std::array<double, 3> point{};
    const Json& list = json.at(name);
    if (!list.is_array() || list.size() != point.size())
        throw InputError(fmt::format("{} takes three numbers", name));
    for (std::size_t i = 0; i < point.size(); ++i) {
        point.at(i) = list[i].get<double>();
        if (!std::isfinite(point.at(i)) || std::abs(point.at(i)) > largest_coordinate)
            throw InputError(fmt::format("{} is out of the world", name));
    }
    return point;
}

}  // namespace

Json body_json(const HttpRequest& request) {
    Json json = parse_json(request.body);
    if (!json.is_object()) throw InputError("a request's body is a JSON object");
    return json;
}

std::vector<std::string> settings_in(const Json& json) {
    constexpr std::size_t most = 500;
    constexpr std::size_t longest = 2000;
    if (!json.contains("settings")) return {};
    auto settings =
        read_from_page([&] { return json.at("settings").get<std::vector<std::string>>(); });
    if (settings.size() > most)
        throw InputError(fmt::format("{} settings are more than {}", settings.size(), most));
    for (const std::string& setting : settings)
        if (setting.size() > longest) throw InputError("a setting is too long");
    return settings;
}

CameraPlace place_in(const Json& json) {
    return read_from_page([&] {
        return CameraPlace{point_in(json, "eye"), point_in(json, "target")};
    });
}

ViewRequest picture_request_in(const Json& json) {
    return read_from_page([&] {
        ViewRequest request;
        constexpr std::size_t longest_name = 64;
        request.client = json.value("client", std::string()).substr(0, longest_name);
        request.settings = settings_in(json);
        const std::int64_t moment = json.contains("moment") ? whole_number(json.at("moment")) : 0;
        if (moment < 0) throw InputError("moment is from 0 on");
        request.moment = static_cast<std::size_t>(moment);
        request.width = pixels_in(json, "width");
        request.height = pixels_in(json, "height");
        request.draft = json.value("draft", false);
        if (request.draft && (request.width == 0 || request.height == 0)) {
            constexpr int usual_width = 640;
            constexpr int usual_height = 360;
            request.width = usual_width;
            request.height = usual_height;
        }
        if (json.contains("eye") && !json.at("eye").is_null()) request.place = place_in(json);
        return request;
    });
}

}  // namespace fumon
