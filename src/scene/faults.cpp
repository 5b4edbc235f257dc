#include "scene/faults.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <limits>
#include <tuple>

namespace fumon {

namespace {

/// Where a fault stands: "SOURCE:LINE:COLUMN: …". What stands in no line of the file comes before
/// its lines, what stands elsewhere after them.
struct SourcePosition {
    long line = std::numeric_limits<long>::max();
    long column = 0;
};

SourcePosition place_of(const std::string& text, const std::string& source) {
    SourcePosition place;
    if (!text.starts_with(source + ":")) return place;
    place.line = 0;
    const char* const end = text.data() + text.size();
    const char* at = text.data() + source.size() + 1;
    const auto line = std::from_chars(at, end, place.line);
    if (line.ec == std::errc{} && line.ptr != end) std::from_chars(line.ptr + 1, end, place.column);
    return place;
}

}  // namespace

void Faults::add(const InputError& fault) {
    for (const std::string& line : fault.lines()) {
        if (std::find(lines_.begin(), lines_.end(), line) == lines_.end()) lines_.push_back(line);
    }
    if (lines_.size() >= enough) report();
}

void Faults::report() const {
    if (none()) return;
    constexpr std::size_t most = 20;
    std::vector<std::string> lines = lines_;
    std::stable_sort(lines.begin(), lines.end(),
                     [this](const std::string& one, const std::string& other) {
                         const SourcePosition a = place_of(one, source_);
                         const SourcePosition b = place_of(other, source_);
                         return std::tie(a.line, a.column) < std::tie(b.line, b.column);
                     });
    if (lines.size() > most) {
        const std::size_t more = lines.size() - most;
        lines.resize(most);
        lines.push_back(fmt::format("{}: and {}{} more", source_,
                                    lines_.size() < enough ? "" : "at least ", more));
    }
    throw InputError(std::move(lines));
}

}  // namespace fumon
