#include "view/server/connections.h"

#include <linux/tcp.h>
#include <netinet/in.h>
#include <sys/socket.h>

#include <cstdint>
#include <utility>
#include <vector>

namespace fumon {

namespace {

constexpr int most_descriptors = 4096;
/// Before the token is seen; the library itself does not limit the headers of a request.
constexpr std::uint64_t most_unknown_bytes = 1U << 20U;

int port_of(int socket, int (*name)(int, sockaddr*, socklen_t*)) {
    sockaddr_in address{};
    socklen_t length = sizeof address;
    void* const place = &address;
    const bool known = name(socket, static_cast<sockaddr*>(place), &length) == 0;
    return known && address.sin_family == AF_INET ? ntohs(address.sin_port) : 0;
}

int local_name(int socket, sockaddr* address, socklen_t* length) {
    return getsockname(socket, address, length);
}

int remote_name(int socket, sockaddr* address, socklen_t* length) {
    return getpeername(socket, address, length);
}

std::uint64_t received_bytes(int socket) {
    tcp_info info{};
    socklen_t length = sizeof info;
    const bool known = getsockopt(socket, IPPROTO_TCP, TCP_INFO, &info, &length) == 0;
    return known ? info.tcpi_bytes_received : 0;
}

/// Sockets that are connected to a local port, with the ports at their other ends.
std::vector<std::pair<int, int>> connected_to(int port) {
    std::vector<std::pair<int, int>> found;
    for (int descriptor = 3; descriptor < most_descriptors; ++descriptor) {
        if (port_of(descriptor, local_name) != port) continue;
        if (const int remote = port_of(descriptor, remote_name); remote != 0)
            found.emplace_back(descriptor, remote);
    }
    return found;
}

}  // namespace

void Connections::admit(int remote_port) {
    const std::lock_guard lock(mutex_);
    known_.insert_or_assign(remote_port, Connection{std::chrono::steady_clock::now(), true});
}

void Connections::close_old() {
    const std::lock_guard lock(mutex_);
    const auto now = std::chrono::steady_clock::now();
    std::map<int, Connection> present;
    for (const auto& [socket, remote] : connected_to(port_)) {
        const auto known = known_.find(remote);
        const Connection connection = known == known_.end() ? Connection{now} : known->second;
        const double age = std::chrono::duration<double>(now - connection.since).count();
        const bool floods = !connection.admitted && received_bytes(socket) > most_unknown_bytes;
        if (floods || age > (connection.admitted ? connection_s_ : first_request_s_)) {
            shutdown(socket, SHUT_RDWR);
        } else {
            present.emplace(remote, connection);
        }
    }
    known_ = std::move(present);
}

void Connections::close_all() const {
    for (const auto& [socket, remote] : connected_to(port_)) shutdown(socket, SHUT_RDWR);
}

}  // namespace fumon
