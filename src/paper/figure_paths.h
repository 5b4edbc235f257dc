#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <string_view>

#include "paper/figure_plan.h"
#include "paper/store/figure_sources.h"

namespace fumon {

/// How a figure's files call those that it was made from, without folders of this machine: a path
/// from the root of the file system is told from the folder of the figure's scene or, where both
/// lie in different trees, by the file's name alone. Any other path stays.
class FigurePaths {
  public:
    FigurePaths(const FigurePlan& plan, const FigureSources& sources);

    /// The name of such a path.
    [[nodiscard]] std::string name_of(const std::string& path) const;
    /// A text in which these paths have their names.
    [[nodiscard]] std::string in_text(std::string_view text) const;
    /// The text of a source, whose names count from its own folder.
    [[nodiscard]] std::string in_source(const SourceText& source) const;

  private:
    std::filesystem::path folder_;  ///< of the figure's scene
    std::map<std::string, std::string, std::greater<>>
        names_;  ///< longer paths before their folders
};

}  // namespace fumon
