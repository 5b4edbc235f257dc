#pragma once

#include <toml++/toml.h>

#include <optional>
#include <string>
#include <string_view>

namespace fumon {

/// How deeply the keys, lists, inline tables and values of a TOML text may nest, all together: each
/// part of a dotted key or of a header counts one.
inline constexpr int deepest_toml = 256;

/// A TOML text as a table, the only way in which fumon reads TOML. `name` is that of its file, and
/// `remedy` says what such a file is. Throws InputError "name:line:column: what; remedy" for what
/// is no TOML and for what nests deeper than `deepest_toml`.
toml::table parse_toml(std::string_view text, const std::string& name, std::string_view remedy);

/// A single TOML value as a table that holds it under the name "value", in column 9 of line 1;
/// none where the text is no TOML value.
std::optional<toml::table> parse_toml_value(std::string_view text);

}  // namespace fumon
