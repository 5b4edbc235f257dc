// The habits of a command line: pages on keys, completion, manual pages, JSON, shipped scenes.

#include "support/habits.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <sstream>
#include <system_error>

#include "cli/commands.h"
#include "cli/completion.h"
#include "picture/png.h"

namespace fumon::test {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

// ---- describe ----

TEST_F(HabitsTest, DescribeTellsOfASectionOrOneKey) {
    const std::string page = said({"describe"}).output;
    EXPECT_LT(lines_of(page).size(), 50U) << "one page";
    for (const char* word : {"  camera ", "azimuth", "[[overlay]]", "sandpile", "describe all"})
        EXPECT_NE(page.find(word), std::string::npos) << word;
    for (const std::string& line : lines_of(page)) EXPECT_LT(line.size(), 100U) << line;

    const std::string camera = said({"describe", "camera"}).output;
    EXPECT_TRUE(camera.starts_with("Keys of [camera]\n\n  camera.projection ")) << camera;
    EXPECT_EQ(camera.find("  sun."), std::string::npos);
    const std::string one = said({"describe", "camera.azimuth"}).output;
    EXPECT_EQ(lines_of(one).size(), 4U) << one;
    EXPECT_NE(said({"describe", "overlay.corner"}).output.find("overlay.N.corner"),
              std::string::npos);
    EXPECT_EQ(said({"describe", "overlay.N.corner"}).output,
              said({"describe", "overlay.0.corner"}).output);
    const std::string rate = said({"describe", "model.creep_rate"}).output;
    EXPECT_NE(rate.find("of the model \"sand\""), std::string::npos) << rate;
    EXPECT_NE(said({"describe", "shot.move"}).output.find("shot.N.move"), std::string::npos);
    EXPECT_EQ(json_of({"describe", "camera", "--json"})[0]["key"], "camera.projection");
    EXPECT_GT(json_of({"describe", "shot", "--json"}).size(), 5U);
    EXPECT_EQ(said({"describe", "camera.azimut"}).errors,
              "fumon describe: \"camera.azimut\" is neither a file, \"scene\", \"figure\", "
              "\"overlay\", a "
              "model, a section nor a key; did you mean \"camera.azimuth\"?\n");
    EXPECT_EQ(said({"describe", "camra"}).status, 2);
    EXPECT_EQ(
        said({"describe", "model.slabs"}).errors,
        "fumon describe: \"model.slabs\" is neither a file, \"scene\", \"figure\", \"overlay\", a "
        "model, a section nor a key; `fumon describe` alone names them all\n");
}

// ---- shipped scenes ----

TEST_F(HabitsTest, ScenesAreListedAndPrintedToBeEdited) {
    const Json scenes = json_of({"scenes", "--json"});
    EXPECT_GT(scenes.size(), 40U);
    for (const Json& scene : scenes) EXPECT_NE(scene["title"], "") << scene;
    EXPECT_EQ(lines_of(said({"scenes"}).output).size(), scenes.size());

    const Ended barchans = said({"new", "barchans"});
    EXPECT_EQ(barchans.output, read_text(fs::path(FUMON_SCENES_FOLDER) / "dunes-barchans.toml"));
    EXPECT_TRUE(barchans.errors.starts_with("this is dunes-barchans; there are also "))
        << barchans.errors;
    EXPECT_EQ(said({"new", "terada-ripples"}).errors, "");
    ASSERT_EQ(said({"new", "gully-rain", "-o", "mine.toml"}).status, 0);
    EXPECT_EQ(said({"check", "mine.toml"}).status, 0) << "its terrain is found from here";
    EXPECT_EQ(said({"new", "gully-rain", "-o", "mine.toml"}).status, 2) << "it may be edited";
    EXPECT_EQ(said({"new", "terada-riples"}).errors,
              "fumon new: fumon ships no scene \"terada-riples\"; did you mean "
              "\"terada-ripples\"?\n");
}

TEST_F(HabitsTest, ScenesThatNameFilesCanBeEditedElsewhere) {
    std::vector<std::string> files{"check"};
    for (const Json& scene : json_of({"scenes", "--json"})) {
        const std::string copy = "copy-" + std::to_string(files.size()) + ".toml";
        if (read_text(std::string(scene["file"])).find(".asc\"") == std::string::npos &&
            read_text(std::string(scene["file"])).find(".toml\"") == std::string::npos)
            continue;
        files.push_back(copy);
        ASSERT_EQ(said({"new", scene["name"], "-o", copy}).status, 0) << scene;
    }
    EXPECT_GT(files.size(), 5U);
    const Ended ended = said(files);
    EXPECT_EQ(ended.status, 0) << ended.errors;
}

TEST_F(HabitsTest, ShippedTerrainIsFoundByItsBareNameUnlessAFileHereHasIt) {
    const std::string hill = "front_range_hill.asc";
    const std::string shipped = std::string(FUMON_SCENES_FOLDER) + "/../assets/terrain/" + hill;
    const Json measured = json_of({"measure", shipped, "--json"});
    EXPECT_EQ(json_of({"measure", hill, "--json"})["measures"], measured["measures"]);
    write_text(folder_ / hill, "ncols 2\nnrows 2\ncellsize 1\n1 2\n3 4\n");
    EXPECT_NE(json_of({"measure", hill, "--json"})["measures"], measured["measures"])
        << "what lies here comes first";
    EXPECT_EQ(said({"measure", "./no_such_hill.asc"}).status, 2);
}

// ---- help, standard input, quiet ----

TEST_F(HabitsTest, HelpIsACommandToo) {
    EXPECT_EQ(said({"help"}).output, said({"--help"}).output);
    for (const Command& command : commands()) {
        EXPECT_EQ(said({"help", command.name}).output, said({command.name, "--help"}).output);
        EXPECT_NE(said({command.name, "--help"}).output.find("-q,--quiet"), std::string::npos)
            << command.name;
    }
    const Ended unknown = said({"help", "rum"});
    EXPECT_EQ(unknown.status, 2);
    EXPECT_NE(unknown.errors.find("did you mean \"run\"?"), std::string::npos) << unknown.errors;
}

TEST_F(HabitsTest, ScenesAndTerrainComeOnStandardInput) {
    const std::string there = "cd " + folder_.path().string() + " && ";
    const std::string fumon_there = std::string(FUMON_PROGRAM) + " ";
    const auto spoken = [&](const std::string& from, const std::string& rest) {
        return run_command(there + fumon_there + rest + " < " + from).words;
    };
    EXPECT_NE(spoken("scene.toml", "check -").find("-: fine (sand, "), std::string::npos);
    EXPECT_EQ(spoken("scene.toml", "check - -q"), "");
    EXPECT_NE(spoken("scene.toml", "check - --set seed=x").find("--set 1:"), std::string::npos);
    EXPECT_NE(spoken("/dev/null", "check -").find("standard input is empty"), std::string::npos);
    write_text(folder_ / "wrong.toml", "seed = \"x\"\n");
    EXPECT_NE(spoken("wrong.toml", "check -").find("standard input:1:8"), std::string::npos);

    EXPECT_EQ(spoken("scene.toml", "still - --step 0 -o given.png -q"), "");
    EXPECT_EQ(spoken("scene.toml", "still scene.toml --step 0 -o named.png -q"), "");
    EXPECT_EQ(read_png(folder_ / "given.png"), read_png(folder_ / "named.png"));

    write_text(folder_ / "hill.asc",
               "ncols 3\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 10\n1 2 3\n4 5 6\n");
    const std::string measured = spoken("hill.asc", "measure hill.asc --open");
    EXPECT_NE(measured.find("bed_volume"), std::string::npos) << measured;
    EXPECT_EQ(spoken("hill.asc", "measure - --open"), measured);
    EXPECT_NE(spoken("hill.asc", "measure - --json").find("\"file\": \"-\""), std::string::npos);
    EXPECT_NE(spoken("scene.toml", "measure -").find("is not terrain of a known format"),
              std::string::npos);
}

TEST_F(HabitsTest, QuietCommandsSayNothingButErrors) {
    write_text(folder_ / "degrees.asc",
               "ncols 2\nnrows 2\nxllcorner 7\nyllcorner 46\ncellsize 0.01\n100 200\n300 400\n");
    EXPECT_NE(said({"measure", "degrees.asc"}).errors, "") << "degrees become metres";
    const Ended quiet = said({"measure", "degrees.asc", "-q"});
    EXPECT_EQ(quiet.status, 0);
    EXPECT_EQ(quiet.errors, "");
    EXPECT_NE(said({"measure", "none.asc", "-q"}).errors, "");
}

TEST_F(HabitsTest, AListOfSectionsIsCleared) {
    write_text(folder_ / "overlaid.toml",
               small_scene() +
                   "[[overlay]]\nkind = \"colour-bar\"\n[[overlay]]\nkind = "
                   "\"time\"\ncorner = \"upper-right\"\n");
    const auto still = [&](const std::string& file, std::vector<std::string> more) {
        std::vector<std::string> words{"still", file, "--step", "0", "-o", "list.png", "-q"};
        words.insert(words.end(), more.begin(), more.end());
        const Ended ended = said(words);
        EXPECT_EQ(ended.status, 0) << ended.errors;
        return read_png(folder_ / "list.png");
    };
    const Image bare = still("scene.toml", {});
    EXPECT_EQ(still("overlaid.toml", {"--set", "overlay=[]"}), bare);
    const std::vector<std::string> large{"--set", "image.width=320", "--set", "image.height=240"};
    std::vector<std::string> one{"--set", "overlay.0.kind=time"};
    one.insert(one.end(), large.begin(), large.end());
    std::vector<std::string> after = one;
    after.insert(after.begin(), {"--set", "overlay=[]"});
    EXPECT_EQ(still("overlaid.toml", after), still("scene.toml", one));
    const Ended wrong = said({"check", "overlaid.toml", "--set", "overlay=[1]"});
    EXPECT_EQ(wrong.status, 2);
    EXPECT_NE(wrong.errors.find("overlay=[] clears it"), std::string::npos) << wrong.errors;
}

// ---- manual pages ----

TEST_F(HabitsTest, ManualPagesAreClean) {
    ASSERT_EQ(said({"man", "-o", "man"}).status, 0);
    EXPECT_EQ(said({"man", "-o", "man"}).status, 0) << "its own pages are replaced";
    const bool groff = has("groff");
    const bool mandoc = has("mandoc");
    std::size_t pages = 0;
    for (const auto& entry : fs::directory_iterator(folder_ / "man")) {
        ++pages;
        const std::string file = entry.path().string();
        const std::string text = read_text(entry.path());
        EXPECT_NE(text.find(".SH NAME\nfumon"), std::string::npos) << file;
        EXPECT_NE(text.find(" \"20"), std::string::npos) << file << ": its date";
        if (!file.ends_with("scene.5")) {
            EXPECT_NE(text.find(".SH EXAMPLES\n.EX\n"), std::string::npos) << file;
        }
        if (groff) {
            EXPECT_EQ(run_command("groff -K utf8 -man -Tutf8 -ww -z " + file).words, "");
        }
        if (mandoc) {
            EXPECT_EQ(run_command("mandoc -T lint -W warning " + file).words, "");
        }
    }
    EXPECT_EQ(pages, commands().size() + 2);
    EXPECT_EQ(said({"man", "run"}).output, read_text(folder_ / "man/fumon-run.1"));
    EXPECT_EQ(said({"man", "rum"}).errors,
              "fumon man: there is no page \"rum\"; did you mean \"run\"?\n");
    write_text(folder_ / "man/fumon.1", "mine");
    EXPECT_EQ(said({"man", "-o", "man"}).status, 2);
}

// ---- JSON ----

TEST_F(HabitsTest, CommandsAnswerPrograms) {
    const Json models = json_of({"models", "--json"});
    EXPECT_EQ(models[0]["name"], "sand");

    write_text(folder_ / "bad.toml", small_scene() + "colour = 3\nsize = 2\n");
    Json checked = json_of({"check", "scene.toml", "bad.toml", "--json"}, 2);
    EXPECT_GT(checked[0]["forecast"]["seconds_of_steps"], 0.0);
    checked[0].erase("forecast");  // of this machine
    EXPECT_EQ(checked[0],
              Json::parse(R"({"file": "scene.toml", "fine": true, "kind": "scene", "model": "sand",
                              "nx": 24, "ny": 20, "steps": 20, "frames": 5})"));
    EXPECT_EQ(checked[1]["fine"], false);
    EXPECT_EQ(checked[1]["faults"].size(), 2U);

    const Json run = json_of({"run", "scene.toml", "-o", "out", "--json", "-q"});
    EXPECT_EQ(run["status"], "complete");
    EXPECT_EQ(run["steps_done"], 20);
    EXPECT_EQ(run["frames"], 5);
    EXPECT_EQ(run["state_sha256"], read_manifest(folder_ / "out")["state_sha256"]);
    EXPECT_EQ(run["movie"]["file"], "movie.mp4");

    const Json same = json_of(
        {"compare", "out/frames/frame_000001.png", "out/frames/frame_000001.png", "--json"});
    EXPECT_EQ(same["likeness"], "identical");
    EXPECT_EQ(same["passes"], true);
    const Json other = json_of({"compare", "out/frames/frame_000000.png",
                                "out/frames/frame_000004.png", "--json", "--level", "identical"},
                               1);
    EXPECT_EQ(other["passes"], false);
    EXPECT_GT(other["changed_pixels"], 0);

    write_text(folder_ / "baseline.toml", "[cases]\na = {scene = \"scene.toml\", step = 5}\n");
    EXPECT_EQ(json_of({"verify", "--json", "baseline.toml"}, 1)["cases"][0]["outcome"], "missing");
    ASSERT_EQ(said({"verify", "--update", "baseline.toml", "-q"}).status, 0);
    const Json verified = json_of({"verify", "--json", "baseline.toml"});
    EXPECT_EQ(verified["as_recorded"], 1);
    EXPECT_EQ(verified["page"], nullptr);
    EXPECT_EQ(verified["cases"][0]["name"], "a");
}

// ---- standard output ----

TEST_F(HabitsTest, APictureGoesToStandardOutput) {
    ASSERT_EQ(said({"still", "scene.toml", "--step", "0", "-o", "a.png", "-q"}).status, 0);
    const Ended piped = said({"still", "scene.toml", "--step", "0", "-o", "-", "-q"});
    EXPECT_EQ(piped.status, 0) << piped.errors;
    EXPECT_TRUE(piped.output == read_text(folder_ / "a.png")) << "the same bytes";
    EXPECT_FALSE(fs::exists(folder_ / "-"));
    const std::string still = std::string(FUMON_PROGRAM) + " still scene.toml --step 0 -q -o -";
    const std::string there = "cd " + folder_.path().string() + " && ";
    EXPECT_NE(run_command("(" + there + still + " > /dev/full)").words.find("No space left"),
              std::string::npos);
    if (!has("script")) return;
    if (const int terminals = posix_openpt(O_RDWR | O_NOCTTY); terminals >= 0) {
        close(terminals);
    } else {
        GTEST_SKIP() << "no pseudo-terminal can be made here: "
                     << std::generic_category().message(errno);
    }
    const Spoken terminal =
        run_command(there + "script -q -e -c '" + still + "' /dev/null < /dev/null");
    EXPECT_NE(terminal.words.find("-o -: standard output is a terminal"), std::string::npos)
        << terminal.words;
}

// ---- examples ----

/// The words of an example, without what a shell does with them.
std::vector<std::string> words_of(const std::string& line) {
    std::vector<std::string> words;
    std::istringstream stream(line.substr(0, line.find("   ")));
    for (std::string word; stream >> word && word != "|" && word != ">";) words.push_back(word);
    return words;
}

/// The examples of a page of help.
std::vector<std::string> examples_in(const std::string& help) {
    std::vector<std::string> examples;
    for (const std::string& line : lines_of(help)) {
        if (line.starts_with("  fumon ")) examples.push_back(line.substr(2));
    }
    return examples;
}

bool is_shipped(const std::string& name) {
    const fs::path folder = FUMON_SCENES_FOLDER;
    return name.find('.') == std::string::npos &&
           (fs::exists(folder / (name + ".toml")) ||
            fs::exists(folder / "figures" / (name + ".toml")));
}

/// A command line as fumon reads it, without doing it. Throws CLI::ParseError.
void parse(const std::vector<std::string>& words) {
    CLI::App app("", "fumon");
    std::vector<std::function<int()>> bodies;
    for (const Command& command : commands())
        bodies.push_back(command.declare(*app.add_subcommand(command.name, command.help)));
    std::vector<std::string> reversed(words.rbegin(), words.rend());
    reversed.pop_back();  // "fumon"
    app.parse(std::move(reversed));
}

TEST_F(HabitsTest, EveryCommandShowsExamplesThatAreRight) {
    std::vector<std::string> pages{said({"--help"}).output};
    for (const Command& command : commands()) {
        pages.push_back(said({command.name, "--help"}).output);
        const std::vector<std::string> examples = examples_in(pages.back());
        EXPECT_TRUE(std::ranges::any_of(examples,
                                        [&](const std::string& example) {
                                            return example.starts_with("fumon " +
                                                                       std::string(command.name));
                                        }))
            << command.name << " shows none of its own";
    }
    for (const std::string& page : pages) {
        for (const std::string& example : examples_in(page)) {
            const std::vector<std::string> words = words_of(example);
            EXPECT_NO_THROW(parse(words)) << example;
            // What is quick is done; of what simulates a shipped scene, scene and settings are
            // checked.
            const std::string& command = words.at(1);
            std::vector<std::string> tried(words.begin() + 1, words.end());
            const bool quick =
                std::ranges::count(std::vector<std::string>{"describe", "models", "scenes", "new",
                                                            "completion", "man"},
                                   command) > 0;
            if (!quick) {
                if (words.size() < 3 || !is_shipped(words[2])) continue;
                tried = {"check", words[2]};
                for (std::size_t k = 3; k + 1 < words.size(); ++k) {
                    if (words[k] == "--set") tried.insert(tried.end(), {"--set", words[k + 1]});
                }
            }
            const Ended ended = said(tried);
            EXPECT_EQ(ended.status, 0) << example << "\n" << ended.errors;
        }
    }
}

}  // namespace
}  // namespace fumon::test
