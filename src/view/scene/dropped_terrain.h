#pragma once

#include <cstdint>
#include <filesystem>
#include <list>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "files/scratch_folder.h"
#include "view/server/pages.h"
#include "view/view_options.h"

namespace fumon {

/// Pages beside which terrain may be opened that a user drops on them:
///
///     POST terrain?name=dem.tif   its bytes → {"open": "terrain/1/"}
///     terrain/1/…                 the window of that terrain
///
/// The file goes into a folder of this program alone, by a name of its own, and is deleted when its
/// terrain is closed, the folder with these pages. It is read with the limits of a scene of unknown
/// origin, as a format that names no other file. The last four are kept.
class DroppedTerrain : public Pages {
  public:
    DroppedTerrain(std::unique_ptr<Pages> pages, ViewOptions options);

    HttpAnswer answer(const HttpRequest& request) override;
    void cancel_all() override;

  private:
    struct Opened {
        std::int64_t number;
        std::filesystem::path file;
        std::shared_ptr<Pages> pages;
    };

    [[nodiscard]] HttpAnswer open(const HttpRequest& request);
    [[nodiscard]] HttpAnswer opened_answer(HttpRequest request);

    std::unique_ptr<Pages> pages_;
    ViewOptions options_;
    std::mutex mutex_;
    std::optional<fumon::ScratchFolder> folder_;  ///< from the first file on
    std::list<Opened> opened_;                    ///< the newest first
    std::int64_t count_ = 0;
    bool cancelled_ = false;
};

}  // namespace fumon
