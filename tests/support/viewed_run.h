#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "run/prepared_run.h"
#include "scene/read.h"
#include "support/program.h"
#include "view/subject/computed_subject.h"
#include "view/view_page.h"

namespace fumon {

inline constexpr const char* viewed_scene = R"(title = "Viewed"
[model]
name = "sand"
[grid]
nx = 40
ny = 30
[run]
steps = 12
[output]
fields_every = 4
frames = false
movie = false
[image]
width = 96
height = 54
)";

inline std::unique_ptr<ViewSubject> viewed_subject(const std::string& more = {}) {
    return computed_subject(
        "viewed.toml", prepare_run(parse_scene(viewed_scene + more, "viewed.toml", "."), 1), {});
}

/// A finished run of that scene, in FOLDER/run.
inline std::filesystem::path viewed_run(const std::filesystem::path& folder) {
    test::write_text(folder / "viewed.toml", viewed_scene);
    const test::Ended ended = test::fumon({"run", "viewed.toml", "-o", "run", "-q"}, folder);
    EXPECT_EQ(ended.status, 0) << ended.errors;
    return folder / "run";
}

inline HttpAnswer get(ViewPage& page, const std::string& path) {
    return page.answer({"GET", path, {}, {}});
}

inline HttpAnswer post(ViewPage& page, const std::string& path, const nlohmann::json& body) {
    return page.answer({"POST", path, {}, body.dump()});
}

}  // namespace fumon
