#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <string>
#include <thread>

#include "support/program.h"
#include "support/raw_http.h"
#include "support/viewed_run.h"

namespace fumon {
namespace {

using test::contains;
using test::ScratchFolder;
using test::write_text;

TEST(ViewCommand, PrintsOneAddressAndEndsBySignal) {
    const ScratchFolder folder;
    write_text(folder / "viewed.toml", viewed_scene);
    test::Program program({"view", "viewed.toml"}, folder.path());
    for (int i = 0; i < 600 && !contains(program.output(), "ssh -L"); ++i)
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
    const std::string begin = "http://127.0.0.1:";
    const std::string said = program.output();
    ASSERT_TRUE(said.starts_with(begin)) << said;
    const int port = std::stoi(said.substr(begin.size()));
    EXPECT_EQ(status_of(ask(port, "GET", "/")), "403");
    program.send(SIGINT);
    const test::Ended ended = program.wait();
    EXPECT_EQ(ended.status, 0) << ended.errors;
    const std::string address = "http://127.0.0.1:" + std::to_string(port) + "/";
    EXPECT_TRUE(ended.output.starts_with(address)) << ended.output;
    EXPECT_TRUE(contains(ended.output, "ssh -L")) << ended.output;
    EXPECT_EQ(ended.output.find(address, 1), std::string::npos);
}

TEST(ViewCommand, RefusesWhatItCannotShow) {
    const ScratchFolder folder;
    EXPECT_EQ(test::fumon({"view", "no-such-scene"}, folder.path()).status, 2);
    EXPECT_EQ(test::fumon({"view", "terada-barchans", "--set", "sun.elevation=200"}, folder.path())
                  .status,
              2);
    const test::Ended empty = test::fumon({"view", "."}, folder.path());
    EXPECT_EQ(empty.status, 2);
    EXPECT_TRUE(contains(empty.errors, ".: the folder holds no run (run.json) and no sweep"))
        << empty.errors;
    write_text(folder / "file", "x");
    EXPECT_EQ(test::fumon({"view", "terada-barchans", "--save", "file"}, folder.path()).status, 2);
}

}  // namespace
}  // namespace fumon
