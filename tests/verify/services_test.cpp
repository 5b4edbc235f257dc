// What CI services run, done by a shell: the steps of the action for GitHub, and the guide's job
// for GitLab.

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>
#include <vector>

#include "support/command.h"
#include "support/program.h"

namespace fumon::test {
namespace {

namespace fs = std::filesystem;

constexpr const char* the_action = FUMON_TEST_FOLDER "/../.github/actions/verify/action.yml";

std::size_t indentation(const std::string& line) {
    return std::min(line.find_first_not_of(' '), line.size());
}

/// The scripts of a YAML file's `run: |`, in their order.
std::vector<std::string> run_steps(const std::string& yaml) {
    std::vector<std::string> scripts;
    std::istringstream stream(yaml);
    std::size_t inside = 0;  // indentation of the script; 0: none
    for (std::string line; std::getline(stream, line);) {
        if (inside > 0 && (line.empty() || indentation(line) >= inside)) {
            scripts.back() += line.empty() ? "\n" : line.substr(inside) + "\n";
            continue;
        }
        inside = 0;
        if (!line.ends_with("run: |")) continue;
        inside = indentation(line) + 2;
        scripts.emplace_back();
    }
    return scripts;
}

/// The items of `script:` of the first job in a page's block of YAML that calls fumon verify.
std::vector<std::string> gitlab_script(const std::string& page) {
    std::vector<std::string> commands;
    std::istringstream stream(page.substr(page.find("codequality") - 400));
    bool inside = false;
    for (std::string line; std::getline(stream, line);) {
        if (inside && !line.starts_with("    - ")) break;
        if (inside) commands.push_back(line.substr(6));
        inside = inside || line == "  script:";
    }
    return commands;
}

class Services : public ::testing::Test {
  protected:
    Services() {
        write_text(folder_ / "scene.toml", small_scene());
        write_text(folder_ / "pictures.toml", "[cases]\na = {scene = \"scene.toml\", step = 0}\n");
    }

    /// Runs a script as bash does for a step, with fumon on the path.
    [[nodiscard]] Spoken step(const std::string& script, const std::string& environment) const {
        write_text(folder_ / "step.sh", script);
        return run_command("cd " + folder_.path().string() + " && env " + environment +
                           " PATH=" + fs::path(FUMON_PROGRAM).parent_path().string() +
                           ":$PATH bash --noprofile --norc -eo pipefail step.sh");
    }

    [[nodiscard]] bool is_there(const std::string& name) const {
        return fs::exists(folder_ / name);
    }

    ScratchFolder folder_;
};

TEST_F(Services, TheActionForGitHubRunsAsAShellRunsIt) {
    const std::vector<std::string> steps = run_steps(read_text(the_action));
    ASSERT_EQ(steps.size(), 2U);
    const Spoken install = step(steps[0], "PACKAGES= SOURCE=/nowhere");
    EXPECT_EQ(install.status, 0) << install.words;
    EXPECT_TRUE(install.words.starts_with("fumon ")) << install.words;
    const std::string inputs =
        "BASELINES=pictures.toml OUTPUT=verify-out GITHUB_WORKSPACE=" + folder_.path().string() +
        " GITHUB_STEP_SUMMARY=" + (folder_ / "summary.md").string();
    const Spoken missing = step(steps[1], inputs + " OPTIONS=");
    EXPECT_NE(missing.status, 0);
    EXPECT_NE(missing.words.find("::error file=pictures.toml,line=2,col=1,"), std::string::npos)
        << missing.words;
    EXPECT_TRUE(is_there("verify-out/index.html") && is_there("verify-out/verify.xml"));
    EXPECT_TRUE(is_there("summary.md"));
    EXPECT_EQ(step(steps[1], inputs + " OPTIONS='--update --pinned'").status, 0);
    const Spoken same = step(steps[1], inputs + " OPTIONS='--pinned -q'");
    EXPECT_EQ(same.status, 0) << same.words;
    EXPECT_FALSE(is_there("verify-out/index.html"));
}

/// The installation of packages and the one from source call what there is, with the paths that
/// they are given.
TEST_F(Services, TheActionInstallsPackagesOrTheSource) {
    const std::string install = run_steps(read_text(the_action)).at(0);
    fs::create_directories(folder_ / "bin");
    fs::create_directories(folder_ / "debs");
    fs::create_directories(folder_ / "source/.ci");
    write_text(folder_ / "debs/fumon_1.deb", "");
    write_text(folder_ / "debs/fumon-data_1.deb", "");
    write_text(folder_ / "source/.ci/install", "echo packages of the source\n");
    // Each of these says what it was called with; fumon is there once it was installed.
    const std::string fumon_there =
        "printf '#!/bin/sh\\necho fumon 1\\n' > bin/fumon; chmod +x bin/fumon\n";
    const std::string root = folder_.path().string();
    write_text(folder_ / "bin/apt-get", "#!/bin/sh\necho apt-get \"$@\"\ncd " + root +
                                            "\n[ \"$1\" = update ] || { " + fumon_there + "}\n");
    write_text(folder_ / "bin/cmake",
               "#!/bin/sh\necho cmake \"$@\" in \"$(basename \"$PWD\")\"\ncd " + root +
                   "\n[ \"$1\" = --workflow ] || { " + fumon_there + "}\n");
    write_text(folder_ / "bin/sudo", "#!/bin/sh\n\"$@\"\n");
    write_text(folder_ / "step.sh", install);
    const auto run = [&](const std::string& inputs) {
        fs::remove(folder_ / "bin/fumon");
        return run_command("cd " + root + " && chmod +x bin/* && env " + inputs + " PATH=" + root +
                           "/bin:/usr/bin:/bin bash --noprofile --norc -eo pipefail step.sh");
    };
    const Spoken packages = run("PACKAGES=debs SOURCE=/nowhere");
    EXPECT_EQ(packages.status, 0) << packages.words;
    EXPECT_EQ(packages.words, "apt-get update -q\napt-get install -q -y " + root +
                                  "/debs/fumon-data_1.deb " + root +
                                  "/debs/fumon_1.deb\nfumon 1\n");
    const Spoken source = run("PACKAGES= SOURCE=" + root + "/source");
    EXPECT_EQ(source.status, 0) << source.words;
    EXPECT_EQ(
        source.words,
        "packages of the source\ncmake --workflow --preset release in source\ncmake --install "
        "build/release in source\nfumon 1\n");
}

TEST_F(Services, TheGuidesJobForGitLabLeavesItsReports) {
    const auto commands = gitlab_script(read_text(fs::path(FUMON_GUIDE_FOLDER) / "verify.md"));
    ASSERT_EQ(commands.size(), 1U);
    const Spoken missing = step(commands[0] + "\n", "CI_PROJECT_DIR=" + folder_.path().string());
    EXPECT_NE(missing.status, 0) << missing.words;
    const auto report = nlohmann::json::parse(read_text(folder_ / "quality.json"));
    ASSERT_EQ(report.size(), 1U);
    EXPECT_EQ(report[0]["location"]["path"], "pictures.toml");
    EXPECT_TRUE(is_there("verify.xml") && is_there("verify-out/index.html"));
}

}  // namespace
}  // namespace fumon::test
