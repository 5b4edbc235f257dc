#include "files/json_text.h"

#include <cstddef>

namespace fumon {

namespace {

/// Whether brackets outside of strings nest deeper than JSON may.
bool nests_too_deeply(std::string_view text) {
    int depth = 0;
    bool in_string = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (c == '"') in_string = !in_string;
        if (in_string) {
            if (c == '\\') ++i;
        } else if (c == '[' || c == '{') {
            if (++depth > deepest_json) return true;
        } else if (c == ']' || c == '}') {
            --depth;
        }
    }
    return false;
}

}  // namespace

nlohmann::ordered_json parse_json(std::string_view text) {
    if (nests_too_deeply(text)) return nlohmann::ordered_json::value_t::discarded;
    return nlohmann::ordered_json::parse(text, nullptr, false);
}

std::int64_t whole_number(const nlohmann::ordered_json& json) {
    return json.get_ref<const std::int64_t&>();
}

std::vector<std::int64_t> whole_numbers(const nlohmann::ordered_json& json) {
    std::vector<std::int64_t> numbers;
    for (const auto& number : json.get_ref<const nlohmann::ordered_json::array_t&>())
        numbers.push_back(whole_number(number));
    return numbers;
}

}  // namespace fumon
