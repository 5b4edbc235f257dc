#pragma once

#include <chrono>
#include <map>
#include <mutex>

namespace fumon {

/// The connections of other programs to a port of this process, told apart by their own ports.
class Connections {
  public:
    Connections(double first_request_s, double connection_s)
        : first_request_s_(first_request_s), connection_s_(connection_s) {}

    void listen_on(int port) { port_ = port; }

    /// Notes that one has asked for what it may have.
    void admit(int remote_port);

    /// Closes those that have lasted too long, or sent too much before they were admitted; called
    /// now and then.
    void close_old();

    /// Closes all, so that no thread waits for one.
    void close_all() const;

  private:
    struct Connection {
        std::chrono::steady_clock::time_point since;
        bool admitted = false;
    };

    int port_ = 0;
    double first_request_s_;
    double connection_s_;
    std::mutex mutex_;
    std::map<int, Connection> known_;  ///< by the port at the other end
};

}  // namespace fumon
