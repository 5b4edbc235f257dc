#pragma once

#include "view/server/http_server.h"

namespace fumon {

/// What a server answers. Any thread may ask.
class Pages {
  public:
    Pages() = default;
    virtual ~Pages() = default;
    Pages(const Pages&) = delete;
    Pages& operator=(const Pages&) = delete;

    virtual HttpAnswer answer(const HttpRequest& request) = 0;
    /// Gives up what waits, so that no answer lasts longer than the work that is under way.
    virtual void cancel_all() {}
};

/// An answer of one line.
inline HttpAnswer plain_answer(int status, const std::string& text) {
    HttpAnswer answer;
    answer.status = status;
    answer.body = text;
    return answer;
}

}  // namespace fumon
