#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "run/build_identity.h"
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
              "fumon models: --loud: no such option; try `fumon models --help`"},
        Wrong{"misspelt_option",
              {"--verson"},
              "fumon: --verson: no such option; did you mean \"--version\"?"},
        Wrong{"misspelt_option_of_a_command",
              {"run", "a.toml", "--thread", "2"},
              "fumon run: --thread: no such option; did you mean \"--threads\"?"},
        Wrong{
            "short_option", {"run", "-z"}, "fumon run: -z: no such option; try `fumon run --help`"},
        Wrong{"one_too_many",
              {"run", "a", "b", "c"},
              "fumon run: \"b\" is one too many; try `fumon run --help`"},
        Wrong{"missing", {"still"}, "fumon still: INPUT is missing; try `fumon still --help`"},
        Wrong{"missing_value",
              {"run", "a", "--threads"},
              "fumon run: --threads takes N, which is missing; try `fumon run --help`"},
        Wrong{"twice",
              {"run", "a", "-o", "b", "-o", "c"},
              "fumon run: --output is given more than once; try `fumon run --help`"},
        Wrong{"not_together",
              {"run", "a", "-q", "-v"},
              "fumon run: --quiet and --verbose do not go together; try `fumon run --help`"},
        Wrong{"needs_another",
              {"measure", "a.asc", "--steps", "3"},
              "fumon measure: --steps needs --earlier too; try `fumon measure --help`"},
        Wrong{"no_number",
              {"still", "a.toml", "-o", "b.png", "--step", "abc"},
              "fumon still: --step: it takes a whole number from 0 to 1e+15, not \"abc\"; try "
              "`fumon still --help`"},
        Wrong{"no_real_number",
              {"run", "a.toml", "-o", "b", "--checkpoint-every", "x"},
              "fumon run: --checkpoint-every: it takes a number from 0 to 1e+06, not \"x\"; try "
              "`fumon run --help`"},
        Wrong{
            "no_word",
            {"measure", "a.asc", "--as", "dune"},
            "fumon measure: --as: it takes bed, profile or pile, not \"dune\"; try `fumon measure "
            "--help`"},
        Wrong{"misspelt_shipped_scene",
              {"run", "terada-barchan", "-o", "x"},
              "terada-barchan: there is no such file here, and fumon ships no such scene; did you "
              "mean \"terada-barchans\"?"},
        Wrong{
            "missing_scene",
            {"run", "no.toml", "-o", "x"},
            "no.toml: cannot be read: No such file or directory; name a file that exists and that "
            "you may read"},
        Wrong{"missing_terrain",
              {"still", "no.asc", "-o", "x.png"},
              "no.asc: does not exist; check the path"},
        Wrong{"unknown_model",
              {"describe", "sant"},
              "fumon describe: \"sant\" is neither a file, \"scene\", \"figure\", \"overlay\", a "
              "model, a "
              "section nor a key; did you mean \"sand\"?"},
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
    EXPECT_EQ(fumon({"--version"}, folder.path()).output,
              "fumon " FUMON_VERSION " (sources " + short_sources(this_build()) + ")\n");
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

/// Seventy libraries come with FFmpeg, a hundred with GDAL: each command would wait for them.
TEST(CommandLine, LoadsNoLibrariesOfMoviesAndRasters) {
    const ScratchFolder folder;
    const Ended listed = fumon({"--version"}, folder.path(), {"LD_TRACE_LOADED_OBJECTS=1"});
    EXPECT_NE(listed.output.find("libc.so"), std::string::npos) << listed.output;
    for (const char* library : {"libavcodec", "libavformat", "libswscale", "libgdal"})
        EXPECT_EQ(listed.output.find(library), std::string::npos) << library;
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

TEST(CommandLine, CheckTellsAllFaultsOfASceneInItsOrder) {
    const ScratchFolder folder;
    write_text(folder / "bad.toml",
               "[sun]\nelevatoin = 3\n[model]\nname = \"sand\"\ncreep = 0.1\n[look]\npalette = "
               "\"jet\"\n[run]\nsteps = 1.5\n");
    const Ended ended = fumon({"check", "bad.toml"}, folder.path());
    EXPECT_EQ(ended.status, 2);
    EXPECT_EQ(ended.errors,
              "bad.toml:2:1: unknown key sun.elevatoin; did you mean \"sun.elevation\"?\n"
              "bad.toml:5:9: model.creep is 0.1; it takes one of \"every-cell\", \"maxima-only\", "
              "\"profile\", \"none\"\n"
              "bad.toml:7:11: unknown palette \"jet\"; known: batlow, cividis, grey, hypsometric, "
              "inferno, lapaz, magma, oslo, plasma, sand, vik, viridis\n"
              "bad.toml:9:9: run.steps is 1.5; it takes a whole number 0 … 1e+15 (steps)\n");
}

TEST(CommandLine, PicturesAndScenesAreToldApart) {
    const ScratchFolder folder;
    write_text(folder / "scene.toml", small_scene());
    ASSERT_EQ(
        fumon({"still", "scene.toml", "--step", "0", "-o", "a.png", "-q"}, folder.path()).status,
        0);
    for (const char* command : {"run", "figure"}) {
        EXPECT_EQ(fumon({command, "a.png", "-o", "out"}, folder.path()).errors,
                  "a.png: is a picture; a scene is TOML: [section] lines and key = value lines; "
                  "`fumon again a.png` redraws a picture made by fumon\n");
    }
    EXPECT_EQ(
        fumon({"again", "scene.toml"}, folder.path()).errors,
        "scene.toml: is not a picture; fumon again takes a PNG, JPEG, WebP, OpenEXR, MP4, PDF "
        "or SVG that "
        "fumon made; "
        "`fumon run scene.toml -o DIR` runs a scene\n");
}

TEST(CommandLine, AShippedSceneIsFoundByItsNameFromAnywhere) {
    const ScratchFolder folder;
    const Ended ended = fumon({"check", "sandpiles", "sudo-2002-06.toml"}, folder.path());
    EXPECT_EQ(ended.status, 0) << ended.errors;
    EXPECT_NE(ended.output.find("scenes/sandpiles.toml: fine"), std::string::npos) << ended.output;
    EXPECT_NE(ended.output.find("scenes/figures/sudo-2002-06.toml: fine"), std::string::npos);
    EXPECT_EQ(fumon({"run", "sandpiles", "-o", "out", "-q", "--set", "run.steps=1", "--set",
                     "output.movie=false", "--set", "image.width=64", "--set", "image.height=48",
                     "--set", "frames.every=1"},
                    folder.path())
                  .status,
              0);
    write_text(folder / "sandpiles", small_scene());
    EXPECT_EQ(fumon({"check", "sandpiles"}, folder.path()).output,
              "sandpiles: fine (sand, 24 x 20 cells, 20 steps, 5 frames)\n")
        << "a file here comes first";
}

TEST(CommandLine, AFullStandardOutputIsAnError) {
    const ScratchFolder folder;
    const std::string command =
        std::string(FUMON_PROGRAM) + " describe > /dev/full 2> " + (folder / "errors").string();
    const int status = std::system(command.c_str());
    EXPECT_EQ(WEXITSTATUS(status), 3);
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
    EXPECT_NE(ended.output.find("films/barchans.toml: fine (a film of 91"), std::string::npos);
}

}  // namespace
}  // namespace fumon::test
