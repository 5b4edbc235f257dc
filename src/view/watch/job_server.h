#pragma once

#include <functional>
#include <memory>
#include <mutex>
#include <string>

#include "run/terminal/job_watch.h"
#include "view/server/pages.h"
#include "view/watch/job_page.h"

namespace fumon {

/// The window of a job while it goes on. Until a client comes it does nothing but listen.
class JobServer {
  public:
    using MakePages = std::function<std::unique_ptr<Pages>()>;

    /// `make_pages`: what is answered besides JobPage, made when the first client asks. `watch`
    /// outlives it. Throws as HttpServer.
    JobServer(JobWatch& watch, MakePages make_pages, int port);
    /// Ends it as end() where that has not been called.
    ~JobServer();
    JobServer(const JobServer&) = delete;
    JobServer& operator=(const JobServer&) = delete;

    /// Tells those who watch how the job ended, and listens no more.
    void end(const std::string& outcome);

    /// As address_lines().
    [[nodiscard]] std::string address_lines() const;

  private:
    HttpAnswer answer(const HttpRequest& request);

    JobWatch& watch_;
    JobPage job_;
    MakePages make_pages_;
    std::mutex mutex_;
    std::unique_ptr<Pages> pages_;
    std::unique_ptr<HttpServer> server_;
};

/// The page of a job that has a picture and no ground to look at: assets/view/watch.html.
class WatchPages : public Pages {
  public:
    /// `title`: what the page calls the job.
    explicit WatchPages(std::string title) : title_(std::move(title)) {}

    HttpAnswer answer(const HttpRequest& request) override;

  private:
    std::string title_;
};

}  // namespace fumon
