#include "press/journal_check.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>

#include "scene/figure/journals.h"

namespace fumon {

namespace {

constexpr double points_of_millimetre = 72.0 / 25.4;
constexpr double slack = 0.005;  // of the last digit that is shown

const Journal& journal_of(const FigurePlan& plan) {
    const Journal* const own = find_journal(plan.scene.figure.journal);
    return own == nullptr ? journals().front() : *own;
}

bool is_of_pixels(const std::string& format) {
    return format == "png" || format == "tif";
}

class Check {
  public:
    Check(const FigurePlan& plan, const Page* page)
        : plan_(plan), figure_(plan.scene.figure), journal_(journal_of(plan)), page_(page) {}

    std::vector<std::string> findings() {
        check_size();
        check_letters();
        check_lines();
        check_formats();
        check_resolution();
        check_labels();
        check_name();
        return std::move(findings_);
    }

  private:
    /// "FILE:4:1: figure.width: is …, and Nature …".
    void add(const std::string& key, const std::string& what) {
        findings_.push_back(plan_.scene.at(key) + fmt::format("{}: {}", key, what));
    }

    [[nodiscard]] double width() const {
        return figure_.width.is_word() ? page_size(figure_.width.word).width / points_of_millimetre
                                       : figure_.width.value;
    }

    /// Nothing where it is as high as its panels need, and these are not made.
    [[nodiscard]] std::optional<double> height() const {
        if (page_ != nullptr) return lay_out(*page_).height / points_of_millimetre;
        if (figure_.height.is_word()) return std::nullopt;
        return figure_.height.value;
    }

    void check_size() {
        if (journal_.both && width() > *journal_.both + slack)
            add("figure.width", fmt::format("the page is {:.4g} mm wide ({}: {:.4g} at most)",
                                            width(), journal_.title, *journal_.both));
        const std::optional<double> high = height();
        if (journal_.highest && high && *high > *journal_.highest + slack)
            add("figure.height", fmt::format("the page is {:.4g} mm high ({}: {:.4g} at most)",
                                             *high, journal_.title, *journal_.highest));
    }

    void check_letters() {
        const bool insets = std::ranges::any_of(figure_.panels, [](const PanelSettings& panel) {
            return panel.inset != InsetCorner::none;
        });
        constexpr double inset_share = 0.85;
        const double small = tick_share * figure_.font_size * (insets ? inset_share : 1.0);
        const auto rounded = [](double points) { return std::ceil(10.0 * points - 1e-6) / 10.0; };
        if (journal_.least_letters && small < *journal_.least_letters - slack)
            add("figure.font_size",
                fmt::format(
                    "ticks and legends{} are of {:.3g} points ({}: {:g} or more); {:g} does it",
                    insets ? " of insets" : "", small, journal_.title, *journal_.least_letters,
                    rounded(*journal_.least_letters * figure_.font_size / small)));
        if (journal_.most_letters && figure_.font_size > *journal_.most_letters + slack)
            add("figure.font_size",
                fmt::format("labels are of {:g} points ({}: {:g} at most)", figure_.font_size,
                            journal_.title, *journal_.most_letters));
        const double raised = raised_share * figure_.font_size;
        if (journal_.least_raised && has_raised_letters() &&
            raised < *journal_.least_raised - slack)
            add("figure.font_size", fmt::format("raised and lowered letters are of {:.3g} points "
                                                "({}: {:g} or more); {:g} does it",
                                                raised, journal_.title, *journal_.least_raised,
                                                rounded(*journal_.least_raised / raised_share)));
    }

    [[nodiscard]] bool has_raised_letters() const {
        return std::ranges::any_of(figure_.panels, [](const PanelSettings& panel) {
            return std::ranges::any_of(std::vector<std::string>{panel.title, panel.x_label,
                                                                panel.y_label, panel.bar_label},
                                       [](const std::string& text) {
                                           return text.find('^') != std::string::npos ||
                                                  text.find("_{") != std::string::npos;
                                       });
        });
    }

