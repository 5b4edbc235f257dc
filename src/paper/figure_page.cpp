#include "paper/figure_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "figure/page/page_grid.h"
#include "figure/plot/plot_axes.h"
#include "paper/panel_look.h"
#include "paper/panel_makers.h"
#include "paper/panel_title.h"
#include "scene/figure/journals.h"

namespace fumon {

namespace {

constexpr double millimetre = 72.0 / 25.4;  // points

/// How many panels the page's grid has to hold.
std::size_t pictures_of(const FigurePlan& plan) {
    std::size_t count = 0;
    for (const PanelPlan& panel : plan.panels) {
        if (panel.settings.inset == InsetCorner::none) count += panels_of(panel);
    }
    return count;
}

int columns_for(std::size_t panels, bool narrow) {
    constexpr std::size_t most_in_a_row = 4;
    if (panels <= 1) return 1;
    if (narrow) return 2;
    if (panels <= 3) return static_cast<int>(panels);
    if (panels == 4) return 2;
    if (panels <= 6 || panels == 9) return 3;
    return static_cast<int>(most_in_a_row);
}

Page empty_page(const FigurePlan& plan) {
    const FigureSettings& figure = plan.scene.figure;
    Page page;
    if (figure.width.is_word()) {
        const PageSize size = page_size(figure.width.word);
        page.width = size.width;
        page.height = size.height;
    } else {
        page.width = figure.width.value * millimetre;
    }
    if (!figure.height.is_word()) page.height = figure.height.value * millimetre;
    constexpr double narrow = 100.0;  // mm
    page.columns = figure.columns > 0
                       ? static_cast<int>(figure.columns)
                       : columns_for(pictures_of(plan), page.width < narrow * millimetre);
    page.font_size = figure.font_size;
    page.svg_text = figure.svg_text == SvgText::text;
    page.pdf_for_archives = figure.pdf_standard == PdfStandard::a_2b;
    page.cmyk_profile = plan.cmyk_profile;
    page.line_width = 0.5 * figure.line_width;  // curves are twice as wide
    page.letters = figure.letters;
    return page;
}

Corner corner_of(InsetCorner inset) {
    switch (inset) {
        case InsetCorner::upper_left:
            return Corner::upper_left;
        case InsetCorner::lower_left:
            return Corner::lower_left;
        case InsetCorner::lower_right:
            return Corner::lower_right;
        default:
            return Corner::upper_right;
    }
}

PanelColours::Values values_of_both(const PanelColours::Values& a, const PanelColours::Values& b) {
    if (!a || !b) return a ? a : b;
    return std::pair{std::min(a->first, b->first), std::max(a->second, b->second)};
}

class Assembly {
  public:
    Assembly(const FigurePlan& plan, const FigureRuns& runs, const RunStore& store,
             const FigureDrawing& drawing)
        : plan_(plan), tools_{plan,   runs, store, drawing.backend, WorkerPool(drawing.threads),
                              nullptr} {
        made_.page = empty_page(plan);
        warn_of_small_print();
    }

    FigurePage assemble() {
        for (const PanelPlan& panel : plan_.panels) add(panel);
        share_colours();
        share_axes();
        return std::move(made_);
    }

  private:
    /// The least that journals print, or the figure's own.
    void warn_of_small_print() {
        const Journal& any = journals().front();
        const Journal* const own = find_journal(plan_.scene.figure.journal);
        const Journal& asking = own == nullptr ? any : *own;
        const double least_letters = asking.least_letters.value_or(*any.least_letters);
        const double least_line = asking.least_lines.value_or(*any.least_lines);
        static_assert(tick_share == tick_text_size_em);
        const double letters = tick_text_size_em * made_.page.font_size;
        if (letters < least_letters) {
            made_.warnings.push_back(fmt::format(
                "ticks and legends are of {:.2g} points, and journals ask for {:g} or more; "
                "figure.font_size = {:.2g} does it",
                letters, least_letters,
                std::ceil(10.0 * least_letters / tick_text_size_em) / 10.0));
        }
        if (made_.page.line_width < least_line) {
            made_.warnings.push_back(fmt::format(
                "frames and ticks are {:.2g} points wide, and journals ask for {:g} or more; "
                "figure.line_width = {:g} does it",
                made_.page.line_width, least_line, 2.0 * least_line));
        }
    }

    /// Leaves out the numbers of axes that the panel left of one, or below, shows too.
    void share_axes() {
        if (axes_.empty()) return;
        const std::vector<GridSpan> places = grid_spans(made_.page);
        for (const auto& [number, axes] : axes_) {
            const GridSpan& place = places[number];
            for (const auto& [other, others] : axes_) {
                const GridSpan& near = places[other];
                if (near.row == place.row && near.rows == place.rows &&
                    near.last_column() + 1 == place.column && others.y_range == axes.y_range)
                    *axes.y = false;
                if (near.column == place.column && near.columns == place.columns &&
                    place.last_row() + 1 == near.row && others.x_range == axes.x_range)
                    *axes.x = false;
            }
        }
    }

