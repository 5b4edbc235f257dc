// What a page asks of `fumon view`: the first line names it, the rest is its body. Nothing is
// drawn.

#include <algorithm>
#include <string>

#include "fuzz_input.h"
#include "run/prepared_run.h"
#include "scene/read.h"
#include "view/scene/scene_pages.h"
#include "view/server/request_guard.h"

namespace {

using namespace fumon;

constexpr const char* tiny_scene =
    "[model]\nname = \"sand\"\n[grid]\nnx = 8\nny = 6\n[run]\nsteps = 2\n";

Pages& pages() {
    static const auto read = [](const std::vector<std::string>& settings) {
        return parse_scene(tiny_scene, "tiny.toml", ".", settings);
    };
    static ScenePages all("tiny.toml", prepare_run(read({}), 1), {}, read, {});
    return all;
}

/// A head that the guard hears has the token, and names this machine.
void check_guard(std::string_view text) {
    const std::string token(32, 'a');
    RequestHead head{"GET", "/" + token + "/", "127.0.0.1", "", ""};
    std::string* const parts[] = {&head.method, &head.path, &head.host, &head.origin,
                                  &head.fetch_site};
    for (std::string* part : parts) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        if (end > 0) *part = text.substr(0, end);
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    if (refusal_of(head, token) != 0) return;
    if (!head.path.starts_with("/" + token + "/"))
        fuzz::broken_promise("a request has the token", head.path);
    if (!head.host.starts_with("127.0.0.1") && !head.host.starts_with("localhost") &&
        !head.host.starts_with("[::1]"))
        fuzz::broken_promise("a request names this machine", head.host);
    if (!head.origin.empty() && head.origin != "http://" + head.host)
        fuzz::broken_promise("a page of others is refused", head.origin);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view text = fuzz::as_text(data, size);
    check_guard(text);
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string path(text.substr(0, end));
    if (path == "picture" || path == "still") return 0;  // which draw
    const std::string body(text.substr(std::min(end + 1, text.size())));
    fuzz::taken(
        [&] {
            const HttpAnswer answer = pages().answer({"POST", path, {}, body});
            if (answer.status == 200 && answer.body.find("root:x:") != std::string::npos)
                fuzz::broken_promise("no file of others is told", path);
        },
        fuzz::RefusalLines::many);
    static_cast<void>(pages().answer({"GET", path, {}, body}));
    return 0;
}
