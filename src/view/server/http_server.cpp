#include "view/server/http_server.h"

#include <fmt/format.h>
#include <httplib.h>
#include <netinet/in.h>
#include <sys/socket.h>

#include <algorithm>
#include <atomic>
#include <charconv>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <exception>
#include <limits>
#include <mutex>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

#include "base/error.h"
#include "view/server/connections.h"
#include "view/server/request_guard.h"
#include "view/server/token.h"

namespace fumon {

namespace {

constexpr const char* loopback = "127.0.0.1";
constexpr int length_required = 411;
constexpr int too_large = 413;
constexpr int unprocessable = 422;
constexpr int failed = 500;
constexpr int most_waiting = 256;          // connections that the system keeps
constexpr std::size_t most_accepted = 64;  // that no thread serves yet; each is a descriptor

/// All that a page loads comes from this server, and no page of others shows it; but notebooks of
/// this machine, where they may.
httplib::Headers safe_headers(bool in_notebooks) {
    const std::string shown_by =
        in_notebooks ? "http://127.0.0.1:* http://localhost:* vscode-webview:" : "'none'";
    httplib::Headers headers = {
        {"Content-Security-Policy",
         "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self' blob:; "
         "connect-src 'self'; base-uri 'none'; form-action 'none'; frame-ancestors " +
             shown_by},
        {"X-Content-Type-Options", "nosniff"},
        {"Referrer-Policy", "no-referrer"},
        {"Cross-Origin-Resource-Policy", "same-origin"},
        {"Cross-Origin-Opener-Policy", "same-origin"},
        {"Cache-Control", "no-store"}};
    if (!in_notebooks) headers.emplace("X-Frame-Options", "DENY");
    return headers;
}

/// Threads that are started as they are needed, up to a number. Where many connections wait no
/// further one is accepted, so that they leave descriptors for the files of a job.
class Threads : public httplib::TaskQueue {
  public:
    explicit Threads(std::size_t most) : most_(most) {}

    // Newer versions of the library ask whether the task was taken.
    using Taken = decltype(std::declval<httplib::TaskQueue&>().enqueue({}));
    Taken enqueue(std::function<void()> task) override {
        {
            std::unique_lock lock(mutex_);
            room_.wait(lock, [&] { return tasks_.size() < most_accepted; });
            tasks_.push_back(std::move(task));
            if (idle_ < tasks_.size() && threads_.size() < most_)
                threads_.emplace_back([this] { work(); });
        }
        wake_.notify_one();
        return Taken(true);
    }

    void shutdown() override {
        {
            const std::lock_guard lock(mutex_);
            ended_ = true;
        }
        wake_.notify_all();
        for (std::thread& thread : threads_) thread.join();
    }

  private:
    void work() {
        std::unique_lock lock(mutex_);
        for (;;) {
            ++idle_;
            wake_.wait(lock, [&] { return ended_ || !tasks_.empty(); });
            --idle_;
            if (tasks_.empty()) return;
            const std::function<void()> task = std::move(tasks_.front());
            tasks_.pop_front();
            lock.unlock();
            room_.notify_one();
            task();
            lock.lock();
        }
    }

    std::size_t most_;
    std::mutex mutex_;
    std::condition_variable wake_;
    std::condition_variable room_;
    std::deque<std::function<void()>> tasks_;
    std::vector<std::thread> threads_;
    std::size_t idle_ = 0;
    bool ended_ = false;
};

RequestHead head_of(const httplib::Request& request) {
    return {request.method, request.path, request.get_header_value("Host"),
            request.get_header_value("Origin"), request.get_header_value("Sec-Fetch-Site")};
}

/// A body without a length, or packed, would pass the limit of the library, which asks for
/// Content-Length alone.
bool has_length(const httplib::Request& request) {
    return !request.has_header("Transfer-Encoding") && !request.has_header("Content-Encoding") &&
           (request.method != "POST" || request.has_header("Content-Length"));
}

/// What Content-Length says; the largest number where that is none.
std::uint64_t length_of(const httplib::Request& request) {
    const std::string text = request.get_header_value("Content-Length");
    if (text.empty()) return 0;
    std::uint64_t length = 0;
    const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), length);
    const bool whole = fault == std::errc{} && end == text.data() + text.size();
    return whole ? length : std::numeric_limits<std::uint64_t>::max();
}

std::size_t most_bytes(const httplib::Request& request, const std::string& token,
                       const HttpLimits& limits) {
    return request.path == "/" + token + "/terrain" ? limits.upload_bytes : limits.body_bytes;
}

}  // namespace

