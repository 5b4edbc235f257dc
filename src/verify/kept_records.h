#pragma once

#include <filesystem>
#include <string_view>

#include "picture/baseline.h"

namespace fumon {

/// Writes the picture of a record beside the baseline. Throws Error.
void keep_picture(const Baseline& baseline, const std::string& record, std::string_view png);

/// All that a lock holds: of the cases, and of none.
BaselineRecords all_records(const Baseline& baseline);

/// Writes the lock with what is recorded of the baseline's cases now and, where only some cases are
/// meant (`partly`), what is of no case, if that differs from what it held `before`. Moves what was
/// recorded in the baseline itself. Whether anything was written. Throws Error.
bool write_lock(const Baseline& baseline, const BaselineRecords& before, bool partly);

}  // namespace fumon
