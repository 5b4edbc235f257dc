// How deeply TOML nests, as said before it is read, against what the reader makes of it. Each of
// the bytes 1 to 6 stands for many parts of a key, lists, inline tables and items, so that short
// inputs reach the limit.

#include <algorithm>
#include <map>

#include "fuzz_input.h"
#include "keys/toml_text.h"

namespace {

std::string unfolded(std::string_view folded) {
    const auto repeated = [](std::string_view text) {
        constexpr int times = 50;
        std::string all;
        for (int n = 0; n < times; ++n) all += text;
        return all;
    };
    static const std::map<char, std::string> runs{
        {'\1', repeated("a.")}, {'\2', repeated("[")}, {'\3', repeated("{a=")},
        {'\4', repeated("]")},  {'\5', repeated("}")}, {'\6', repeated("'b' . \"c\" .")}};
    std::string text;
    for (const char c : folded) {
        const auto run = runs.find(c);
        if (run == runs.end()) {
            text += c;
        } else {
            text += run->second;
        }
    }
    return text;
}

struct Depth {
    int keys = 0;    ///< on the way to a value
    int levels = 0;  ///< keys, lists and inline tables
};

Depth depth_of(const toml::node& node) {
    Depth depth;
    const auto take = [&depth](const toml::node& child, int keys) {
        const Depth below = depth_of(child);
        depth.keys = std::max(depth.keys, below.keys + keys);
        depth.levels = std::max(depth.levels, below.levels);
    };
    if (const toml::table* table = node.as_table()) {
        for (const auto& [key, value] : *table) take(value, 1);
        depth.levels += (table->empty() ? 0 : 1) + (table->is_inline() ? 1 : 0);
    } else if (const toml::array* list = node.as_array()) {
        for (const toml::node& item : *list) take(item, 0);
        depth.levels += 1;
    }
    return depth;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace fumon;
    constexpr std::size_t longest = 4096;
    const std::string text = unfolded(fuzz::as_text(data, size));
    Depth depth;
    std::string refusal;
    try {
        depth = depth_of(parse_toml(text, "scene.toml", "a scene is TOML"));
    } catch (const InputError& error) {
        refusal = error.what();
    }
    // The header of a list of tables, [[a.b]], may make two levels of each of its parts.
    if (depth.keys > deepest_toml || depth.levels > 2 * deepest_toml)
        fuzz::broken_promise("what is taken nests no deeper than said", text);
    if (refusal.find("nest deeper than") == std::string::npos || text.size() > longest) return 0;
    try {
        depth = depth_of(toml::parse(text));
    } catch (const toml::parse_error&) {
        return 0;
    }
    constexpr int of_numbers = 3;  // "1.5" counts as a key of two parts
    if (depth.levels < deepest_toml - of_numbers)
        fuzz::broken_promise("what is refused nests as deeply as said", text);
    return 0;
}
