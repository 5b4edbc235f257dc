#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <filesystem>
#include <iterator>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "base/error.h"
#include "support/raw_http.h"
#include "view/server/http_server.h"

namespace fumon {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

/// A server that says what it was asked for.
class ViewServer : public testing::Test {
  protected:
    HttpServer& serve(const HttpLimits& limits = {}) {
        server_ = std::make_unique<HttpServer>(
            [this](const HttpRequest& request) -> HttpAnswer {
                ++asked_;
                if (request.path == "wrong") throw InputError("wrong; right");
                if (request.path == "large")
                    return {200, "application/octet-stream", std::string(1U << 24U, 'x')};
                return {200, "text/plain", request.method + " " + request.path + request.body};
            },
            0, limits);
        port_ = server_->port();
        base_ = "/" + server_->token() + "/";
        return *server_;
    }

    std::unique_ptr<HttpServer> server_;
    std::atomic<int> asked_{0};
    int port_ = 0;
    std::string base_;
};

TEST_F(ViewServer, AnswersBelowItsToken) {
    serve();
    EXPECT_EQ(body_of(ask(port_, "GET", base_ + "a/b")), "GET a/b");
    EXPECT_EQ(body_of(ask(port_, "POST", base_ + "c", "localhost:1", "", "body")), "POST cbody");
    const std::string wrong = ask(port_, "GET", base_ + "wrong");
    EXPECT_EQ(status_of(wrong), "422");
    EXPECT_EQ(body_of(wrong), "wrong; right");
}

TEST_F(ViewServer, RefusesForgedRequestsBeforeTheHandler) {
    serve();
    EXPECT_EQ(status_of(ask(port_, "GET", "/")), "403");
    EXPECT_EQ(status_of(ask(port_, "GET", "/" + std::string(32, '0') + "/")), "403");
    EXPECT_EQ(status_of(ask(port_, "GET", "/.." + base_)), "403");
    EXPECT_EQ(status_of(ask(port_, "GET", base_, "evil.example")), "403");
    EXPECT_EQ(status_of(ask(port_, "GET", base_, "127.0.0.1", "Origin: http://evil.example\r\n")),
              "403");
    EXPECT_EQ(
        status_of(ask(port_, "POST", base_, "127.0.0.1", "Sec-Fetch-Site: cross-site\r\n", "body")),
        "403");
    EXPECT_EQ(status_of(ask(port_, "DELETE", base_)), "405");
    EXPECT_EQ(status_of(ask(port_, "OPTIONS", base_)), "405");
    EXPECT_EQ(asked_, 0);
}

TEST_F(ViewServer, EveryAnswerForbidsWhatComesFromElsewhere) {
    serve();
    for (const std::string& path : {base_, std::string("/")}) {
        const std::string answer = ask(port_, "GET", path);
        EXPECT_NE(answer.find("Content-Security-Policy: default-src 'none'"), std::string::npos);
        EXPECT_NE(answer.find("frame-ancestors 'none'"), std::string::npos);
        EXPECT_NE(answer.find("X-Content-Type-Options: nosniff"), std::string::npos);
        EXPECT_NE(answer.find("Referrer-Policy: no-referrer"), std::string::npos);
        EXPECT_EQ(answer.find("Access-Control-"), std::string::npos);
    }
}

TEST_F(ViewServer, LimitsWhatARequestHolds) {
    HttpLimits limits;
    limits.body_bytes = 100;
    limits.upload_bytes = 1000;
    serve(limits);
    const auto status_of_body = [&](const std::string& path, std::size_t bytes) {
        return status_of(
            ask(port_, "POST", base_ + path, "127.0.0.1", "", std::string(bytes, 'x')));
    };
    EXPECT_EQ(status_of_body("", 101), "413");
    EXPECT_EQ(status_of_body("a/terrain", 101), "413");
    EXPECT_EQ(status_of_body("terrain", 1001), "413");
    EXPECT_EQ(status_of(ask(port_, "POST", base_, "127.0.0.1", "Content-Length: 1x\r\n")), "413");
    EXPECT_EQ(status_of(ask(port_, "GET", base_ + std::string(1U << 14U, 'x'))), "414");
    for (const char* more : {"Transfer-Encoding: chunked\r\n", "Content-Encoding: gzip\r\n", ""})
        EXPECT_EQ(status_of(ask(port_, "POST", base_, "127.0.0.1", more)), "411") << more;
    EXPECT_EQ(asked_, 0);
    EXPECT_EQ(status_of_body("terrain", 101), "200");
}

TEST_F(ViewServer, TwoHundredClientsOnThreadsAndCutRequestsLeaveItAlive) {
    serve();
    std::vector<std::unique_ptr<RawConnection>> cut;
    for (int i = 0; i < 200; ++i) {
        cut.push_back(std::make_unique<RawConnection>(port_));
        cut.back()->send("GET " + base_ + "large HT");
    }
    cut.clear();
    {
        const RawConnection vanishes(port_);
        vanishes.send("GET " + base_ + "large HTTP/1.1\r\nHost: localhost\r\n\r\n");
    }
    std::atomic<int> heard{0};
    std::vector<std::thread> clients;
    for (int i = 0; i < 200; ++i) {
        clients.emplace_back([&] {
            if (status_of(ask(port_, "GET", base_ + "x")) == "200") ++heard;
        });
    }
    for (std::thread& client : clients) client.join();
    EXPECT_EQ(heard, 200);
}

TEST_F(ViewServer, AcceptsNoMoreConnectionsThanItServesSoon) {
    HttpLimits limits;
    limits.threads = 4;
    serve(limits);
    const auto descriptors = [] {
        const std::filesystem::directory_iterator all("/proc/self/fd");
        return std::distance(begin(all), end(all));
    };
    std::vector<std::unique_ptr<RawConnection>> idle;
    for (int i = 0; i < 200; ++i) idle.push_back(std::make_unique<RawConnection>(port_));
    std::this_thread::sleep_for(std::chrono::milliseconds(300));
    EXPECT_LT(descriptors(), 200 + 100);  // those of both ends
    idle.clear();
    EXPECT_EQ(status_of(ask(port_, "GET", base_ + "x")), "200");
}

TEST_F(ViewServer, ClosesConnectionsThatAskForNothing) {
    HttpLimits limits;
    limits.first_request_s = 0.3;
    limits.threads = 2;
    serve(limits);
    const RawConnection idle(port_);
    const RawConnection slow(port_);
    slow.send("GET / HTTP/1.1\r\nX: ");
    std::atomic<bool> ended{false};
    std::thread drips([&] {
        while (!ended && slow.send("x")) std::this_thread::sleep_for(std::chrono::milliseconds(50));
    });
    const auto start = Clock::now();
    EXPECT_EQ(idle.read_all(), "");
    static_cast<void>(slow.read_all());
    EXPECT_LT(seconds_since(start), 4.0);
    ended = true;
    drips.join();
    EXPECT_EQ(status_of(ask(port_, "GET", base_ + "x")), "200");
}

TEST_F(ViewServer, ClosesConnectionsThatSendMuchBeforeTheirToken) {
    HttpLimits limits;
    limits.first_request_s = 1000.0;
    serve(limits);
    const RawConnection endless(port_);
    bool taken = endless.send("GET / HTTP/1.1\r\n");
    for (int i = 0; taken && i < 1000; ++i) taken = endless.send(std::string(1U << 16U, 'x'));
    EXPECT_FALSE(taken);
}

TEST_F(ViewServer, EndsWhileClientsHangOn) {
    serve();
    std::vector<std::unique_ptr<RawConnection>> hanging;
    for (int i = 0; i < 20; ++i) {
        hanging.push_back(std::make_unique<RawConnection>(port_));
        hanging.back()->send("GET " + base_ + " HTTP/1.1\r\nX: y");
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    const auto start = Clock::now();
    server_.reset();
    EXPECT_LT(seconds_since(start), 4.0);  // else it waits for their time to read, of 5 s
}

TEST_F(ViewServer, ListensOnTheLoopbackAloneAndOnAPortAlone) {
    const HttpServer& server = serve();
    EXPECT_EQ(server.address(), "http://127.0.0.1:" + std::to_string(port_) + base_);
    EXPECT_THROW(HttpServer([](const HttpRequest&) { return HttpAnswer{}; }, port_), InputError);
}

}  // namespace
}  // namespace fumon
