#include "figure/canvas/figure_metadata.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>

#include "base/error.h"
#include "figure/canvas/eps_metadata.h"
#include "figure/canvas/pdf_metadata.h"
#include "files/png_reader.h"
#include "picture/stills/tiff.h"

namespace fumon {

namespace {

constexpr std::string_view svg_open = "<metadata><texts xmlns=\"urn:fumon:figure\">";
constexpr std::string_view svg_close = "</texts></metadata>";

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
                "cannot write the figure's metadata into an SVG file: they contain a control "
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

}  // namespace

std::string metadata_text(const FigureMetadata& metadata, std::string_view keyword) {
    for (const auto& [key, text] : metadata) {
        if (key == keyword) return text;
    }
    return "";
}

std::string with_svg_metadata(const std::string& svg, const FigureMetadata& metadata) {
    const std::size_t root = svg.find("<svg ");
    const std::size_t end = root == std::string::npos ? root : svg.find('>', root);
    if (metadata.empty() || end == std::string::npos) return svg;
    std::string element = "\n";
    if (const std::string title = metadata_text(metadata, "Title"); !title.empty())
        element += fmt::format("<title>{}</title>\n", to_xml(title));
    element += svg_open;
    for (const auto& [keyword, text] : metadata)
        element += fmt::format("<text key=\"{}\">{}</text>", to_xml(keyword), to_xml(text));
    element += svg_close;
    return svg.substr(0, end + 1) + element + svg.substr(end + 1);
}

FigureMetadata read_figure_metadata(std::string_view bytes, const std::string& name) {
    if (is_png(bytes)) return PngReader(bytes, name).texts();
    if (bytes.starts_with("%PDF-")) return read_pdf_metadata(bytes, name);
    if (is_tiff(bytes)) return tiff_texts(bytes, name);
    if (bytes.starts_with("%!PS-Adobe")) return eps_metadata(bytes, name);
    constexpr std::size_t head = 1000;  // bytes in which an SVG file names itself
    if (bytes.substr(0, head).find("<svg") != std::string_view::npos) return svg_texts(bytes, name);
    throw InputError(
        fmt::format("{}: is neither a PDF, an SVG, a PNG, a TIFF nor an EPS file", name));
}

}  // namespace fumon
