#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <set>
#include <string>

#include "support/program.h"

namespace fumon::test {

/// The files of a run's folder, but for run.json and what a complete run can be gone
/// on with from.
inline std::set<std::string> files_of_run(const std::filesystem::path& folder) {
    std::set<std::string> names;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
        const std::string file = entry.path().filename().string();
        if (!entry.is_regular_file() || file == "run.json") continue;
        if (file == "checkpoint.fumon" || file == "frames.fumon") continue;
        names.insert(std::filesystem::relative(entry.path(), folder).string());
    }
    return names;
}

/// That two runs left the same files with the same bytes, and manifests that differ in timings and
/// interruptions alone.
inline void expect_same_run(const std::filesystem::path& one, const std::filesystem::path& other) {
    EXPECT_EQ(files_of_run(one), files_of_run(other));
    for (const std::string& name : files_of_run(one))
        EXPECT_EQ(read_text(one / name) == read_text(other / name), true) << name;
    nlohmann::json a = read_manifest(one);
    nlohmann::json b = read_manifest(other);
    for (nlohmann::json* manifest : {&a, &b}) {
        manifest->erase("performance");
        manifest->erase("resumed_at_steps");
    }
    EXPECT_EQ(a, b);
    EXPECT_EQ(a["status"], "complete");
}

}  // namespace fumon::test
