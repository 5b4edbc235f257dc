#pragma once

#include <cstdint>
#include <mutex>
#include <optional>
#include <string>

#include "run/terminal/job_watch.h"
#include "view/server/http_server.h"

namespace fumon {

/// What a server answers of the job that goes on in its program:
///
///     GET job?client=…      how far it is, as JSON; "last" in the query: once it has ended the
///                           client asks for nothing more
///     GET job-picture       its newest picture, a JPEG; 404 where there is none yet
///     POST stop             stops it, as Ctrl-C does
class JobPage {
  public:
    /// `watch` outlives it.
    explicit JobPage(JobWatch& watch) : watch_(watch) {}

    /// None for what is no question of the job.
    std::optional<HttpAnswer> answer(const HttpRequest& request);

  private:
    [[nodiscard]] HttpAnswer state_answer(const HttpRequest& request);
    [[nodiscard]] HttpAnswer picture_answer();

    JobWatch& watch_;
    std::mutex mutex_;
    std::shared_ptr<const Image> encoded_;  ///< what `bytes_` shows
    std::string bytes_;
};

}  // namespace fumon
