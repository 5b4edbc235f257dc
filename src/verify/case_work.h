#pragma once

#include <vector>

#include "verify/case_result.h"
#include "verify/case_selection.h"
#include "verify/verify_case.h"

namespace fumon {

/// Of which fumon the defaults hold while a verification does what it is asked.
CaseDefaults defaults_of(const VerificationOptions& options);

/// Draws a case and compares it with its record, or, on --update, says what changes. Writes
/// nothing. Throws nothing: what keeps the case from being drawn is its result. `options`, `suite`
/// and `one` are what was asked; `work` how it is drawn.
CaseResult work_on_case(const VerificationOptions& options, const Suite& suite,
                        const BaselineCase& one, const WorkOptions& work);

}  // namespace fumon
