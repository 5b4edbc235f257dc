#include "figure/canvas/figure_metadata.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <nlohmann/json.hpp>
#include <optional>

#include "base/error.h"
#include "files/json_text.h"
#include "files/png_reader.h"

namespace fumon {

namespace {

constexpr std::string_view pdf_entry = "/Keywords ";
constexpr std::string_view svg_open = "<metadata><texts xmlns=\"urn:fumon:figure\">";
constexpr std::string_view svg_close = "</texts></metadata>";

std::string text_of(const FigureMetadata& metadata, std::string_view keyword) {
    for (const auto& [key, text] : metadata) {
        if (key == keyword) return text;
    }
    return "";
}

struct Escape {
    char character;
    std::string_view text;
};

// A line's ends are escaped too, since readers of XML may change them.
constexpr std::array<Escape, 7> escapes{{{'&', "&amp;"},
                                         {'<', "&lt;"},
                                         {'>', "&gt;"},
                                         {'"', "&quot;"},
                                         {'\r', "&#13;"},
                                         {'\n', "&#10;"},
                                         {'\t', "&#9;"}}};

std::string to_xml(std::string_view text) {
    std::string xml;
    for (const char c : text) {
        const auto* escape = std::find_if(escapes.begin(), escapes.end(),
                                          [c](const Escape& one) { return one.character == c; });
        if (escape != escapes.end()) {
            xml += escape->text;
            continue;
        }
        if (static_cast<unsigned char>(c) < 32)
            throw Error(
                "the metadata of a figure cannot stand in an SVG file: it holds a control "
                "character");
        xml += c;
    }
    return xml;
}

std::string from_xml(std::string_view xml) {
    std::string text;
    while (!xml.empty()) {
        const auto* escape = std::find_if(escapes.begin(), escapes.end(), [xml](const Escape& one) {
            return xml.starts_with(one.text);
        });
        text += escape == escapes.end() ? xml.front() : escape->character;
        xml.remove_prefix(escape == escapes.end() ? 1 : escape->text.size());
    }
    return text;
}

/// What stands before the next `end`, which is taken away with it.
std::optional<std::string_view> taken_until(std::string_view& text, std::string_view end) {
    const std::size_t at = text.find(end);
    if (at == std::string_view::npos) return std::nullopt;
    const std::string_view before = text.substr(0, at);
    text.remove_prefix(at + end.size());
    return before;
}

FigureMetadata svg_texts(std::string_view svg, const std::string& name) {
    FigureMetadata metadata;
    if (!taken_until(svg, svg_open)) return metadata;
    while (svg.starts_with("<text key=\"")) {
        taken_until(svg, "\"");
        const auto keyword = taken_until(svg, "\">");
        const auto text = taken_until(svg, "</text>");
        if (!keyword || !text) break;
        metadata.emplace_back(from_xml(*keyword), from_xml(*text));
    }
    if (!svg.starts_with(svg_close))
        throw InputError(fmt::format("{}: its metadata are damaged", name));
    return metadata;
}

/// The ASCII string that a PDF file's bytes start with: "(…)", or "<FEFF…>", which is UTF-16 in
/// hexadecimal and what Cairo writes where brackets or backslashes are in it. Empty if it is
/// neither.
std::string pdf_string(std::string_view bytes) {
    constexpr std::string_view utf16 = "<FEFF";
    std::string text;
    if (bytes.starts_with('(')) {
        for (std::size_t i = 1; i < bytes.size() && bytes[i] != ')'; ++i) {
            if (bytes[i] == '\\' && i + 1 < bytes.size()) ++i;
            text += bytes[i];
        }
    } else if (bytes.starts_with(utf16)) {
        bytes.remove_prefix(utf16.size());
        constexpr int hexadecimal = 16;
        for (; bytes.size() >= 4 && bytes.front() != '>'; bytes.remove_prefix(4)) {
            int code = 0;
            const auto read = std::from_chars(bytes.data(), bytes.data() + 4, code, hexadecimal);
            if (read.ptr != bytes.data() + 4 || code > 127) return "";
            text += static_cast<char>(code);
        }
    }
    return text;
}

FigureMetadata pdf_texts(std::string_view pdf, const std::string& name) {
    const std::size_t at = pdf.rfind(pdf_entry);
    if (at == std::string_view::npos) return {};
    const std::string keywords = pdf_string(pdf.substr(at + pdf_entry.size()));
    if (!keywords.starts_with("[[\"")) return {};
    try {
        return parse_json(keywords).get<FigureMetadata>();
    } catch (const nlohmann::json::exception&) {
        throw InputError(fmt::format("{}: its metadata are damaged", name));
    }
}

}  // namespace

PdfMetadata pdf_metadata(const FigureMetadata& metadata) {
    try {
        return {text_of(metadata, "Title"), text_of(metadata, "Software"),
                metadata.empty() ? "" : nlohmann::json(metadata).dump(-1, ' ', true)};
    } catch (const nlohmann::json::exception&) {
        throw Error("the metadata of a figure cannot stand in a PDF file: they are not UTF-8");
    }
}

std::string with_svg_metadata(const std::string& svg, const FigureMetadata& metadata) {
    const std::size_t root = svg.find("<svg ");
    const std::size_t end = root == std::string::npos ? root : svg.find('>', root);
    if (metadata.empty() || end == std::string::npos) return svg;
    std::string element = "\n";
    if (const std::string title = text_of(metadata, "Title"); !title.empty())
        element += fmt::format("<title>{}</title>\n", to_xml(title));
    element += svg_open;
    for (const auto& [keyword, text] : metadata)
        element += fmt::format("<text key=\"{}\">{}</text>", to_xml(keyword), to_xml(text));
    element += svg_close;
    return svg.substr(0, end + 1) + element + svg.substr(end + 1);
}

FigureMetadata read_figure_metadata(std::string_view bytes, const std::string& name) {
    if (is_png(bytes)) return PngReader(bytes, name).texts();
    if (bytes.starts_with("%PDF-")) return pdf_texts(bytes, name);
    constexpr std::size_t head = 1000;  // bytes in which an SVG file names itself
    if (bytes.substr(0, head).find("<svg") != std::string_view::npos) return svg_texts(bytes, name);
    throw InputError(fmt::format("{}: is neither a PDF, an SVG nor a PNG file", name));
}

}  // namespace fumon
