// The commands of guide pages, done in the order in which they stand there.

#include <gtest/gtest.h>

#include <array>
#include <sstream>

#include "support/command.h"
#include "support/program.h"

namespace fumon::test {
namespace {

namespace fs = std::filesystem;

/// The blocks of a page that a shell runs, one after another.
std::string shell_blocks(const std::string& page) {
    std::istringstream stream(page);
    std::string script = "set -euo pipefail\n";
    bool inside = false;
    for (std::string line; std::getline(stream, line);) {
        if (line.starts_with("```")) {
            inside = !inside && line == "```sh";
        } else if (inside) {
            script += line + "\n";
        }
    }
    return script;
}

/// Runs a page's blocks in a folder; programs of other makers are taken from its folder "bin".
Spoken do_page(const ScratchFolder& folder, const std::string& page) {
    write_text(folder / "page.sh", shell_blocks(read_text(fs::path(FUMON_GUIDE_FOLDER) / page)));
    return run_command("cd " + folder.path().string() + " && chmod +x bin/* && PATH=$PWD/bin:" +
                       fs::path(FUMON_PROGRAM).parent_path().string() + ":$PATH bash page.sh");
}

TEST(Guide, TheCommandLine) {
    const ScratchFolder folder;
    fs::create_directory(folder / "bin");
    write_text(folder / "bin/none", "");
    fs::create_directory_symlink(fs::path(FUMON_GUIDE_FOLDER).parent_path(), folder / "assets");
    const Spoken spoken = do_page(folder, "command-line.md");
    EXPECT_EQ(spoken.status, 0) << spoken.words;
    EXPECT_TRUE(read_text(folder / "ripples.png").starts_with("\x89PNG"));
}

TEST(Guide, AFirstOwnScene) {
    const ScratchFolder folder;
    fs::create_directory(folder / "bin");
    write_text(folder / "bin/none", "");
    const Spoken spoken = do_page(folder, "first-scene.md");
    EXPECT_EQ(spoken.status, 0) << spoken.words;
    EXPECT_FALSE(read_text(folder / "out/low/movie.mp4").empty());
    const std::string page = read_text(fs::path(FUMON_GUIDE_FOLDER) / "first-scene.md");
    for (const char* line : {"my.toml: fine (", "wrong.toml:"}) {
        const std::size_t at = spoken.words.find(line);
        ASSERT_NE(at, std::string::npos) << spoken.words;
        const std::string said = spoken.words.substr(at, spoken.words.find('\n', at) - at + 1);
        EXPECT_NE(page.find(said), std::string::npos) << "the page does not say: " << said;
    }
}

TEST(Guide, ManyMachines) {
    const ScratchFolder folder;
    fs::create_directory(folder / "bin");
    // A cluster that does all tasks at once and the merge after them, and ranks one after another.
    write_text(
        folder / "bin/sbatch",
        "#!/bin/bash\nset -e\nlast=${!#}\ntasks=$(sed -n 's/^#SBATCH --array=1-//p' \"$last\" "
        "2> /dev/null || true)\n"
        "for one in \"$@\"; do case $one in\n"
        "--array=*) first=${one#*=} tasks=${one#*=} ;;\n"
        "--wrap=*) echo \"${one#*=}\" >> merges; exit ;;\nesac; done\n"
        "export SLURM_ARRAY_JOB_ID=1 SLURM_ARRAY_TASK_MIN=${first:-1}\n"
        "for task in $(seq ${first:-1} $tasks); do SLURM_ARRAY_TASK_ID=$task bash \"$last\"; "
        "done\nbash merges; rm merges\n");
    for (const auto& [starter, rank, size] :
         {std::array{"mpirun", "OMPI_COMM_WORLD_RANK", "OMPI_COMM_WORLD_SIZE"},
          std::array{"srun", "SLURM_PROCID", "SLURM_NTASKS"}}) {
        write_text(folder / (std::string("bin/") + starter),
                   std::string("#!/bin/bash\nset -e\nranks=$2\nshift 2\nfor ((rank = 0; rank < "
                               "ranks; ++rank)); do\nexport ") +
                       rank + "=$rank " + size + "=$ranks\n\"$@\"\ndone\n");
    }
    write_text(folder / "bin/fumon",  // small frames
               std::string("#!/bin/sh\ncase $1 in\nrun) exec '") + FUMON_PROGRAM +
                   "' \"$@\" --set image.width=320 --set image.height=180;;\n*) exec '" +
                   FUMON_PROGRAM + "' \"$@\";;\nesac\n");
    const Spoken spoken = do_page(folder, "cluster.md");
    EXPECT_EQ(spoken.status, 0) << spoken.words;
    const std::string table = read_text(folder / "out/ripples/sweep.csv");
    EXPECT_FALSE(table.empty());
    EXPECT_EQ(read_text(folder / "out/slurm/sweep.csv"), table);
    EXPECT_EQ(read_text(folder / "out/mpi/sweep.csv"), table);
    EXPECT_EQ(read_text(folder / "out/srun/sweep.csv"), table);
    EXPECT_FALSE(read_text(folder / "out/both/sweep.csv").empty());
    EXPECT_FALSE(read_text(folder / "out/drawn/movie.mp4").empty());
}

TEST(Guide, AFigureForAJournalInTwoLanguages) {
    const ScratchFolder folder;
    fs::create_directory(folder / "bin");
    write_text(folder / "bin/fumon",  // five minutes of the hour of rain, in small pictures
               std::string("#!/bin/sh\ncase $1 in\nfigure) exec '") + FUMON_PROGRAM +
                   "' \"$@\" --set run.steps=30 --set figure.dots_per_inch=72;;\n*) exec '" +
                   FUMON_PROGRAM + "' \"$@\";;\nesac\n");
    const Spoken spoken = do_page(folder, "journal.md");
    ASSERT_EQ(spoken.status, 0) << spoken.words;
    for (const char* file : {"en/gully.pdf", "en/gully-a.asc", "en/gully-b-2.csv", "ja/gully.png"})
        EXPECT_TRUE(fs::exists(folder / file)) << file;
    EXPECT_EQ(read_text(folder / "ja/gully-a.asc"), read_text(folder / "en/gully-a.asc"));
    EXPECT_FALSE(fs::exists(folder / "ja/runs"));
}

TEST(Guide, ImageTestsInAnotherProject) {
    const ScratchFolder folder;
    fs::create_directory(folder / "bin");
    write_text(folder / "bin/none", "");
    EXPECT_EQ(do_page(folder, "image-tests.md").status, 0);
}

TEST(Guide, TellsOneVersionAndOneDateOfItsRelease) {
    const fs::path guide = FUMON_GUIDE_FOLDER;
    const std::string citation = read_text(guide / "CITATION.cff");
    EXPECT_NE(citation.find("\nversion: " FUMON_VERSION "\n"), std::string::npos);
    EXPECT_NE(read_text(guide / "citing.md").find("version " FUMON_VERSION "."), std::string::npos);
    const std::string key = "\ndate-released: ";
    const std::size_t released = citation.find(key);
    const std::string date = released == std::string::npos
                                 ? "not released yet"
                                 : citation.substr(released + key.size(), 10);
    const std::string changes = read_text(guide / "CHANGELOG.md");
    const std::string heading = changes.substr(changes.find("\n## ") + 4);
    EXPECT_EQ(heading.substr(0, heading.find('\n')), FUMON_VERSION " (" + date + ")");
}

TEST(Guide, FromTerrainToAFilmOfRain) {
    const ScratchFolder folder;
    fs::create_directory(folder / "bin");
    write_text(folder / "bin/fumon",  // small pictures; ten minutes where the page has an hour
               std::string("#!/bin/sh\nsmall='--quiet --set image.width=480 --set "
                           "image.height=320 --set image.supersampling=1'\n"
                           "case \"$*\" in *model.rain=*) small=\"$small --set run.steps=60 --set "
                           "frames.every=20 --set output.fields_every=10\";; esac\n"
                           "case $1 in\nrun|still) what=$1; shift; exec '") +
                   FUMON_PROGRAM + "' $what $small \"$@\";;\n*) exec '" + FUMON_PROGRAM +
                   "' \"$@\";;\nesac\n");
    const Spoken spoken = do_page(folder, "gis.md");
    ASSERT_EQ(spoken.status, 0) << spoken.words;
    for (const char* file :
         {"look/frames/frame_000000.png", "rain/movie.mp4", "rain/fields.nc", "stream.csv",
          "stream.png", "line.csv", "line.png", "drainage.png", "cut/measurements.csv",
          "maps/frames/frame_000001.pgw", "maps/beds/bed_00000060.asc", "map.png",
          "map.png.aux.xml", "rain.pvd", "rain_000006.vts", "dem.glb", "dem.stl"})
        EXPECT_TRUE(fs::exists(folder / file)) << file;
    EXPECT_FALSE(fs::exists(folder / "look/movie.mp4"));
    const std::string header = read_text(folder / "gauged/measurements.csv");
    for (const char* column : {"mouth_depth_m", "section_discharge_m3s"})
        EXPECT_NE(header.find(column), std::string::npos) << column;
}

}  // namespace
}  // namespace fumon::test
