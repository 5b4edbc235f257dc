#pragma once

#include <string>
#include <vector>

#include "support/program.h"

namespace fumon::test {

/// A folder with a small scene and baselines of it.
class VerifyFolder {
  public:
    VerifyFolder() { write_text(folder_ / "scene.toml", small_scene()); }

    /// A baseline of the scene's step 10; `cases` are lines below [cases].
    void write_baseline(const std::string& name, const std::string& cases,
                        const std::string& head = "") const {
        write_text(folder_ / name,
                   "scene = \"scene.toml\"\nstep = 10\n" + head + "[cases]\n" + cases);
    }

    [[nodiscard]] Ended verify(std::vector<std::string> words,
                               const std::vector<std::string>& environment = {}) const {
        words.insert(words.begin(), "verify");
        return fumon(words, folder_.path(), environment);
    }

    [[nodiscard]] std::string text(const std::string& name) const {
        return read_text(folder_ / name);
    }

    [[nodiscard]] bool has(const std::string& name) const {
        return std::filesystem::exists(folder_ / name);
    }

  protected:
    ScratchFolder folder_;
};

}  // namespace fumon::test
