#pragma once

#include <fmt/format.h>
#include <toml++/toml.h>

#include <string>

#include "keys/override.h"

namespace fumon {

/// An override with its value read.
struct Setting {
    Override given;
    toml::table holder;  ///< the value under the name "value"

    [[nodiscard]] const toml::node& value() const { return *holder.get("value"); }
    [[nodiscard]] std::string locate(const toml::source_region& region) const {
        constexpr std::size_t before_value = 9;  // the value starts in column 9 of "value = …"
        const auto column = static_cast<std::size_t>(region.begin.column);
        const std::size_t inside = column > before_value ? column - before_value : 0;
        return given.column == 0 ? given.place
                                 : fmt::format("{}:{}", given.place, given.column + inside);
    }
    [[nodiscard]] std::string locate_key() const {
        return given.column == 0 ? given.place : given.place + ":1";
    }
};

/// Reads the value of an override as TOML; what is none is a bare string. Throws InputError, with
/// its place, for a value that is not UTF-8.
Setting parse_setting(const Override& given);

}  // namespace fumon
