#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "support/program.h"

namespace fumon::test {
namespace {

namespace fs = std::filesystem;

struct Wrong {
    const char* name;
    std::vector<std::string> arguments;
    std::string line;
};

void PrintTo(const Wrong& wrong, std::ostream* out) {
    *out << wrong.name;
}

class WrongUsage : public ::testing::TestWithParam<Wrong> {};

TEST_P(WrongUsage, GivesOneLineAndStatusTwo) {
    const ScratchFolder folder;
    const Ended ended = fumon(GetParam().arguments, folder.path());
    EXPECT_EQ(ended.status, 2);
    EXPECT_EQ(ended.errors, GetParam().line + "\n");
    EXPECT_EQ(ended.output, "");
    EXPECT_TRUE(fs::is_empty(folder.path())) << "nothing is written";
}

INSTANTIATE_TEST_SUITE_P(
    All, WrongUsage,
    ::testing::Values(
        Wrong{"nothing", {}, "fumon: a command is missing; try `fumon --help`"},
        Wrong{"unknown_command", {"rum"}, "fumon: unknown command \"rum\"; did you mean \"run\"?"},
        Wrong{"no_scene", {"run", "-o", "x"}, "fumon run: name a scene, or --resume DIR"},
        Wrong{"no_output", {"run", "scene.toml"}, "fumon run: name a folder for the run with -o"},
        Wrong{"unknown_option",
              {"models", "--loud"},
              "fumon models: The following argument was not expected: --loud; try `fumon models "
              "--help`"},
        Wrong{
            "missing_scene",
            {"run", "no.toml", "-o", "x"},
            "no.toml: cannot be read: No such file or directory; name a file that exists and that "
            "you may read"},
        Wrong{"missing_terrain",
              {"still", "no.asc", "-o", "x.png"},
              "no.asc: is not there; check the path"},
        Wrong{"unknown_model",
              {"describe", "sant"},
              "fumon describe: \"sant\" is neither \"scene\", \"figure\", \"overlay\" nor a model; "
              "did you mean \"sand\"?"},
        Wrong{"unknown_backend",
              {"still", "a.toml", "-o", "x.png", "--gl", "vulkan"},
              "fumon still: --gl: it takes auto, osmesa or egl, not \"vulkan\"; try `fumon still "
              "--help`"},
        Wrong{"bad_heights",
              {"still", "a.png", "-o", "x.png", "--heights", "10"},
              "--heights is \"10\"; it takes low:high in metres, for example 0:850"}),
    [](const auto& test) { return test.param.name; });

TEST(CommandLine, HelpTeaches) {
    const ScratchFolder folder;
    const Ended ended = fumon({"--help"}, folder.path());
    EXPECT_EQ(ended.status, 0);
    for (const char* word : {"run", "sweep", "still", "again", "fingerprint", "compare", "verify",
                             "check", "models", "describe", "--set", "terrain.asc"}) {
        EXPECT_NE(ended.output.find(word), std::string::npos) << word;
    }
    for (const char* command : {"run", "sweep", "still", "again", "fingerprint", "compare",
                                "verify", "check", "describe"}) {
        EXPECT_EQ(fumon({command, "--help"}, folder.path()).status, 0) << command;
    }
}

TEST(CommandLine, VersionModelsAndDescribe) {
    const ScratchFolder folder;
    EXPECT_EQ(fumon({"--version"}, folder.path()).output, "fumon " FUMON_VERSION "\n");
    const Ended models = fumon({"models"}, folder.path());
    EXPECT_EQ(models.status, 0);
    EXPECT_NE(models.output.find("sand"), std::string::npos);
    EXPECT_NE(models.output.find("static"), std::string::npos);

    const auto keys = nlohmann::json::parse(fumon({"describe", "--json"}, folder.path()).output);
    EXPECT_GT(keys.size(), 60U);
    for (const auto& key : keys) {
        for (const char* field : {"key", "type", "unit", "default", "help"})
            EXPECT_TRUE(key.contains(field));
    }
}

TEST(CommandLine, CheckNamesEveryFault) {
    const ScratchFolder folder;
    write_text(folder / "good.toml", small_scene());
    write_text(folder / "bad.toml", small_scene() + "colour = 3\n");
    const Ended ended = fumon({"check", "good.toml", "bad.toml", "none.toml"}, folder.path());
    EXPECT_EQ(ended.status, 2);
    EXPECT_EQ(ended.output, "good.toml: fine (sand, 24 x 20 cells, 20 steps, 5 frames)\n");
    EXPECT_EQ(std::count(ended.errors.begin(), ended.errors.end(), '\n'), 2) << ended.errors;
}

TEST(CommandLine, AFullStandardOutputIsAnError) {
    const ScratchFolder folder;
    const std::string command =
        std::string(FUMON_PROGRAM) + " describe > /dev/full 2> " + (folder / "errors").string();
    const int status = std::system(command.c_str());
    EXPECT_EQ(WEXITSTATUS(status), 1);
    EXPECT_EQ(read_text(folder / "errors"),
              "cannot write to standard output: No space left on device\n");
}

TEST(CommandLine, EveryShippedSceneIsFine) {
    std::vector<std::string> arguments{"check"};
    for (const auto& entry : fs::recursive_directory_iterator(FUMON_SCENES_FOLDER)) {
        if (entry.path().extension() == ".toml") arguments.push_back(entry.path().string());
    }
    ASSERT_GE(arguments.size(), 7U) << "six scenes ship";
    const ScratchFolder folder;
    const Ended ended = fumon(arguments, folder.path());
    EXPECT_EQ(ended.status, 0) << ended.errors;
}

}  // namespace
}  // namespace fumon::test
