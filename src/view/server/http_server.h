#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <string>

namespace fumon {

/// A request that the guard let pass.
struct HttpRequest {
    std::string method;  ///< "GET" (of HEAD too) or "POST"
    std::string path;    ///< decoded, what follows "/TOKEN/"
    std::map<std::string, std::string> query;
    std::string body;
};

struct HttpAnswer {
    int status = 200;
    std::string type = "text/plain; charset=utf-8";
    std::string body{};
    std::map<std::string, std::string> headers{};
};

/// Called on many threads at once. What it throws becomes an answer: InputError of status 422 with
/// its message, all else of status 500.
using HttpHandler = std::function<HttpAnswer(const HttpRequest&)>;

struct HttpLimits {
    std::size_t body_bytes = 1U << 18U;    ///< of a request
    std::size_t upload_bytes = 1U << 26U;  ///< of one that uploads a file: POST "terrain"
    std::size_t threads = 48;              ///< requests that are answered at once; others wait
    double first_request_s = 10.0;         ///< within which a connection asks for what it may have
    bool in_notebooks = false;             ///< pages of this machine may show it in a frame
    double connection_s = 3600.0;          ///< after its last request, however long one is drawn
};

/// An HTTP server for one user of this machine, who has its address: it listens on 127.0.0.1
/// alone, answers only below a random token, to requests that name this machine and come from no
/// page of others (see refusal_of()), and lets a browser take nothing from elsewhere. The lengths
/// of requests and the numbers of threads are limited, and connections that ask for nothing are
/// closed.
class HttpServer {
  public:
    /// `port` 0: any that is free. Throws InputError where the port is taken, Error where the
    /// system gives no socket or token.
    HttpServer(HttpHandler handler, int port, const HttpLimits& limits = {});
    /// Ends all connections; a handler that is at work is waited for.
    ~HttpServer();
    HttpServer(const HttpServer&) = delete;
    HttpServer& operator=(const HttpServer&) = delete;

    [[nodiscard]] int port() const;
    [[nodiscard]] const std::string& token() const;
    /// "http://127.0.0.1:PORT/TOKEN/".
    [[nodiscard]] std::string address() const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace fumon
