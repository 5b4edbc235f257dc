#include "keys/earlier_defaults.h"

#include <array>
#include <charconv>
#include <optional>
#include <stdexcept>

#include "keys/assign.h"
#include "keys/toml_text.h"

namespace fumon {

namespace {

using Numbers = std::array<int, 3>;

std::optional<Numbers> numbers_of(std::string_view version) {
    Numbers numbers{};
    const char* at = version.data();
    const char* end = at + version.size();
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        if (i > 0 && (at == end || *at++ != '.')) return std::nullopt;
        const auto [stop, fault] = std::from_chars(at, end, numbers[i]);
        if (fault != std::errc{}) return std::nullopt;
        at = stop;
    }
    return numbers;
}

void take(const Key& key, const EarlierDefault& earlier) {
    const auto holder = parse_toml_value(earlier.value);
    if (!holder) throw std::logic_error("the earlier default of " + key.path + " is no TOML");
    assign(key, *holder->get("value"), [&](const auto&) { return key.path; });
}

}  // namespace

bool is_earlier_version(std::string_view one, std::string_view other) {
    const auto first = numbers_of(one);
    const auto second = numbers_of(other);
    return first && second && *first < *second;
}

void take_earlier_defaults(const KeyTable& table, std::string_view version) {
    for (const Key& key : table.keys()) {
        for (const EarlierDefault& earlier : {key.notes.earlier, key.notes.earliest})
            if (is_earlier_version(version, earlier.until)) take(key, earlier);
    }
}

void take_default_of_absence(const Key& key) {
    if (!key.notes.earlier.value.empty()) take(key, key.notes.earlier);
}

}  // namespace fumon
