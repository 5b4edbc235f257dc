#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>

#include "base/elementary.h"
#include "base/error.h"
#include "figure/page/page.h"
#include "figure/page/page_grid.h"
#include "figure/page/page_text.h"

namespace fumon {

namespace {

using Lengths = std::vector<double>;

constexpr double least_frame_width_em = 3.5;  // font sizes
constexpr double least_frame_height_em = 3.0;
constexpr double least_column_weight_ratio = 0.3;  // of a column's width, of the widest one's
constexpr double inset_gap_em = 0.5;  // font sizes between an inset and its panel's frame

double sum(const Lengths& lengths) {
    return std::accumulate(lengths.begin(), lengths.end(), 0.0);
}

PanelMargins larger(const PanelMargins& a, const PanelMargins& b) {
    return {std::max(a.left, b.left), std::max(a.right, b.right), std::max(a.above, b.above),
            std::max(a.below, b.below)};
}

bool grew(const PanelMargins& from, const PanelMargins& to) {
    return to.left > from.left || to.right > from.right || to.above > from.above ||
           to.below > from.below;
}

/// Shares of `available` by weight, none above its limit; what one leaves the others get.
Lengths shared(double available, const Lengths& weights, const Lengths& limits) {
    Lengths shares(weights.size(), 0.0);
    std::vector<bool> full(weights.size(), false);
    for (bool again = true; again;) {
        again = false;
        double weight = 0.0;
        double left = available;
        for (std::size_t i = 0; i < weights.size(); ++i) {
            if (full[i])
                left -= shares[i];
            else
                weight += weights[i];
        }
        for (std::size_t i = 0; i < weights.size(); ++i) {
            if (full[i]) continue;
            shares[i] = left * weights[i] / weight;
            if (shares[i] <= limits[i]) continue;
            shares[i] = limits[i];
            full[i] = true;
            again = true;
        }
    }
    return shares;
}

/// Solves one page: margins depend on frames, and frames on what the margins leave, so in turns.
class Solver {
  public:
    explicit Solver(const Page& page)
        : page_(page),
          canvas_(PageFormat::pdf, 1.0, 1.0, 72.0, page.font_size),
          places_(grid_spans(page)),
          margins_(page.panels.size()) {
        canvas_.set_line_width(page.line_width);
        for (const GridSpan& place : places_) rows_ = std::max(rows_, place.last_row() + 1);
    }

    PageLayout solve() {
        constexpr int free_turns = 2;  // after which margins only grow, so that it ends
        constexpr int most_turns = 40;
        for (int turn = 0; turn < most_turns; ++turn) {
            arrange();
            bool settled = true;
            for (std::size_t n = 0; n < places_.size(); ++n) {
                const PanelMargins needed = needed_margins(n);
                if (!grew(margins_[n], needed) && turn >= free_turns) continue;
                margins_[n] = turn < free_turns ? needed : larger(margins_[n], needed);
                settled = false;
            }
            if (settled) break;
        }
        finish();
        return std::move(layout_);
    }

  private:
    [[nodiscard]] double font() const { return page_.font_size; }
    [[nodiscard]] std::size_t columns() const { return static_cast<std::size_t>(page_.columns); }
    [[nodiscard]] std::size_t rows() const { return static_cast<std::size_t>(rows_); }
    [[nodiscard]] double aspect(std::size_t n) const { return page_.panels[n].content->aspect(); }

    [[nodiscard]] PanelMargins needed_margins(std::size_t n) const {
        const CanvasBox& frame = layout_.frames[n];
        PanelMargins margins = page_.panels[n].content->margins(canvas_, frame.width, frame.height);
        margins.above += heading_height(page_, n);
        return margins;
    }

