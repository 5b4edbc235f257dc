#include "paper/curve_remarks.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "figure/words/words.h"

namespace fumon {

namespace {

constexpr std::size_t most_listed = 6;  // places that a caption lists

bool is_drawn(const CurvePoints& points, std::size_t i) {
    return std::isfinite(points.x[i]) && std::isfinite(points.y[i]);
}

/// The runs behind the points that are drawn: the fewest and the most.
struct RunCounts {
    std::int64_t fewest = 0;
    std::int64_t most = 0;
};

RunCounts run_counts(const std::vector<CurvePoints>& curves) {
    RunCounts counts;
    for (const CurvePoints& points : curves) {
        for (std::size_t i = 0; i < points.runs.size(); ++i) {
            if (!is_drawn(points, i)) continue;
            counts.fewest =
                counts.fewest == 0 ? points.runs[i] : std::min(counts.fewest, points.runs[i]);
            counts.most = std::max(counts.most, points.runs[i]);
        }
    }
    return counts;
}

/// "n = 3 at 1 and 2, 4 at 6, else 5"; "n = 1 to 5" where these would be many.
std::string changing_counts(const std::vector<CurvePoints>& curves, const RunCounts& counts) {
    std::map<std::int64_t, std::vector<std::string>> places;
    std::size_t listed = 0;
    for (const CurvePoints& points : curves) {
        for (std::size_t i = 0; i < points.runs.size(); ++i) {
            if (!is_drawn(points, i) || points.runs[i] == counts.most) continue;
            std::string place = fmt::format("{:.6g}", points.x[i]);
            if (curves.size() > 1 && !points.name.empty())
                place += fmt::format(" ({})", points.name);
            places[points.runs[i]].push_back(std::move(place));
            ++listed;
        }
    }
    if (listed > most_listed) return phrase("n = {} to {}", counts.fewest, counts.most);
    std::string text;
    for (const auto& [runs, at] : places)
        text += phrase("{} at x = {}, ", runs, fmt::format("{}", fmt::join(at, word(" and "))));
    return phrase("n = {}", text + phrase("else {}", counts.most));
}

bool any_bar(const std::vector<CurvePoints>& curves) {
    return std::ranges::any_of(curves, [](const CurvePoints& points) {
        return std::ranges::any_of(points.spread, [](double spread) { return spread > 0.0; });
    });
}

/// Whether a bar of a point that is shown ends below or above what an axis shows.
bool any_cut(const PanelSettings& panel, const std::vector<CurvePoints>& curves, bool at_zero) {
    const auto is_cut = [&](double y, double spread) {
        if (at_zero) return panel.y_logarithmic && y > 0.0 && y - spread <= 0.0;
        const bool below = !panel.y_low.is_word() && y >= panel.y_low.value &&
                           y - spread < panel.y_low.value && !(panel.y_logarithmic && y <= spread);
        const bool above =
            !panel.y_high.is_word() && y <= panel.y_high.value && y + spread > panel.y_high.value;
        return below || above;
    };
    for (const CurvePoints& points : curves) {
        for (std::size_t i = 0; i < points.spread.size(); ++i) {
            if (is_drawn(points, i) && points.spread[i] > 0.0 &&
                is_cut(points.y[i], points.spread[i]))
                return true;
        }
    }
    return false;
}

}  // namespace

std::int64_t runs_of_whole_points(const std::vector<CurvePoints>& curves) {
    return run_counts(curves).most;
}

void add_remarks(std::vector<std::string>& remarks, const PanelSettings& panel, std::size_t number,
                 const std::vector<CurvePoints>& curves, bool marked) {
    const CurveSettings& settings = panel.curves[number];
    const std::string of =
        panel.curves.size() > 1 ? phrase("curve {}: ", number + 1) : std::string();
    const RunCounts counts = run_counts(curves);
    const bool changes = counts.fewest < counts.most;
    std::string text;
    if (settings.spread != CurveSpread::none && any_bar(curves)) {
        const bool deviation = settings.spread == CurveSpread::deviation;
        if (settings.bars == SpreadLook::band) {
            text = deviation ? word("bands are standard deviations")
                             : word("bands are standard errors of the mean");
        } else {
            text = deviation ? word("bars are standard deviations")
                             : word("bars are standard errors of the mean");
        }
    }
    if (changes || (settings.spread != CurveSpread::none && counts.most > 0)) {
        if (!text.empty()) text += ", ";
        text += changes ? changing_counts(curves, counts) : phrase("n = {}", counts.most);
    }
    if (changes && marked) text += word(" (fewer: hollow)");
    if (!text.empty()) remarks.push_back(of + text);
    if (settings.least > 1)
        remarks.push_back(of + phrase("points of fewer than {} left out", settings.least));
    if (settings.bars == SpreadLook::band) {
        if (any_cut(panel, curves, true))
            remarks.push_back(of + word("the band reaches below zero"));
        return;
    }
    if (any_cut(panel, curves, true))
        remarks.push_back(of + word("bars with an arrow reach below zero"));
    if (any_cut(panel, curves, false))
        remarks.push_back(of + word("bars with an arrow go on beyond the axes"));
}

}  // namespace fumon
