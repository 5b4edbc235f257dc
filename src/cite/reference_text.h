#pragma once

#include <string>
#include <vector>

#include "cite/work.h"

namespace fumon {

enum class ReferenceFormat { text, bibtex, ris };

/// fumon itself, in its version, and the works, as a reference list: a line for each ("text"), or
/// the entries of BibTeX (UTF-8) or RIS.
std::string reference_list(const std::vector<const Work*>& works, ReferenceFormat format);

/// "Werner 1995", "Nield & Baas 2008", "Kroy et al. 2002": as texts name a work in brackets.
std::string short_citation(const Work& work);

}  // namespace fumon