    /// The margins of whole columns and rows.
    void gather_margins() {
        left_.assign(columns(), 0.0);
        right_.assign(columns(), 0.0);
        above_.assign(rows(), 0.0);
        below_.assign(rows(), 0.0);
        const auto raise = [](double& length, double to) { length = std::max(length, to); };
        for (std::size_t n = 0; n < places_.size(); ++n) {
            raise(left_[static_cast<std::size_t>(places_[n].column)], margins_[n].left);
            raise(right_[static_cast<std::size_t>(places_[n].last_column())], margins_[n].right);
            raise(above_[static_cast<std::size_t>(places_[n].row)], margins_[n].above);
            raise(below_[static_cast<std::size_t>(places_[n].last_row())], margins_[n].below);
        }
    }

    /// From the first to the last of some columns' or rows' frames.
    static double spanned(const Lengths& lengths, const Lengths& before, const Lengths& after,
                          double gap, int first, int last) {
        double length = 0.0;
        for (int i = first; i <= last; ++i) {
            const auto at = static_cast<std::size_t>(i);
            length += lengths[at];
            if (i > first) length += gap + after[at - 1] + before[at];
        }
        return length;
    }
    [[nodiscard]] double width_of(const GridSpan& place) const {
        return spanned(widths_, left_, right_, page_.column_gap, place.column, place.last_column());
    }
    [[nodiscard]] double height_of(const GridSpan& place) const {
        return spanned(heights_, above_, below_, page_.row_gap, place.row, place.last_row());
    }

    /// How columns share the width: as the aspects of their panels at one height, in the mean of
    /// the rows.
    [[nodiscard]] Lengths column_weights(double free_aspect) const {
        Lengths logarithms(columns(), 0.0);
        std::vector<int> count(columns(), 0);
        for (std::size_t n = 0; n < places_.size(); ++n) {
            if (places_[n].columns > 1) continue;
            const auto column = static_cast<std::size_t>(places_[n].column);
            logarithms[column] += elementary::log(aspect(n) > 0.0 ? aspect(n) : free_aspect);
            ++count[column];
        }
        Lengths weights(columns(), free_aspect);
        for (std::size_t i = 0; i < weights.size(); ++i) {
            if (count[i] > 0) weights[i] = elementary::exp(logarithms[i] / count[i]);
        }
        const double widest = *std::max_element(weights.begin(), weights.end());
        for (double& weight : weights)
            weight = std::max(weight, least_column_weight_ratio * widest);
        return weights;
    }

    /// The least number of columns that a panel of this row alone spans: wide plots are higher than
    /// narrow ones, and flatter.
    [[nodiscard]] int fewest_columns(std::size_t row) const {
        int fewest = page_.columns;
        for (const GridSpan& place : places_) {
            if (place.rows == 1 && static_cast<std::size_t>(place.row) == row)
                fewest = std::min(fewest, place.columns);
        }
        return fewest;
    }

    /// The height of each row for the widths of the columns.
    void set_natural_heights() {
        const double free_height = sum(widths_) / page_.columns / page_.panel_aspect;
        constexpr double least_free = 0.6;  // of it, beside panels with an aspect
        heights_.assign(rows(), 0.0);
        std::vector<bool> fixed(rows(), false);
        std::vector<bool> free(rows(), false);
        for (std::size_t n = 0; n < places_.size(); ++n) {
            const auto row = static_cast<std::size_t>(places_[n].row);
            if (places_[n].rows > 1) continue;
            (aspect(n) > 0.0 ? fixed : free)[row] = true;
            if (aspect(n) > 0.0)
                heights_[row] = std::max(heights_[row], width_of(places_[n]) / aspect(n));
        }
        for (std::size_t row = 0; row < rows(); ++row) {
            if (!fixed[row])
                heights_[row] = free_height * std::sqrt(fewest_columns(row));
            else if (free[row])
                heights_[row] = std::max(heights_[row], least_free * free_height);
            free[row] = free[row] && !fixed[row];
        }
        for (std::size_t n = 0; n < places_.size(); ++n) {
            if (!(aspect(n) > 0.0) || places_[n].rows == 1) continue;
            const double lacking = width_of(places_[n]) / aspect(n) - height_of(places_[n]);
            for (int row = places_[n].row; lacking > 0.0 && row <= places_[n].last_row(); ++row)
                heights_[static_cast<std::size_t>(row)] += lacking / places_[n].rows;
        }
        free_rows_ = std::move(free);
    }