struct HttpServer::State {
    State(HttpHandler answers, const HttpLimits& limits)
        : handler(std::move(answers)), connections(limits.first_request_s, limits.connection_s) {}

    void answer(const httplib::Request& asked, httplib::Response& answer) const {
        HttpRequest request{asked.method == "POST" ? "POST" : "GET",
                            asked.path.substr(token.size() + 2),
                            {},
                            asked.body};
        for (const auto& [name, value] : asked.params) request.query[name] = value;
        HttpAnswer made;
        try {
            made = handler(request);
        } catch (const InputError& fault) {
            made = {unprocessable, "text/plain; charset=utf-8", fault.what()};
        } catch (const std::exception& fault) {
            made = {failed, "text/plain; charset=utf-8", fault.what()};
        }
        answer.status = made.status;
        for (const auto& [name, value] : made.headers) answer.set_header(name, value);
        answer.set_content(made.body, made.type);
    }

    void watch() {
        std::unique_lock lock(mutex);
        while (!ended) {
            connections.close_old();
            wake.wait_for(lock, std::chrono::milliseconds(500), [&] { return ended; });
        }
    }

    HttpHandler handler;
    Connections connections;
    std::string token = random_token();
    int port = 0;
    httplib::Server server;
    std::thread listener;
    std::thread watcher;
    std::mutex mutex;
    std::condition_variable wake;
    bool ended = false;
};

HttpServer::HttpServer(HttpHandler handler, int port, const HttpLimits& limits)
    : state_(std::make_unique<State>(std::move(handler), limits)) {
    State& state = *state_;
    httplib::Server& server = state.server;
    server.new_task_queue = [most = limits.threads] { return new Threads(most); };
    // The library's own choice lets other programs listen on the same port.
    int listening = -1;
    server.set_socket_options([&listening](socket_t socket) {
        listening = socket;
        const int yes = 1;
        setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
    });
    server.set_default_headers(safe_headers(limits.in_notebooks));
    server.set_payload_max_length(std::max(limits.body_bytes, limits.upload_bytes));
    server.set_keep_alive_timeout(2);
    server.set_read_timeout(5);
    server.set_write_timeout(5);
    server.set_pre_routing_handler(
        [&state, limits](const httplib::Request& request, httplib::Response& answer) {
            int refusal = refusal_of(head_of(request), state.token);
            if (refusal == 0 && !has_length(request)) refusal = length_required;
            if (refusal == 0 && length_of(request) > most_bytes(request, state.token, limits))
                refusal = too_large;
            if (refusal == 0) {
                state.connections.admit(request.remote_port);
                return httplib::Server::HandlerResponse::Unhandled;
            }
            answer.status = refusal;
            answer.set_header("Connection", "close");
            answer.set_content("refused: open the whole address that `fumon view` printed\n",
                               "text/plain");
            return httplib::Server::HandlerResponse::Handled;
        });
    const auto answers = [&state](const httplib::Request& request, httplib::Response& answer) {
        state.answer(request, answer);
    };
    server.Get(".*", answers);
    server.Post(".*", answers);
    if (port == 0) {
        state.port = server.bind_to_any_port(loopback);
    } else if (server.bind_to_port(loopback, port)) {
        state.port = port;
    }
    if (state.port <= 0) {
        if (port == 0) throw Error("the system gives no port to listen on");
        throw InputError(fmt::format(
            "--port {}: another program listens there, or the system keeps it (as those below "
            "1024); choose another, or leave --port out for a free one",
            port));
    }
    ::listen(listening, most_waiting);  // the library lets five wait, and the next for seconds
    state.connections.listen_on(state.port);
    state.listener = std::thread([&state] { state.server.listen_after_bind(); });
    state.watcher = std::thread([&state] { state.watch(); });
    while (!server.is_running()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
}

HttpServer::~HttpServer() {
    State& state = *state_;
    {
        const std::lock_guard lock(state.mutex);
        state.ended = true;
    }
    state.wake.notify_all();
    if (state.watcher.joinable()) state.watcher.join();
    std::atomic<bool> listens{true};
    std::thread closes([&] {  // those too that are accepted meanwhile
        while (listens) {
            state.connections.close_all();
            std::this_thread::sleep_for(std::chrono::milliseconds(20));
        }
    });
    state.server.stop();
    if (state.listener.joinable()) state.listener.join();
    listens = false;
    closes.join();
}

int HttpServer::port() const {
    return state_->port;
}

const std::string& HttpServer::token() const {
    return state_->token;
}

std::string HttpServer::address() const {
    return fmt::format("http://{}:{}/{}/", loopback, state_->port, state_->token);
}

}  // namespace fumon
