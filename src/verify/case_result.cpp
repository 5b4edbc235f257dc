#include "verify/case_result.h"

#include <nlohmann/json.hpp>
#include <string_view>
#include <utility>

#include "base/error.h"

namespace fumon {

namespace {

using Json = nlohmann::json;

Json binary(std::string_view bytes) {
    return Json::binary(std::vector<std::uint8_t>(bytes.begin(), bytes.end()));
}

std::string bytes_of(const Json& json) {
    const auto& bytes = json.get_binary();
    return {bytes.begin(), bytes.end()};
}

}  // namespace

const char* word_of(Outcome outcome) {
    switch (outcome) {
        case Outcome::as_recorded:
            return "ok";
        case Outcome::differs:
            return "DIFFERS";
        case Outcome::missing:
            return "MISSING";
        case Outcome::failed:
            return "FAILED";
        case Outcome::wrong_input:
            return "WRONG";
    }
    return "";
}

CaseResult undrawn(Outcome outcome, std::string finding) {
    CaseResult result;
    result.word = word_of(outcome);
    result.detail = finding;
    result.verdict = {outcome, std::move(finding)};
    return result;
}

std::vector<std::uint8_t> message_of(const CaseResult& result) {
    // Texts go as bytes, since file names in them need not be UTF-8.
    Json json{{"outcome", static_cast<int>(result.verdict.outcome)},
              {"finding", binary(result.verdict.finding)},
              {"word", result.word},
              {"told", binary(result.detail)},
              {"expected_pixels", result.expected_pixels},
              {"got_pixels", result.got_pixels},
              {"name", result.name},
              {"kept", binary(result.kept)},
              {"seconds", result.seconds},
              {"signal", result.signal},
              {"spoilt", result.needs_new_process}};
    if (result.got)
        json["got"] = binary(lock_text({{result.name, *result.got}}, LockOwner::verify));
    json["pictures"] = Json::array();
    for (const PagePicture& picture : result.pictures) {
        json["pictures"].push_back({{"kind", picture.kind},
                                    {"shown_as", picture.shown_as},
                                    {"caption", picture.caption},
                                    {"png", binary(picture.png)},
                                    {"hatched", binary(picture.hatched)}});
    }
    return Json::to_cbor(json);
}

CaseResult result_of(const std::vector<std::uint8_t>& message) {
    try {
        const Json json = Json::from_cbor(message);
        CaseResult result;
        result.verdict = {static_cast<Outcome>(json.at("outcome").get<int>()),
                          bytes_of(json.at("finding"))};
        result.word = json.at("word").get<std::string>();
        result.detail = bytes_of(json.at("told"));
        result.expected_pixels = json.at("expected_pixels").get<std::string>();
        result.got_pixels = json.at("got_pixels").get<std::string>();
        result.name = json.at("name").get<std::string>();
        result.kept = bytes_of(json.at("kept"));
        result.seconds = json.at("seconds").get<double>();
        result.signal = json.at("signal").get<int>();
        result.needs_new_process = json.at("spoilt").get<bool>();
        if (json.contains("got")) {
            BaselineRecords one =
                parse_lock(bytes_of(json.at("got")), "the child's record", LockOwner::verify);
            result.got = std::move(one.at(result.name));
        }
        for (const Json& picture : json.at("pictures")) {
            result.pictures.push_back(
                {picture.at("kind").get<std::string>(), picture.at("shown_as").get<std::string>(),
                 picture.at("caption").get<std::string>(), bytes_of(picture.at("png")),
                 bytes_of(picture.at("hatched"))});
        }
        return result;
    } catch (const std::exception& fault) {
        throw Error(std::string("the process that drew it returned no valid result: ") +
                    fault.what());
    }
}

}  // namespace fumon
