#pragma once

#include <string>
#include <string_view>

namespace fumon {

/// What decides whether a request is heard.
struct RequestHead {
    std::string method;
    std::string path;  ///< decoded
    std::string host;
    std::string origin;      ///< empty: none
    std::string fetch_site;  ///< Sec-Fetch-Site; empty: none
};

/// Whether a Host header names this machine's loopback, at any port: that of a forwarded one is
/// chosen at the other end. A page of a name that was bound to 127.0.0.1 (DNS rebinding) sends its
/// own name.
bool is_loopback_host(std::string_view host);

/// The status with which a request is refused, 0 where it is heard: 405 for a method other than
/// GET, HEAD and POST; 403 for another host, for a page of another origin and for a path that does
/// not begin with "/TOKEN/".
int refusal_of(const RequestHead& head, std::string_view token);

}  // namespace fumon
