#include "figure/canvas/pdf_metadata.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "base/error.h"
#include "figure/canvas/figure_metadata.h"
#include "figure/canvas/packed_text.h"
#include "figure/canvas/pdf_strings.h"
#include "files/json_text.h"
#include "picture/stills/xmp.h"

namespace fumon {

namespace {

constexpr std::string_view pdf_entry = "/Keywords";
constexpr std::string_view own_begin = "[[\"";

/// The string of an object "12 0 obj (…) endobj" that a value "12 0 R" stands for.
std::string string_of_object(std::string_view value, std::string_view pdf) {
    const std::size_t end = value.substr(0, 24).find(" R");
    if (end == std::string_view::npos ||
        value.substr(0, end).find_first_not_of("0123456789 ") != std::string_view::npos)
        return "";
    const std::string head = fmt::format("\n{} obj", value.substr(0, end));
    const std::size_t at = pdf.rfind(head);
    if (at == std::string_view::npos) return "";
    const std::string_view object = pdf.substr(at + head.size());
    return pdf_string(object.substr(pdf_space(object)));
}

/// The last keywords of a figure among dictionaries; empty where there are none.
std::string keywords_among(std::string_view objects, std::string_view pdf) {
    constexpr int most_tries = 64;
    std::size_t at = objects.rfind(pdf_entry);
    for (int tries = 0; at != std::string_view::npos && tries < most_tries; ++tries) {
        std::string_view value = objects.substr(at + pdf_entry.size());
        value.remove_prefix(pdf_space(value));
        std::string keywords = pdf_string(value);
        if (keywords.empty()) keywords = string_of_object(value, pdf);
        if (const auto text = unpacked_text(keywords)) keywords = *text;
        if (keywords.starts_with(own_begin)) return keywords;
        at = at == 0 ? std::string_view::npos : objects.rfind(pdf_entry, at - 1);
    }
    return "";
}

/// Whether a trailer or a stream of references names what the file is encrypted by.
bool is_encrypted(std::string_view pdf) {
    constexpr std::string_view entry = "/Encrypt";
    for (std::size_t at = pdf.find(entry); at != std::string_view::npos;
         at = pdf.find(entry, at + 1)) {
        const std::string_view value = pdf.substr(at + entry.size(), 3);
        const std::size_t space = pdf_space(value);
        if (space < value.size() && value[space] >= '0' && value[space] <= '9') return true;
    }
    return false;
}

}  // namespace

PdfMetadata pdf_metadata(const FigureMetadata& metadata) {
    // PDF/A bounds strings to 32,767 bytes; Ghostscript keeps the last 65,535 of longer ones, which
    // have two bytes a letter where there are brackets.
    constexpr std::size_t longest = 32'000;
    try {
        std::string keywords = metadata.empty() ? "" : nlohmann::json(metadata).dump(-1, ' ', true);
        if (keywords.size() > longest) keywords = packed_text(keywords);
        return {metadata_text(metadata, "Title"), metadata_text(metadata, "Software"),
                std::move(keywords)};
    } catch (const nlohmann::json::exception&) {
        throw Error("cannot write the figure's metadata into a PDF file: they are not UTF-8");
    }
}

FigureMetadata figure_keywords(const std::string& keywords, const std::string& name) {
    const std::string text = unpacked_text(keywords).value_or(keywords);
    if (!text.starts_with(own_begin)) return {};
    try {
        return parse_json(text).get<FigureMetadata>();
    } catch (const nlohmann::json::exception&) {
        throw InputError(fmt::format("{}: its metadata are damaged", name));
    }
}

FigureMetadata read_pdf_metadata(std::string_view pdf, const std::string& name) {
    std::string keywords = keywords_among(pdf, pdf);
    if (keywords.empty()) {
        const PdfStreams streams = pdf_streams(pdf);
        keywords = keywords_among(streams.objects, pdf);
        if (keywords.empty()) keywords = xmp_value(streams.xmp, "pdf:Keywords");
    }
    FigureMetadata metadata = figure_keywords(keywords, name);
    if (metadata.empty() && is_encrypted(pdf))
        throw InputError(
            fmt::format("{}: is encrypted; take a copy that is not (qpdf --decrypt)", name));
    return metadata;
}

}  // namespace fumon
