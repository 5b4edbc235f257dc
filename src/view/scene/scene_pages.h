#pragma once

#include <filesystem>
#include <functional>
#include <list>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "run/prepared_run.h"
#include "scene/scene.h"
#include "view/server/pages.h"
#include "view/view_options.h"

namespace fumon {

/// The window of a scene that has not run, as ViewPage answers it, with settings of the model too:
/// for each set of values the model is computed anew, as far as one looks. The last two are kept.
class ScenePages : public Pages {
  public:
    /// The scene with further settings "key.path=VALUE". Throws InputError as read_scene().
    using ReadScene = std::function<Scene(const std::vector<std::string>&)>;

    /// `run`: prepared of the scene without further settings; `files`: those that it is read from.
    ScenePages(std::string name, PreparedRun run, std::vector<std::filesystem::path> files,
               ReadScene read, ViewOptions options);

    /// Throws InputError, too, where the model's settings are wrong or beyond trust_limits.
    HttpAnswer answer(const HttpRequest& request) override;
    void cancel_all() override;

  private:
    struct Computed {
        std::vector<std::string> settings;  ///< of the model
        std::shared_ptr<Pages> pages;
    };

    [[nodiscard]] Scene scene_with(const std::vector<std::string>& settings) const;
    [[nodiscard]] std::shared_ptr<Pages> pages_of(const std::vector<std::string>& settings);
    [[nodiscard]] std::shared_ptr<Pages> computed(PreparedRun run) const;

    std::string name_;
    std::vector<std::filesystem::path> files_;
    ReadScene read_;
    ViewOptions options_;
    std::shared_ptr<Pages> own_;
    std::mutex mutex_;
    std::list<Computed> others_;  ///< the last used first
    bool cancelled_ = false;
};

}  // namespace fumon
