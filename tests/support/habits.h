#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "support/command.h"
#include "support/program.h"

namespace fumon::test {

/// A folder with a small scene, and what the program says there.
class HabitsTest : public ::testing::Test {
  protected:
    void SetUp() override { write_text(folder_ / "scene.toml", small_scene()); }

    Ended said(const std::vector<std::string>& arguments) {
        return fumon(arguments, folder_.path());
    }

    nlohmann::json json_of(const std::vector<std::string>& arguments, int status = 0) {
        const Ended ended = said(arguments);
        EXPECT_EQ(ended.status, status) << ended.errors;
        return nlohmann::json::parse(ended.output);
    }

    /// What a shell says of a text of its own, with fumon on its path.
    Spoken shell(const std::string& program, const std::string& text) {
        write_text(folder_ / "script", text);
        return run_command("cd " + folder_.path().string() + " && PATH=" +
                           std::filesystem::path(FUMON_PROGRAM).parent_path().string() + ":$PATH " +
                           program + " script");
    }

    static bool has(const std::string& program) {
        return std::system(("command -v " + program + " > /dev/null").c_str()) == 0;
    }

    ScratchFolder folder_;
};

inline std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
}

}  // namespace fumon::test
