#include "view/server/address_lines.h"

#include <fmt/format.h>
#include <unistd.h>

#include <array>

namespace fumon {

std::string address_lines(const HttpServer& server) {
    std::string text = server.address() + "\n";
    std::array<char, 256> host{};
    if (gethostname(host.data(), host.size() - 1) == 0) {
        text += fmt::format("from another machine: ssh -L {0}:127.0.0.1:{0} {1}\n", server.port(),
                            host.data());
    }
    return text;
}

}  // namespace fumon
