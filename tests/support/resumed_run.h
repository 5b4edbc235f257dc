#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <functional>
#include <string>
#include <system_error>
#include <thread>
#include <vector>

#include "support/program.h"

namespace fumon::test {

inline constexpr const char* output_without_pictures = "[output]\nframes = false\nmovie = false\n";

/// A run that goes on for a second or so, without pictures unless asked for.
inline std::string resumed_scene(const std::string& model, int nx, int ny, int steps,
                                 const std::string& output = output_without_pictures) {
    return "title = \"resumed\"\nseed = 3\n[model]\n" + model +
           "[grid]\nnx = " + std::to_string(nx) + "\nny = " + std::to_string(ny) +
           "\n[run]\nsteps = " + std::to_string(steps) + "\n[image]\nwidth = 64\nheight = 48\n" +
           output;
}

inline std::string sand_scene(int steps) {
    return resumed_scene(
        "name = \"sand\"\n", 120, 100, steps,
        std::string(output_without_pictures) + "fields_every = 40\nbed_every = 400\n");
}

inline void wait_for(const std::function<bool()>& condition) {
    const auto start = std::chrono::steady_clock::now();
    while (!condition()) {
        ASSERT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(60));
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
}

/// Runs of one scene that are stopped and go on.
class ResumeTest : public ::testing::Test {
  protected:
    void scene(const std::string& text) const { write_text(folder_ / "scene.toml", text); }
    [[nodiscard]] Ended run(const std::vector<std::string>& arguments) const {
        return fumon(arguments, folder_.path());
    }
    [[nodiscard]] std::filesystem::path out(const std::string& name = "out") const {
        return folder_ / name;
    }

    /// Runs the scene to its end, for comparison.
    void uninterrupted() const {
        const Ended ended = run({"run", "scene.toml", "-o", "whole", "-q"});
        ASSERT_EQ(ended.status, 0) << ended.errors;
    }

    /// Starts or resumes, and sends the signal once another checkpoint is on disk.
    [[nodiscard]] Ended stop(const std::vector<std::string>& arguments, int signal) const {
        const std::filesystem::path checkpoint = out() / "checkpoint.fumon";
        std::error_code fault;
        const auto before = std::filesystem::last_write_time(checkpoint, fault);
        const bool there = !fault;
        std::vector<std::string> all = arguments;
        all.insert(all.end(), {"-q", "--checkpoint-every", "0.00001"});
        Program program(all, folder_.path());
        wait_for([&] {
            std::error_code missing;
            const auto now = std::filesystem::last_write_time(checkpoint, missing);
            return !missing && (!there || now != before);
        });
        program.send(signal);
        return program.wait();
    }

    /// Leaves a run of sand that was stopped half-way.
    void stopped_sand(int steps = 20000) const {
        scene(sand_scene(steps));
        ASSERT_EQ(stop({"run", "scene.toml", "-o", "out"}, SIGINT).status, 130);
    }

    void expect_refusal(const std::vector<std::string>& arguments, const std::string& part) const {
        const Ended ended = run(arguments);
        EXPECT_EQ(ended.status, 2) << ended.errors;
        EXPECT_NE(ended.errors.find(part), std::string::npos) << ended.errors;
        EXPECT_EQ(std::count(ended.errors.begin(), ended.errors.end(), '\n'), 1);
    }

    ScratchFolder folder_;
};

}  // namespace fumon::test
