#include <gtest/gtest.h>

#include <set>
#include <string>

#include "view/server/request_guard.h"
#include "view/server/token.h"

namespace fumon {
namespace {

constexpr int forbidden = 403;
const std::string token = "0123456789abcdef0123456789abcdef";

RequestHead asked(const std::string& path) {
    return {"GET", path, "127.0.0.1:8000", "", ""};
}

TEST(RequestGuard, HearsThePageOfItsToken) {
    EXPECT_EQ(refusal_of(asked("/" + token + "/"), token), 0);
    RequestHead head = asked("/" + token + "/picture");
    head.method = "POST";
    head.host = "localhost:9999";  // forwarded
    head.origin = "http://localhost:9999";
    head.fetch_site = "same-origin";
    EXPECT_EQ(refusal_of(head, token), 0);
}

TEST(RequestGuard, RefusesOtherTokens) {
    for (const std::string& path :
         {std::string("/"), std::string(), "/" + token, "/" + token.substr(1) + "0/",
          "/x/" + token + "/", "/../" + token + "/", "//" + token + "/", "/" + token + "0/"})
        EXPECT_EQ(refusal_of(asked(path), token), forbidden) << path;
}

TEST(RequestGuard, RefusesOtherHosts) {
    for (const char* host : {"", "evil.example", "evil.example:8000", "127.0.0.1.evil.example",
                             "localhost.evil.example:8000", "127.0.0.1:", "127.0.0.1:80a",
                             "127.0.0.1:123456", "127.0.0.1@evil.example", "0.0.0.0:8000"}) {
        RequestHead head = asked("/" + token + "/");
        head.host = host;
        EXPECT_EQ(refusal_of(head, token), forbidden) << host;
    }
}

TEST(RequestGuard, RefusesPagesOfOthers) {
    for (const char* origin : {"null", "http://evil.example", "https://127.0.0.1:8000",
                               "http://127.0.0.1:8001", "http://localhost:8000"}) {
        RequestHead head = asked("/" + token + "/");
        head.origin = origin;
        EXPECT_EQ(refusal_of(head, token), forbidden) << origin;
    }
    RequestHead head = asked("/" + token + "/");
    head.method = "POST";
    for (const char* site : {"cross-site", "same-site", "none"}) {
        head.fetch_site = site;
        EXPECT_EQ(refusal_of(head, token), forbidden) << site;
    }
}

TEST(RequestGuard, RefusesOtherMethods) {
    for (const char* method : {"PUT", "DELETE", "OPTIONS", "PATCH", "TRACE", "get"}) {
        RequestHead head = asked("/" + token + "/");
        head.method = method;
        EXPECT_EQ(refusal_of(head, token), 405) << method;
    }
}

TEST(RequestGuard, TokensAreOf128BitsAndDiffer) {
    std::set<std::string> seen;
    for (int i = 0; i < 100; ++i) {
        const std::string made = random_token();
        EXPECT_EQ(made.size(), 32U);
        EXPECT_EQ(made.find_first_not_of("0123456789abcdef"), std::string::npos);
        seen.insert(made);
    }
    EXPECT_EQ(seen.size(), 100U);
    EXPECT_TRUE(same_secret("ab", "ab"));
    EXPECT_FALSE(same_secret("ab", "abc"));
    EXPECT_FALSE(same_secret("ab", "ac"));
}

}  // namespace
}  // namespace fumon
