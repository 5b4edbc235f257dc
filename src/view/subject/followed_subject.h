#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "view/subject/subject.h"

namespace fumon {

/// Whether the run.json of a run's folder says that the run is not complete.
bool is_unfinished_run(const std::filesystem::path& folder);

/// A run that another program computes, or that was stopped: the beds and measurements that its
/// folder holds so far, looked at again at most once a second; its first bed in any case. Fields
/// are seen from a checkpoint on, when a piece of their file is whole. Nothing is written, and the
/// run is not held up. Throws InputError where the folder holds no run.
std::unique_ptr<ViewSubject> followed_subject(const std::filesystem::path& folder, int threads,
                                              const std::vector<std::string>& settings);

}  // namespace fumon
