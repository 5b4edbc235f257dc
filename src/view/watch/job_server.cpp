#include "view/watch/job_server.h"

#include <exception>
#include <nlohmann/json.hpp>
#include <utility>

#include "scene/json.h"
#include "view/page_files.h"
#include "view/server/address_lines.h"

namespace fumon {

JobServer::JobServer(JobWatch& watch, MakePages make_pages, int port)
    : watch_(watch),
      job_(watch),
      make_pages_(std::move(make_pages)),
      server_(std::make_unique<HttpServer>(
          [this](const HttpRequest& request) { return answer(request); }, port)) {}

JobServer::~JobServer() {
    end(std::uncaught_exceptions() > 0 ? "failed; the terminal says why" : "ended");
}

void JobServer::end(const std::string& outcome) {
    if (!server_) return;
    watch_.end(outcome);
    {
        const std::lock_guard lock(mutex_);
        if (pages_) pages_->cancel_all();
    }
    server_.reset();
}

std::string JobServer::address_lines() const {
    return fumon::address_lines(*server_);
}

HttpAnswer JobServer::answer(const HttpRequest& request) {
    if (auto of_job = job_.answer(request)) return *std::move(of_job);
    Pages* pages = nullptr;
    {
        const std::lock_guard lock(mutex_);
        if (!pages_) pages_ = make_pages_();
        pages = pages_.get();
    }
    return pages->answer(request);
}

HttpAnswer WatchPages::answer(const HttpRequest& request) {
    constexpr int not_found = 404;
    if (request.method == "GET" && request.path == "about") {
        HttpAnswer answer;
        answer.type = "application/json";
        answer.body = json_text({{"title", title_}, {"job", true}, {"sweep", false}});
        return answer;
    }
    if (request.method == "GET") {
        if (auto file = page_file(request.path, "watch.html")) return *std::move(file);
    }
    return plain_answer(not_found, "no such page");
}

}  // namespace fumon
