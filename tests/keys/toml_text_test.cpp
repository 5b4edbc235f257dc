#include "keys/toml_text.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "base/error.h"
#include "keys/override.h"
#include "scene/read.h"

namespace fumon {

namespace {

std::string repeated(const std::string& text, int count, const std::string& between = "") {
    std::string all;
    for (int n = 0; n < count; ++n) all += (n > 0 ? between : "") + text;
    return all;
}

std::string refusal(const std::string& text) {
    try {
        parse_toml(text, "a.toml", "it is TOML");
        return "taken";
    } catch (const InputError& fault) {
        return fault.what();
    }
}

TEST(TomlText, NestsOnlySoDeep) {
    const std::string most = repeated("a", deepest_toml, ".");
    const std::string end = ": keys and values nest deeper than 256; it is TOML";
    EXPECT_EQ(refusal(repeated("a", deepest_toml - 1, ".") + " = 1\n"), "taken");
    EXPECT_EQ(refusal(most + " = 1\n"), "a.toml:1:515" + end) << "the value counts too";
    EXPECT_EQ(refusal("\n" + most + ".b = 1\n"), "a.toml:2:513" + end) << "a dotted key";
    EXPECT_EQ(refusal(repeated("\"\xC3\xBC\"", 257, " . ") + " = 1\n"), "a.toml:1:1537" + end)
        << "quoted, with spaces";
    EXPECT_EQ(refusal("[" + most + "]\n"), "taken");
    EXPECT_EQ(refusal("[" + most + "]\nb = 1\n"), "a.toml:2:1" + end) << "a header and a key";
    EXPECT_EQ(refusal("[[" + most + ".b]]\n"), "a.toml:1:515" + end) << "of a list of tables";
    EXPECT_EQ(refusal("[" + most + "]\n[c]\nb.c = 1\n"), "taken") << "the next header ends it";
    const std::string tables = repeated("{a.b.c = ", 64) + "1" + repeated("}", 64);
    EXPECT_EQ(refusal("x = " + tables + "\n"), "a.toml:1:577" + end) << "keys in inline tables";
    EXPECT_EQ(refusal("x = " + repeated("{a.b.c = 1}, ", 300)).find(end), std::string::npos)
        << "one after another, which is another fault";
    EXPECT_EQ(refusal("x = [" + repeated("{a.b.c = 1}", 300, ",\n") + "]\n"), "taken");
    EXPECT_NE(refusal("x = " + repeated("[", 100000)).find("nest deeper"), std::string::npos);
}

TEST(TomlText, DotsOfTextsAndCommentsAreNoKeys) {
    const std::string dots = repeated("a.", 400);
    EXPECT_EQ(refusal("x = \"" + dots + "\"  # " + dots + "\n# " + dots + "\n"), "taken");
    EXPECT_EQ(refusal("x = '" + dots + "'\ny = 1.5\n"), "taken");
    EXPECT_EQ(refusal("x = \"\"\"\n" + dots + "\"\" \\\"\"\" " + dots + "\"\"\"\"\"\n"), "taken");
    EXPECT_EQ(refusal("x = '''\n" + dots + "'' " + dots + "'''\n"), "taken");
    EXPECT_EQ(refusal("x = \"\\\\\"\ny = \"\\\"" + dots + "\"\n"), "taken");
    EXPECT_NE(refusal("x = \"\\\\\"\n" + dots + "b = 1\n"), "taken") << "the text has ended";
}

TEST(TomlText, OfAllReadersIsLimited) {
    const std::string deep = repeated("a", 100000, ".");
    EXPECT_THROW(parse_scene(deep + " = 1\n", "scene.toml", ""), InputError);
    EXPECT_THROW(parse_scene("[" + deep + "]\n", "scene.toml", ""), InputError);
    EXPECT_THROW(parse_scene("[model]\nname = \"static\"\n", "scene.toml", "",
                             {"camera.azimuth={" + deep + " = 1}"}),
                 InputError);
    EXPECT_THROW(parse_scene("", "scene.toml", "", {deep + "=1"}), InputError);
    EXPECT_EQ(plain_text({"title", "'" + deep + "'", "", 0}), deep);
}

TEST(TomlText, IsReadInOnePlace) {
    for (const auto& entry : std::filesystem::recursive_directory_iterator(FUMON_SOURCES_FOLDER)) {
        if (!entry.is_regular_file() || entry.path().filename() == "toml_text.cpp") continue;
        std::ostringstream text;
        text << std::ifstream(entry.path()).rdbuf();
        EXPECT_EQ(text.str().find("toml::parse"), std::string::npos)
            << entry.path() << " reads TOML by itself; parse_toml() limits how deeply it nests";
    }
}

}  // namespace

}  // namespace fumon
