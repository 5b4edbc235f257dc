// Bytes that a program sends to the server of `fumon view`, as they are; "@" stands for the token
// where the first byte is "@".

#include <string>

#include "../support/raw_http.h"
#include "fuzz_input.h"
#include "view/server/http_server.h"

namespace {

using namespace fumon;

HttpServer& server() {
    static HttpServer one(
        [](const HttpRequest& request) -> HttpAnswer {
            return {200, "text/plain", request.method + request.path};
        },
        0);
    return one;
}

std::string with_token(std::string_view text) {
    std::string bytes;
    for (const char letter : text) {
        if (letter == '@')
            bytes += server().token();
        else
            bytes += letter;
    }
    return bytes;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    std::string_view text = fuzz::as_text(data, size);
    const bool knows = text.starts_with('@');
    if (knows) text.remove_prefix(1);
    {
        const RawConnection connection(server().port());
        connection.send(knows ? with_token(text) : std::string(text));
        connection.end_sending();
        const std::string answer = connection.read_all();
        if (!knows && answer.starts_with("HTTP/1.1 200"))
            fuzz::broken_promise("nothing is answered without the token", answer);
        if (answer.find("Access-Control-") != std::string::npos)
            fuzz::broken_promise("no page of others is let in", answer);
    }
    return 0;
}
