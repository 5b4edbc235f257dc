// Completion of commands, options, keys and values, as shells ask for it.

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "support/habits.h"

namespace fumon::test {
namespace {

using Words = std::vector<std::string>;

class CompletionHabitsTest : public HabitsTest {
  protected:
    /// What completes the last of these words.
    Words found(Words words) {
        words.insert(words.begin(), {"completion", "--line", "--"});
        return lines_of(said(words).output);
    }
};

TEST_F(CompletionHabitsTest, CompletionKnowsCommandsOptionsKeysAndValues) {
    EXPECT_EQ(found({"sw"}), (Words{"sweep"}));
    EXPECT_EQ(found({"sweep", "--sh"}), (Words{"--shard"}));
    EXPECT_EQ(found({"run", "--set", "camera.az"}), (Words{"camera.azimuth="}));
    EXPECT_EQ(found({"run", "--set", "look.mode="}),
              (Words{"look.mode=figure", "look.mode=scenic"}));
    EXPECT_EQ(found({"run", "--set=look.mode=f"}), (Words{"--set=look.mode=figure"}));
    EXPECT_EQ(found({"run", "scene.toml", "--set", "output.movie="}),
              (Words{"output.movie=false", "output.movie=true"}));
    EXPECT_EQ(found({"sweep", "x.toml", "--over", "model.creep_r"}), (Words{"model.creep_rate="}));
    EXPECT_EQ(found({"still", "x", "--gl", ""}), (Words{"auto", "egl", "osmesa"}));
    EXPECT_EQ(found({"measure", "--as", "pi"}), (Words{"pile"}));
    EXPECT_EQ(found({"export", "x", "--field", "wa"}), (Words{"water-depth", "water-surface"}));
    EXPECT_EQ(found({"run", "terada-ri"}), (Words{"terada-ripples", ":files"}));
    EXPECT_EQ(found({"describe", "camera.az"}), (Words{"camera.azimuth"}));
    EXPECT_EQ(found({"film", "out", "x", "--set", "film.siz"}), (Words{"film.size="}));
    EXPECT_EQ(found({"run", "--set", "model.name=sandp"}), (Words{"model.name=sandpile"}));
    EXPECT_EQ(found({"run", "-o", "x"}), (Words{":files"}));
    EXPECT_EQ(found({"run", "scene.toml", "--set", "model.topple"}), Words{})
        << "no key of the scene's model";
    EXPECT_EQ(said({"completion", "tcsh"}).status, 2);
}

TEST_F(CompletionHabitsTest, BashCompletes) {
    write_text(folder_ / "stone.toml", "");
    const std::string head =
        "source <(fumon completion bash)\n"
        "ask() {\n"
        "    COMP_LINE=$1 COMP_POINT=${#1} COMPREPLY=()\n"
        "    _fumon\n"
        "    printf '%s\\n' \"${COMPREPLY[*]}\"\n"
        "}\n";
    const Spoken spoken = shell("bash", head +
                                            "ask 'fumon sw'\n"
                                            "ask 'fumon run --set look.mode='\n"
                                            "ask 'fumon run --set camera.az'\n"
                                            "ask 'fumon check sto'\n"
                                            "ask 'fumon run terada-ri'\n"
                                            "complete -p fumon\n");
    EXPECT_EQ(spoken.words,
              "sweep\nfigure scenic\ncamera.azimuth=\nstone.toml\nterada-ripples\n"
              "complete -F _fumon fumon\n");
}

TEST_F(CompletionHabitsTest, ZshAndFishReadTheirScripts) {
    bool any = false;
    if (has("zsh")) {
        any = true;
        ASSERT_EQ(said({"completion", "zsh"}).status, 0);
        const Spoken spoken = shell("zsh",
                                    "fumon completion zsh > _fumon\n"
                                    "fpath=($PWD $fpath)\nautoload -Uz compinit\ncompinit -u -D\n"
                                    "compadd() { shift $@[(i)--]; print -r -- \"$@\" }\n"
                                    "_files() { print files }\ncompset() { : }\n"
                                    "words=(fumon run --set look.mode=) CURRENT=4\n"
                                    "autoload +X _fumon\n_fumon\nprint $_comps[fumon]\n");
        EXPECT_NE(spoken.words.find("look.mode=figure look.mode=scenic"), std::string::npos)
            << spoken.words;
    }
    if (has("fish")) {
        any = true;
        const Spoken spoken = shell("fish",
                                    "fumon completion fish | source\n"
                                    "complete -C 'fumon run --set look.mode='\n");
        EXPECT_NE(spoken.words.find("look.mode=scenic"), std::string::npos) << spoken.words;
    }
    if (!any) GTEST_SKIP() << "neither zsh nor fish is installed";
}

TEST_F(CompletionHabitsTest, CompletionOffersWhatLiesInFiles) {
    EXPECT_EQ(found({"still", "x", "--set", "look.palette=vi"}),
              (Words{"look.palette=vik", "look.palette=viridis"}));
    EXPECT_EQ(found({"run", "--set=look.preset=golden"}), (Words{"--set=look.preset=golden-hour"}));
    EXPECT_EQ(found({"run", "--set", "output.bed_format=esri"}),
              (Words{"output.bed_format=esri-ascii"}));
    EXPECT_EQ(found({"film", "x", "--set", "film.format=av"}), (Words{"film.format=av1"}));
    EXPECT_EQ(found({"help", "swe"}), (Words{"sweep"}));
}

}  // namespace
}  // namespace fumon::test
