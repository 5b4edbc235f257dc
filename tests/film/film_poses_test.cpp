#include <gtest/gtest.h>

#include <string>

#include "support/program.h"

namespace fumon {
namespace {

using test::Ended;
using test::fumon;
using test::ScratchFolder;

/// What must be seen: poses.png, a contact sheet of poses.toml that was looked at. After a change
/// that is wanted the sheet below takes its place.
TEST(FilmPoses, AreThoseThatWereLookedAt) {
    const ScratchFolder folder;
    test::write_text(folder / "scene.toml",
                     "title = \"small\"\nseed = 5\n[model]\nname = \"sand\"\n[grid]\nnx = 48\nny = "
                     "36\n[run]\nsteps = 60\n[look]\nground = \"table\"\n[output]\nbed_at = [60]\n"
                     "frames = false\nmovie = false\n");
    ASSERT_EQ(fumon({"run", "scene.toml", "-o", "out", "--quiet"}, folder.path()).status, 0);
    const std::string films = FUMON_TEST_FOLDER "/film/";
    const Ended made =
        fumon({"film", "out", films + "poses.toml", "-o", "poses.png"}, folder.path());
    ASSERT_EQ(made.status, 0) << made.errors;
    const Ended compared = fumon({"compare", films + "poses.png", "poses.png"}, folder.path());
    EXPECT_EQ(compared.status, 0) << compared.output << compared.errors;
}

}  // namespace
}  // namespace fumon
