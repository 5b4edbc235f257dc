#include "figure/canvas/eps_metadata.h"

#include <fmt/format.h>

#include <cstddef>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "figure/canvas/pdf_metadata.h"
#include "files/json_text.h"

namespace fumon {

namespace {

constexpr std::string_view piece_head = "%fumon: ";
constexpr std::string_view comments_end = "%%EndComments\n";

/// A title in a comment: ASCII, and as long as the conventions allow (255 letters a line).
std::string plain_title(const std::string& title) {
    constexpr std::size_t longest = 200;
    std::string plain;
    for (const char c : title) {
        if (plain.size() == longest) break;
        if (c >= ' ' && c <= '~') plain += c;
    }
    return plain;
}

}  // namespace

std::string with_eps_metadata(const std::string& eps, const FigureMetadata& metadata) {
    constexpr std::string_view date = "%%CreationDate:";
    const std::size_t at = eps.find(date);
    const std::size_t end = eps.find(comments_end);
    if (at == std::string::npos || end == std::string::npos || at > end)
        throw Error(
            "cannot make an EPS file: the PostScript of this version of Cairo is not supported");
    const std::size_t after = eps.find('\n', at) + 1;
    std::string made = eps.substr(0, at);
    const PdfMetadata texts = pdf_metadata(metadata);
    if (const std::string title = plain_title(texts.title); !title.empty())
        made += fmt::format("%%Title: {}\n", title);
    made += eps.substr(after, end + comments_end.size() - after);
    constexpr std::size_t piece = 200;
    for (std::size_t from = 0; from < texts.keywords.size(); from += piece)
        made += fmt::format("{}{}\n", piece_head, texts.keywords.substr(from, piece));
    return made + eps.substr(end + comments_end.size());
}

FigureMetadata eps_metadata(std::string_view eps, const std::string& name) {
    std::string keywords;
    std::size_t at = eps.find(comments_end);
    if (at == std::string_view::npos) return {};
    eps.remove_prefix(at + comments_end.size());
    while (eps.starts_with(piece_head)) {
        eps.remove_prefix(piece_head.size());
        const std::size_t end = std::min(eps.find('\n'), eps.size());
        keywords += eps.substr(0, end);
        eps.remove_prefix(std::min(end + 1, eps.size()));
    }
    return figure_keywords(keywords, name);
}

}  // namespace fumon
