#pragma once

#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "files/scratch_folder.h"

namespace fumon::test {

/// What a program said and how it ended.
struct Ended {
    int status = 0;  ///< exit status, or 128 + signal
    std::string output;
    std::string errors;
};

/// A running fumon; its standard output and error go to files.
class Program {
  public:
    /// Starts fumon with these arguments in a folder; `environment` is added to the test's own.
    Program(const std::vector<std::string>& arguments, const std::filesystem::path& folder,
            const std::vector<std::string>& environment = {},
            const std::string& program = FUMON_PROGRAM);
    ~Program();
    Program(const Program&) = delete;
    Program& operator=(const Program&) = delete;

    void send(int signal) const;
    /// Its standard output so far.
    [[nodiscard]] std::string output() const;
    [[nodiscard]] int process() const { return process_; }
    Ended wait();

  private:
    int process_ = -1;
    std::filesystem::path output_;
    std::filesystem::path errors_;
};

Ended fumon(const std::vector<std::string>& arguments, const std::filesystem::path& folder,
            const std::vector<std::string>& environment = {},
            const std::string& program = FUMON_PROGRAM);

/// A folder of the test's own, empty, deleted at the end.
class ScratchFolder : public fumon::ScratchFolder {
  public:
    [[nodiscard]] std::filesystem::path operator/(const std::string& name) const {
        return path() / name;
    }
};

/// Whether a text has a part.
inline bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

std::string read_text(const std::filesystem::path& file);
void write_text(const std::filesystem::path& file, const std::string& text);
nlohmann::json read_manifest(const std::filesystem::path& folder);

/// A scene that runs in a moment: 24×20 cells, 20 steps, five frames of 64×48.
std::string small_scene();

/// Settings with which sand of `small_scene()` near 1e6 heights leaves their range within a few
/// steps.
std::vector<std::string> settings_that_leave_the_range();

}  // namespace fumon::test
