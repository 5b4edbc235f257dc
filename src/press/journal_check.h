#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "figure/page/page.h"
#include "paper/figure_plan.h"

namespace fumon {

/// What the journal of a figure (figure.journal; else what nearly all journals ask) would send
/// back, a line each with the place of the key to change: size, letters, lines, dots per inch,
/// formats, colours, labels and names. `page`: as it was made, for its height; nullptr where it was
/// not.
std::vector<std::string> journal_findings(const FigurePlan& plan, const Page* page);

/// One line: how many findings there are, by whose rules, and where and when these were read.
std::string journal_verdict(const FigurePlan& plan, std::size_t findings);

}  // namespace fumon