    void check_lines() {
        const double frames = frame_share * figure_.line_width;
        if (journal_.least_lines && frames < *journal_.least_lines - 1e-9)
            add("figure.line_width",
                fmt::format(
                    "frames and ticks are {:.3g} points wide ({}: {:g} or more); {:g} does it",
                    frames, journal_.title, *journal_.least_lines,
                    *journal_.least_lines / frame_share));
        if (journal_.most_lines && figure_.line_width > *journal_.most_lines + 1e-9)
            add("figure.line_width",
                fmt::format("curves are {:g} points wide ({}: {:g} at most)", figure_.line_width,
                            journal_.title, *journal_.most_lines));
    }

    /// The figure's formats that the journal takes.
    [[nodiscard]] std::vector<std::string> taken() const {
        if (journal_.formats.empty()) return figure_.formats;
        std::vector<std::string> both;
        std::ranges::copy_if(
            figure_.formats, std::back_inserter(both), [&](const std::string& format) {
                return std::ranges::find(journal_.formats, format) != journal_.formats.end();
            });
        return both;
    }

    void check_formats() {
        if (taken().empty())
            add("figure.formats", fmt::format("none of them is taken ({}: {})", journal_.title,
                                              fmt::join(journal_.formats, ", ")));
        const bool tif = std::ranges::find(figure_.formats, "tif") != figure_.formats.end();
        if (journal_.rgb && tif && !figure_.icc_profile.empty())
            add("figure.icc_profile",
                fmt::format("the TIFF has a printer's inks, CMYK ({}: RGB)", journal_.title));
    }

    void check_resolution() {
        const std::vector<std::string> formats = taken();
        const bool pixels = !formats.empty() && std::ranges::all_of(formats, is_of_pixels);
        const bool pictures = std::ranges::any_of(figure_.panels, [](const PanelSettings& panel) {
            return shown_by(panel.kind) != PanelShows::curves;
        });
        if (!pixels && !pictures) return;
        std::optional<double> least = pixels ? journal_.combination : journal_.halftone;
        if (pixels && !pictures && journal_.line_art) least = journal_.line_art;
        if (least && figure_.dots_per_inch < *least - slack)
            add("figure.dots_per_inch", fmt::format("{} have {:g} dots per inch ({}: {:g} or more)",
                                                    pixels ? "its pixels" : "its pictures",
                                                    figure_.dots_per_inch, journal_.title, *least));
    }

    void check_labels() {
        if (!journal_.units_in_brackets) return;
        for (std::size_t p = 0; p < figure_.panels.size(); ++p) {
            const PanelSettings& panel = figure_.panels[p];
            const auto check = [&](const std::string& label, const char* key) {
                if (label.empty() || label.find('(') != std::string::npos) return;
                add(fmt::format("figure.panel.{}.{}", p, key),
                    fmt::format("\"{}\" has no unit in brackets ({}: \"Data (unit)\")", label,
                                journal_.title));
            };
            check(panel.x_label, "x_label");
            check(panel.y_label, "y_label");
            check(panel.bar_label, "bar_label");
        }
    }

    /// Programs of publishers take files by their names.
    void check_name() {
        const bool plain = std::ranges::all_of(plan_.name, [](char c) {
            return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                   c == '-' || c == '_';
        });
        if (!plain)
            findings_.push_back(
                fmt::format("{}: its files are called \"{}\"; letters a to z, digits, - and _ get "
                            "through every publisher's upload",
                            plan_.file, plan_.name));
    }

    const FigurePlan& plan_;
    const FigureSettings& figure_;
    const Journal& journal_;
    const Page* page_;
    std::vector<std::string> findings_;
};

}  // namespace

std::vector<std::string> journal_findings(const FigurePlan& plan, const Page* page) {
    return Check(plan, page).findings();
}

std::string journal_verdict(const FigurePlan& plan, std::size_t findings) {
    const Journal& journal = journal_of(plan);
    const std::string count = findings == 0   ? "nothing to send back"
                              : findings == 1 ? "1 thing to send back"
                                              : fmt::format("{} things to send back", findings);
    if (journal.pages.empty())
        return fmt::format("{} by what nearly all journals ask (figure.journal names one)", count);
    return fmt::format("{} by the rules of {}, read in {} at {}", count, journal.title,
                       journal.read, fmt::join(journal.pages, " "));
}

}  // namespace fumon
