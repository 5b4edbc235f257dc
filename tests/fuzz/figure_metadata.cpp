// What an SVG, PDF or PNG figure says of its own making.

#include "figure/canvas/figure_metadata.h"

#include "fuzz_input.h"
#include "paper/figure_origin.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace fumon;
    const std::string_view bytes = fuzz::as_text(data, size);
    FigureMetadata texts;
    if (!fuzz::taken([&] { texts = read_figure_metadata(bytes, "figure"); })) return 0;
    if (is_figure(texts)) fuzz::taken([&] { read_figure_origin(texts, "figure"); });
    if (texts.empty()) return 0;
    std::string svg;
    try {
        svg = with_svg_metadata("<svg >\n</svg>\n", texts);
    } catch (const Error&) {
        return 0;  // control characters
    }
    if (read_figure_metadata(svg, "again.svg") != texts)
        fuzz::broken_promise("written metadata read back the same", svg);
    return 0;
}
