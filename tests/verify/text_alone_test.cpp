#include <gtest/gtest.h>

#include "support/program.h"

namespace fumon::test {
namespace {

TEST(VerifyText, SaysWhereTextAloneDiffersAndWhereTheGroundDoes) {
    const ScratchFolder folder;
    const std::string finding =
        "text and overlays alone differ, the picture under them is as recorded";
    const auto write_case = [&](const std::string& text, const std::string& more) {
        write_text(folder / "scene.toml", small_scene() + "[[overlay]]\nkind = \"title\"\n");
        write_text(folder / "b.toml",
                   "scene = \"scene.toml\"\nstep = 2\nsettings = [\"image.width=160\", "
                   "\"image.height=90\", \"title=" +
                       text + "\"" + more + "]\n[cases]\none = {}\n");
    };
    const auto verify = [&](std::vector<std::string> more) {
        more.insert(more.begin(), {"verify", "b.toml"});
        return fumon(more, folder.path());
    };
    write_case("a dune", "");
    const Ended update = verify({"--update", "--pinned"});
    ASSERT_EQ(update.status, 0) << update.errors;
    EXPECT_TRUE(contains(read_text(folder / "b.lock"), "\nunder_overlays = \""));
    EXPECT_EQ(verify({}).status, 0);

    write_case("b dune", "");
    const Ended text = verify({});
    EXPECT_EQ(text.status, 1);
    EXPECT_TRUE(contains(text.output, finding)) << text.output;

    write_case("b dune", ", \"sun.azimuth=320\"");
    const Ended ground = verify({});
    EXPECT_EQ(ground.status, 1);
    EXPECT_FALSE(contains(ground.output, finding)) << ground.output;
}

}  // namespace
}  // namespace fumon::test
