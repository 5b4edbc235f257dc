#include "paper/figure_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <memory>

#include "base/error.h"
#include "figure/page/page_grid.h"
#include "files/atomic_file.h"
#include "outputs/output_claims.h"
#include "outputs/own_file.h"
#include "paper/caption/caption_text.h"
#include "paper/figure_caption.h"
#include "paper/figure_paths.h"
#include "run/picture_text.h"

namespace fumon {

namespace {

namespace fs = std::filesystem;

struct CaptionFile {
    std::string_view end;  ///< of its name
    std::string (*write)(const std::string& caption);
};

constexpr std::array<CaptionFile, 3> caption_files{{{".caption.txt", plain_caption},
                                                    {".caption.tex", latex_caption},
                                                    {".caption.md", markdown_caption}}};

/// What follows a panel's letter in a name of data, NAME-a-1.csv: perhaps "-inset", perhaps a
/// curve's number, and .csv, .asc or .prj.
bool ends_as_data(std::string_view end) {
    constexpr std::string_view inset = "-inset";
    if (end.starts_with(inset)) end.remove_prefix(inset.size());
    if (end.starts_with('-')) {
        const std::size_t digits = end.find_first_not_of("0123456789", 1);
        if (digits == 1 || digits == std::string_view::npos) return false;
        end.remove_prefix(digits);
    }
    return end == ".csv" || end == ".asc" || end == ".prj";
}

/// Whether a file is called as data of one of the figure's panels.
bool is_named_as_data(std::string_view name, const FigurePlan& plan) {
    std::size_t panels = 0;
    for (const PanelPlan& panel : plan.panels) panels += panels_of(panel);
    for (std::size_t n = 0; n < panels; ++n) {
        const std::string letter = panel_letter(n);  // "(a)"
        const std::string begin = plan.name + "-" + letter.substr(1, letter.size() - 2);
        if (name.starts_with(begin) && ends_as_data(name.substr(begin.size()))) return true;
    }
    return false;
}

}  // namespace

void claim_figure(const FigurePlan& plan, const fs::path& folder, const OutputClaims& claims) {
    const auto file = [&](const std::string& end) { return folder / (plan.name + end); };
    bool made_before = false;
    for (const char* end : {".pdf", ".svg", ".png", ".tif", ".eps"})
        made_before = made_before || is_made_by_fumon(file(end));
    for (const std::string& format : plan.scene.figure.formats)
        claims.check(file("." + format), false);
    for (const CaptionFile& caption : caption_files)
        claims.check(file(std::string(caption.end)), false);
    std::error_code fault;
    for (const auto& entry : fs::directory_iterator(folder, fault)) {
        fs::path data = entry.path();
        if (data.extension() == ".part") data.replace_extension();
        if (is_named_as_data(data.filename().string(), plan)) claims.check(data, made_before);
    }
}

void write_files(const std::vector<WholeFile>& files) {
    std::vector<std::unique_ptr<AtomicFile>> open;
    for (const WholeFile& file : files) {
        open.push_back(std::make_unique<AtomicFile>(file.path));
        open.back()->write(file.bytes);
    }
    for (const auto& file : open) file->commit();
}

PageFormat page_format(const fs::path& file) {
    static constexpr std::array<std::string_view, 6> endings{".pdf", ".svg",  ".png",
                                                             ".tif", ".tiff", ".eps"};
    check_ending(file, "a figure", endings);
    const std::string end = small_ending(file);
    if (end == ".svg") return PageFormat::svg;
    if (end == ".eps") return PageFormat::eps;
    if (end.starts_with(".tif")) return PageFormat::tiff;
    return end == ".png" ? PageFormat::png : PageFormat::pdf;
}

DrawnPage draw_figure(const FigurePlan& plan, const FigurePage& made, PageFormat format,
                      const FigureMetadata& metadata) {
    const LanguageScope speaking(plan.words);
    try {
        return draw_page(made.page, format, plan.scene.figure.dots_per_inch, metadata);
    } catch (const InputError& refusal) {
        throw InputError(plan.scene.at("figure.width") + refusal.what());
    }
}

std::vector<WholeFile> figure_files(const FigurePlan& plan, const FigureSources& sources,
                                    const FigurePage& made, const fs::path& folder,
                                    std::vector<std::string>& notes) {
    const LanguageScope speaking(plan.words);
    const FigureMetadata metadata = figure_metadata(plan, sources);
    std::vector<WholeFile> files;
    for (const std::string& format : plan.scene.figure.formats) {
        const fs::path path = folder / (plan.name + "." + format);
        DrawnPage drawn = draw_figure(plan, made, page_format(path), metadata);
        const std::string& missing = drawn.missing_letters;
        if (!missing.empty() && std::find(notes.begin(), notes.end(), missing) == notes.end())
            notes.push_back(missing);
        files.push_back({path, std::move(drawn.bytes)});
    }
    const std::string caption =
        FigurePaths(plan, sources).in_text(figure_caption(plan, made.remarks));
    for (const CaptionFile& file : caption_files)
        files.push_back({folder / (plan.name + std::string(file.end)), file.write(caption)});
    for (const FigureData& data : made.data)
        files.push_back({folder / fmt::format("{}-{}", plan.name, data.name), data.text});
    return files;
}

}  // namespace fumon
