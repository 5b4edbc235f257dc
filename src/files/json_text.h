#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string_view>
#include <vector>

namespace fumon {

/// How deeply lists and objects of a JSON text may nest.
inline constexpr int deepest_json = 256;

/// A JSON text, the only way in which fumon reads JSON. What is no JSON, or nests deeper than
/// `deepest_json` (JSON is copied, compared and written by recursion), becomes a discarded value:
/// it holds nothing, and whatever is asked of it throws nlohmann::json::exception.
nlohmann::ordered_json parse_json(std::string_view text);

/// A whole number, or a list of them. Throws nlohmann::json::exception for anything else, numbers
/// with a fraction or an exponent too, which may be too large for any integer.
std::int64_t whole_number(const nlohmann::ordered_json& json);
std::vector<std::int64_t> whole_numbers(const nlohmann::ordered_json& json);

}  // namespace fumon
