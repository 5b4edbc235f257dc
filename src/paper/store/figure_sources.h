#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "scene/initial_bed.h"
#include "scene/read.h"

namespace fumon {

/// A text that a figure is made from: a scene's or a CSV file's.
struct SourceText {
    std::string path;  ///< as reached from the working folder
    std::string text;
};

/// The files that figures are made from, read once each: from disk, or, where a figure is made
/// again, out of the figure itself.
class FigureSources {
  public:
    /// Finds where an input lies now; throws InputError where it is not there or has changed.
    using FindInput = std::function<std::filesystem::path(const InputFile&)>;

    /// `trusted`: of all scenes, see Scene::trusted; `version`: likewise, see SceneText::version.
    explicit FigureSources(bool trusted = true, std::string version = {})
        : trusted_(trusted), version_(std::move(version)) {}
    /// Of a figure that is made again.
    FigureSources(std::vector<SourceText> texts, std::vector<InputFile> inputs, FindInput find,
                  bool trusted, std::string version);

    /// The text of a scene or CSV file. Throws InputError where it cannot be read, or is not among
    /// the texts of the figure.
    const SourceText& text(const std::filesystem::path& file);
    SceneText scene(const std::filesystem::path& file);
    [[nodiscard]] const std::string& version() const { return version_; }
    /// Every text read so far, by path.
    [[nodiscard]] std::vector<SourceText> all() const;

    /// Makes the files that a scene's run reads those that lie there now, where a figure is made
    /// again.
    void find_inputs(Scene& scene) const;
    /// Where figure.icc_profile of a figure's scene lies now. Throws InputError likewise.
    [[nodiscard]] std::string profile(const Scene& scene) const;
    /// The name that such a file had when the figure was first made.
    [[nodiscard]] InputFile as_first_named(const InputFile& input) const;

  private:
    void find(const std::filesystem::path& named, std::string& file) const;

    bool again_ = false;
    bool trusted_ = true;
    std::string version_;  ///< whose defaults the scenes have
    std::map<std::string, SourceText> texts_;
    std::vector<InputFile> inputs_;
    FindInput find_;
};

}  // namespace fumon