    /// Fits the rows into a page's given height.
    void fit_heights(double available) {
        const double natural = sum(heights_);
        double free = 0.0;
        for (std::size_t row = 0; row < rows(); ++row)
            free += free_rows_[row] ? heights_[row] : 0.0;
        if (natural >= available) {
            for (double& height : heights_) height *= available / natural;
        } else if (free > 0.0) {
            for (std::size_t row = 0; row < rows(); ++row) {
                if (free_rows_[row]) heights_[row] *= 1.0 + (available - natural) / free;
            }
        }
    }

    /// The widths that the panels of each column can fill at the rows' heights.
    [[nodiscard]] Lengths width_limits() const {
        Lengths limits(columns(), 0.0);
        for (std::size_t n = 0; n < places_.size(); ++n) {
            const double most = aspect(n) > 0.0 && places_[n].columns == 1
                                    ? aspect(n) * height_of(places_[n])
                                    : INFINITY;
            for (int i = places_[n].column; i <= places_[n].last_column(); ++i) {
                double& limit = limits[static_cast<std::size_t>(i)];
                limit = std::max(limit, most);
            }
        }
        for (double& limit : limits) limit = limit == 0.0 ? INFINITY : limit;
        return limits;
    }

    [[noreturn]] void refuse(std::size_t n, const CanvasBox& frame) const {
        constexpr double millimetre = 72.0 / 25.4;
        throw InputError(fmt::format(
            "a page {:.0f} mm wide{} is too small for its panels: {:.1f} × {:.1f} mm are left for "
            "panel {}; give fewer columns, a larger page or a smaller font",
            page_.width / millimetre,
            page_.height > 0.0 ? fmt::format(" and {:.0f} mm high", page_.height / millimetre) : "",
            std::max(frame.width, 0.0) / millimetre, std::max(frame.height, 0.0) / millimetre,
            panel_name(page_, n)));
    }

    /// Frames for the margins that are known so far.
    void arrange() {
        gather_margins();
        const double gaps_across = page_.column_gap * (page_.columns - 1);
        const double gaps_down = page_.row_gap * (rows_ - 1);
        const double across =
            page_.width - 2.0 * page_.margin - gaps_across - sum(left_) - sum(right_);
        const double top = page_.margin + title_height(page_);
        const double rest_down = top + page_.margin + gaps_down + sum(above_) + sum(below_);
        if (!(across > 0.0)) refuse(0, {0.0, 0.0, across / page_.columns, 0.0});
        Lengths weights = column_weights(page_.panel_aspect);
        const auto share_width = [&] {
            widths_ = shared(across, weights, Lengths(columns(), INFINITY));
            set_natural_heights();
        };
        share_width();
        // On a high page, panels of any aspect leave width to those that get higher with it.
        constexpr double least_aspect = 0.8;
        constexpr double step = 0.95;
        for (double free_aspect = page_.panel_aspect;
             free_aspect > least_aspect && rest_down + sum(heights_) < page_.height;) {
            free_aspect *= step;
            weights = column_weights(free_aspect);
            share_width();
        }
        if (page_.height > 0.0) {
            if (!(page_.height > rest_down))
                refuse(0, {0.0, 0.0, widths_[0], (page_.height - rest_down) / rows_});
            fit_heights(page_.height - rest_down);
        }
        widths_ = shared(across, weights, width_limits());
        layout_.width = page_.width;
        layout_.height = page_.height > 0.0 ? page_.height : rest_down + sum(heights_);
        const double unused_across = across - sum(widths_);
        const double unused_down = layout_.height - rest_down - sum(heights_);
        place_frames(page_.margin + 0.5 * unused_across, top + 0.5 * unused_down);
    }

