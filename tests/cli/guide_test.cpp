// The commands of a page of the guide, as a user would paste them, with small pictures.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "support/program.h"

namespace fumon::test {
namespace {

namespace fs = std::filesystem;

/// The blocks of a page that a shell runs, one after the other.
std::string commands_of(const fs::path& page) {
    std::ifstream stream(page);
    std::string commands = "set -e\n";
    bool inside = false;
    for (std::string line; std::getline(stream, line);) {
        if (line.starts_with("```")) {
            inside = line == "```sh";
            continue;
        }
        if (inside) commands += line + "\n";
    }
    return commands;
}

TEST(Guide, TheCommandsOfThePageOnGisWork) {
    const ScratchFolder folder;
    const fs::path root = fs::path(FUMON_SOURCES_FOLDER).parent_path();
    fs::create_directory_symlink(root / "assets", folder / "assets");
    fs::create_directory(folder / "bin");
    const fs::path program = folder / "bin/fumon";
    write_text(program, std::string("#!/bin/sh\ncase $1 in\nrun|still) exec '") + FUMON_PROGRAM +
                            "' \"$@\" --quiet --set image.width=480 --set image.height=320 --set "
                            "image.supersampling=1;;\n*) exec '" +
                            FUMON_PROGRAM + "' \"$@\";;\nesac\n");
    fs::permissions(program, fs::perms::owner_all);
    const std::string commands = commands_of(root / "assets/guide/gis.md");
    EXPECT_NE(commands.find("fumon export"), std::string::npos);
    write_text(folder / "commands.sh", commands);
    const Ended ended = fumon({folder / "commands.sh"}, folder.path(),
                              {"PATH=" + (folder / "bin").string() + ":/usr/bin:/bin"}, "/bin/sh");
    ASSERT_EQ(ended.status, 0) << ended.errors;
    for (const char* file :
         {"look/frames/frame_000000.png", "rain/movie.mp4", "rain/fields.nc", "stream.csv",
          "stream.png", "cut/measurements.csv", "maps/frames/frame_000001.pgw",
          "maps/beds/bed_00000060.asc", "map.png", "map.png.aux.xml", "rain.pvd", "rain_000006.vts",
          "dem.glb", "dem.stl"})
        EXPECT_TRUE(fs::exists(folder / file)) << file;
    EXPECT_FALSE(fs::exists(folder / "look/movie.mp4"));
    const std::string header = read_text(folder / "gauged/measurements.csv");
    for (const char* column : {"mouth_depth_m", "section_discharge_m3s"})
        EXPECT_NE(header.find(column), std::string::npos) << column;
}

}  // namespace
}  // namespace fumon::test
