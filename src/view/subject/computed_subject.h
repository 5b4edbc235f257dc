#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "run/prepared_run.h"
#include "view/subject/subject.h"

namespace fumon {

/// The most moments of a run that is computed while it is looked at.
inline constexpr std::size_t most_computed_moments = 61;

/// A scene before its first step, computed on a thread of its own as far as somebody asks. Its
/// moments lie evenly among its steps; fewer of a bed whose snapshots would take more than 2 GiB.
std::unique_ptr<ViewSubject> computed_subject(std::string name, PreparedRun run,
                                              std::vector<std::filesystem::path> files);

}  // namespace fumon
