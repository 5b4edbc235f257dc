#pragma once

#include <string>
#include <vector>

namespace fumon::test {

/// What is wrong with a page, a line each: elements that are not nested, no language, viewport,
/// title or colour scheme, not one main landmark, content beside landmarks, headings that skip a
/// level, pictures without alt, ids twice, links to an id that is not there.
std::vector<std::string> faults_of_page(const std::string& html);

/// The contrast of two colours #rrggbb by WCAG 2.2, 1 … 21.
double contrast(const std::string& one, const std::string& other);

/// The colours "--NAME: #rrggbb" of a style sheet: the first in the text, or of its
/// `prefers-color-scheme` rule. Empty where there is none.
std::string colour_of(const std::string& style, const std::string& name, bool of_the_rule);

}  // namespace fumon::test