    void place_frames(double left, double top) {
        layout_.frames.clear();
        layout_.heading_widths.clear();
        for (std::size_t n = 0; n < places_.size(); ++n) {
            const GridSpan& place = places_[n];
            const GridSpan before{0, 0, place.row + 1, place.column + 1};
            const auto column = static_cast<std::size_t>(place.column);
            const auto row = static_cast<std::size_t>(place.row);
            const CanvasBox cell{left + left_[0] + width_of(before) - widths_[column],
                                 top + above_[0] + height_of(before) - heights_[row],
                                 width_of(place), height_of(place)};
            CanvasBox frame = cell;
            if (aspect(n) > 0.0) {
                frame.width = std::min(cell.width, cell.height * aspect(n));
                frame.height = frame.width / aspect(n);
                frame.x += 0.5 * (cell.width - frame.width);
            }
            if (frame.width < least_frame_width_em * font() ||
                frame.height < least_frame_height_em * font())
                refuse(n, frame);
            layout_.frames.push_back(frame);
            layout_.heading_widths.push_back(
                cell.right() + right_[static_cast<std::size_t>(place.last_column())] - frame.x);
        }
    }

    /// The frame of an inset within its panel's.
    [[nodiscard]] CanvasBox inset_frame(std::size_t n, const PageInset& inset) {
        const CanvasBox& frame = layout_.frames[n];
        const double gap = inset_gap_em * font();
        const CanvasBox box = inset_box(inset, frame, gap);
        canvas_.set_font_size(inset_font_ratio * font());
        CanvasBox inner = box;
        PanelMargins margins;
        const double ratio = inset.content->aspect();
        constexpr int turns = 6;
        for (int turn = 0; turn <= turns; ++turn) {
            inner.width = box.width - margins.left - margins.right;
            inner.height = box.height - margins.above - margins.below;
            if (ratio > 0.0) {
                inner.width = std::min(inner.width, inner.height * ratio);
                inner.height = inner.width / ratio;
            }
            if (inner.width < least_frame_height_em * font() ||
                inner.height < least_frame_height_em * font())
                refuse(n, inner);
            const PanelMargins needed = inset.content->margins(canvas_, inner.width, inner.height);
            if (turn > 1 && !grew(margins, needed)) break;
            margins = turn < 1 ? needed : larger(margins, needed);
        }
        canvas_.set_font_size(font());
        const bool at_left =
            inset.corner == Corner::upper_left || inset.corner == Corner::lower_left;
        const bool at_top =
            inset.corner == Corner::upper_left || inset.corner == Corner::upper_right;
        inner.x = at_left ? box.x + margins.left : box.right() - margins.right - inner.width;
        inner.y = at_top ? box.y + margins.above : box.bottom() - margins.below - inner.height;
        return inner;
    }

    void finish() {
        for (std::size_t n = 0; n < places_.size(); ++n) {
            const CanvasBox& frame = layout_.frames[n];
            PanelMargins own = margins_[n];
            own.above -= heading_height(page_, n);
            layout_.margins.push_back(own);
            const auto row = static_cast<std::size_t>(places_[n].row);
            layout_.headings.push_back({frame.x, frame.y - above_[row] + heading_height(page_, n)});
            layout_.insets.emplace_back();
            for (const PageInset& inset : page_.panels[n].insets)
                layout_.insets.back().push_back(inset_frame(n, inset));
        }
        check_texts(page_, layout_, canvas_);
    }

    const Page& page_;
    Canvas canvas_;  ///< to measure texts on
    std::vector<GridSpan> places_;
    std::vector<PanelMargins> margins_;  ///< per panel, with its heading
    int rows_ = 0;
    Lengths left_;
    Lengths right_;
    Lengths above_;
    Lengths below_;
    Lengths widths_;
    Lengths heights_;
    std::vector<bool> free_rows_;  ///< those whose panels may have any height
    PageLayout layout_;
};

}  // namespace

PageLayout lay_out(const Page& page) {
    return Solver(page).solve();
}

}  // namespace fumon
