#pragma once

#include "figure/page/page.h"

namespace fumon {

/// The font size within insets, of the page's.
constexpr double inset_font_ratio = 0.85;

/// The room above a panel's own margin for its letter and title, points.
double heading_height(const Page& page, std::size_t n);

/// The room at the top of a page for its title, points.
double title_height(const Page& page);

/// What an inset takes of its panel's frame, `gap` away from it.
CanvasBox inset_box(const PageInset& inset, const CanvasBox& frame, double gap);

/// Throws InputError where a title would have to be written too small to be read.
void check_texts(const Page& page, const PageLayout& layout, const Canvas& canvas);

}  // namespace fumon