    /// One range and one bar, beside the last, for the panels that share their colours.
    void share_colours() {
        if (sharing_.empty()) return;
        const ColourScale& first = *sharing_.front().colours.colours;
        double low = first.low;
        double high = first.high;
        PanelColours::Values values;
        for (const Sharing& one : sharing_) {
            const ColourScale& colours = *one.colours.colours;
            if (colours.label != first.label || colours.palette != first.palette) {
                throw InputError(plan_.scene.at(one.path + ".share_colours") +
                                 fmt::format("panels that share their colours show one quantity in "
                                             "one palette, not \"{}\" and \"{}\"",
                                             first.label, colours.label));
            }
            low = std::min(low, colours.low);
            high = std::max(high, colours.high);
            values = values_of_both(values, one.colours.values);
        }
        for (const Sharing& one : sharing_) {
            ColourScale& colours = *one.colours.colours;
            colours.low = low;
            colours.high = high;
            mark_range_ends(colours, values);
            if (&one != &sharing_.back()) *one.colours.bar = BarPosition::none;
            std::vector<std::string>& remarks = made_.remarks[one.panel];
            const std::string text = range_sentence(colours, values) + ", one range for all panels";
            if (std::ranges::find(remarks, text) == remarks.end()) remarks.push_back(text);
        }
    }

    /// "a", or "a-inset" for the data of what stands in it.
    [[nodiscard]] std::string letter_of_next(const PanelPlan& panel) const {
        const bool inset = panel.settings.inset != InsetCorner::none;
        const std::size_t number = made_.page.panels.size() - (inset ? 1 : 0);
        const std::string letter = panel_letter(number);  // "(a)"
        return letter.substr(1, letter.size() - 2) + (inset ? "-inset" : "");
    }

    /// The panels of a run, `width` points being the room for a frame on the page.
    std::vector<MadePanel> make(const PanelPlan& panel, double width) {
        Snapshot first;
        std::vector<Snapshot> snapshots;
        if (panel.picture) {
            const auto at = [&](std::int64_t step) {
                return tools_.store.snapshot(tools_.runs[panel.picture->run], step);
            };
            first = at(0);
            for (const std::int64_t step : panel.picture->steps) snapshots.push_back(at(step));
        }
        std::vector<MadePanel> made =
            maker_of(panel.settings.kind).make({panel, first, snapshots, width}, tools_);
        const Scene& scene = panel.picture ? panel.picture->scene : plan_.scene;
        for (std::size_t k = 0; k < made.size(); ++k) {
            made[k].title =
                panel_title(panel.settings, scene, snapshots.empty() ? nullptr : &snapshots[k]);
        }
        return made;
    }

    void add(const PanelPlan& panel) {
        const PanelSettings& settings = panel.settings;
        const bool inset = settings.inset != InsetCorner::none;
        const double share = inset ? settings.inset_size : static_cast<double>(settings.columns);
        const double width = made_.page.width / made_.page.columns * share;
        std::vector<MadePanel> made = make(panel, width);
        const bool alike = std::ranges::all_of(
            made, [&made](const MadePanel& one) { return one.remarks == made.front().remarks; });
        std::vector<std::string>& remarks = made_.remarks.emplace_back();
        if (alike) remarks = made.front().remarks;
        for (MadePanel& one : made) {
            const std::string letter = panel_letter(made_.page.panels.size() - (inset ? 1 : 0));
            for (const std::string& remark : one.remarks) {
                if (!alike) remarks.push_back(fmt::format("{} {}", letter, remark));
            }
            for (const std::string& warning : one.warnings)
                made_.warnings.push_back(fmt::format("panel {}: {}", letter, warning));
            for (FigureData& data : one.data)
                made_.data.push_back({letter_of_next(panel) + data.name, std::move(data.text)});
            if (one.shared.colours != nullptr)
                sharing_.push_back({one.shared, panel.path, made_.remarks.size() - 1});
            if (one.axes.x != nullptr && !inset)
                axes_.emplace_back(made_.page.panels.size(), one.axes);
            place(panel, std::move(one.content), std::move(one.title));
        }
    }

    void place(const PanelPlan& panel, std::unique_ptr<const PanelContent> content,
               std::string title) {
        const PanelSettings& settings = panel.settings;
        if (settings.inset != InsetCorner::none) {
            made_.page.panels.back().insets.push_back({std::move(content),
                                                       corner_of(settings.inset),
                                                       settings.inset_size, settings.inset_size});
            return;
        }
        PagePanel place;
        place.content = std::move(content);
        place.title = std::move(title);
        place.row = static_cast<int>(settings.row) - 1;
        place.column = static_cast<int>(settings.column) - 1;
        place.rows = static_cast<int>(settings.rows);
        place.columns = static_cast<int>(settings.columns);
        made_.page.panels.push_back(std::move(place));
    }

    struct Sharing {
        PanelColours colours;
        std::string path;       ///< of the panel's keys
        std::size_t panel = 0;  ///< its number in the plan
    };

    const FigurePlan& plan_;
    PanelTools tools_;
    FigurePage made_;
    std::vector<Sharing> sharing_;
    std::vector<std::pair<std::size_t, PanelAxes>> axes_;  ///< by the panel's number on the page
};

}  // namespace

FigurePage figure_page(const FigurePlan& plan, const FigureRuns& runs, const RunStore& store,
                       const FigureDrawing& drawing) {
    const LanguageScope speaking(plan.words);
    return Assembly(plan, runs, store, drawing).assemble();
}

}  // namespace fumon
