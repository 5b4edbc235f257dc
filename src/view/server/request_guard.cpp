#include "view/server/request_guard.h"

#include <algorithm>

#include "view/server/token.h"

namespace fumon {

namespace {

constexpr int forbidden = 403;
constexpr int method_not_allowed = 405;

bool is_port(std::string_view text) {
    return !text.empty() && text.size() <= 5 &&
           std::ranges::all_of(text, [](char c) { return c >= '0' && c <= '9'; });
}

}  // namespace

bool is_loopback_host(std::string_view host) {
    for (const std::string_view name : {"127.0.0.1", "localhost", "[::1]"}) {
        if (host == name) return true;
        if (host.starts_with(name) && host[name.size()] == ':' &&
            is_port(host.substr(name.size() + 1)))
            return true;
    }
    return false;
}

int refusal_of(const RequestHead& head, std::string_view token) {
    if (head.method != "GET" && head.method != "HEAD" && head.method != "POST")
        return method_not_allowed;
    if (!is_loopback_host(head.host)) return forbidden;
    if (!head.origin.empty() && head.origin != "http://" + head.host) return forbidden;
    const bool own_page = head.fetch_site.empty() || head.fetch_site == "same-origin";
    if (head.method == "POST" && !own_page) return forbidden;
    const std::string_view path = head.path;
    if (path.size() < token.size() + 2 || path.front() != '/' || path[token.size() + 1] != '/' ||
        !same_secret(path.substr(1, token.size()), token))
        return forbidden;
    return 0;
}

}  // namespace fumon
