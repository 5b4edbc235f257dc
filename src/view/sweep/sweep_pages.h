#pragma once

#include <cstdint>
#include <filesystem>
#include <list>
#include <map>
#include <memory>
#include <mutex>
#include <string>

#include "base/worker_pool.h"
#include "view/server/pages.h"
#include "view/sweep/sweep_listing.h"
#include "view/view_options.h"

namespace fumon {

/// The window of a sweep:
///
///     GET                     the page, its styles and modules: assets/view/watch.html
///     GET about               its title, and whether a job goes on
///     GET sweep               axes and runs, as JSON
///     GET picture?run=3       a small picture of a run's last bed, a JPEG
///     run/3/…                 the window of that run, as ViewPage answers it
class SweepPages : public Pages {
  public:
    /// Throws InputError where the folder holds no sweep.
    SweepPages(const std::filesystem::path& folder, ViewOptions options);

    HttpAnswer answer(const HttpRequest& request) override;
    void cancel_all() override;

  private:
    [[nodiscard]] HttpAnswer about_answer();
    [[nodiscard]] HttpAnswer sweep_answer();
    [[nodiscard]] HttpAnswer picture_answer(std::int64_t number);
    [[nodiscard]] HttpAnswer run_answer(HttpRequest request);
    /// Throws InputError where there is no such run with beds.
    [[nodiscard]] std::shared_ptr<Pages> pages_of(std::int64_t number);
    void check_shown(std::int64_t number);

    struct OpenRun {
        std::int64_t number;
        std::shared_ptr<Pages> pages;
    };

    ViewOptions options_;
    std::mutex listing_mutex_;
    SweepListing listing_;
    std::mutex open_mutex_;
    std::list<OpenRun> open_;  ///< the last used first
    std::mutex picture_mutex_;
    WorkerPool pool_;
    std::map<std::int64_t, std::string> pictures_;
    bool cancelled_ = false;
};

}  // namespace fumon
