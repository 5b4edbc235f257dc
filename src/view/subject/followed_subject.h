#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "run/terminal/job_watch.h"
#include "view/subject/subject.h"

namespace fumon {

/// Whether the run.json of a run's folder says that the run is not complete.
bool is_unfinished_run(const std::filesystem::path& folder);

/// A run that another program computes, or that was stopped: the beds and measurements that its
/// folder holds so far, looked at again at most once a second, less often where looking takes long;
/// its first bed in any case. Fields
/// are seen from a checkpoint on, when a piece of their file is whole. Nothing is written, and the
/// run is not held up. Throws InputError where the folder holds no run.
std::unique_ptr<ViewSubject> followed_subject(const std::filesystem::path& folder, int threads,
                                              const std::vector<std::string>& settings);

/// The same of a run that this program computes into the folder, of a scene as it was prepared,
/// and `first`, its snapshot before the first step. Its last moment is the newest state that
/// `watch` has; moments() asks for a newer one. `watch` outlives it.
std::unique_ptr<ViewSubject> watched_subject(const std::filesystem::path& folder, Scene scene,
                                             std::vector<InputFile> inputs, const Snapshot& first,
                                             JobWatch& watch);

}  // namespace fumon
