#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace fumon {

/// A keyword of well-known text and what stands in its brackets: PARAMETER["scale_factor",0.9996].
struct WktNode {
    std::string keyword;              ///< in capitals
    std::vector<std::string> values;  ///< texts without their quotes, numbers, and bare words
    std::vector<WktNode> children;

    /// The nth value as a number.
    [[nodiscard]] std::optional<double> number(std::size_t nth) const;
    /// The first child of one of these keywords.
    [[nodiscard]] const WktNode* child(std::initializer_list<std::string_view> keywords) const;
    /// The first node of one of these keywords, this one and the outer ones first.
    [[nodiscard]] const WktNode* find(std::initializer_list<std::string_view> keywords) const;
};

/// Reads a coordinate reference system's text, of version 1 or 2 (OGC 01-009, ISO 19162). Nothing
/// for a text that is not well formed or nested more than 32 deep.
std::optional<WktNode> parse_wkt(std::string_view text);

}  // namespace fumon
