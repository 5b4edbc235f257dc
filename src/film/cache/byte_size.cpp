#include "film/cache/byte_size.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <system_error>

#include "base/error.h"

namespace fumon {

std::int64_t bytes_of_size(const std::string& text, const std::string& name) {
    double number = 0.0;
    const char* const end = text.data() + text.size();
    const auto read = std::from_chars(text.data(), end, number);
    std::string unit(read.ptr, end);
    std::ranges::transform(unit, unit.begin(), [](unsigned char letter) {
        return static_cast<char>(letter >= 'A' && letter <= 'Z' ? letter + 'a' - 'A' : letter);
    });
    const double factor = unit.empty() || unit == "b" ? 1.0
                          : unit == "kb"              ? 1e3
                          : unit == "mb"              ? 1e6
                          : unit == "gb"              ? 1e9
                                                      : 0.0;
    const double bytes = number * factor;
    constexpr double most = 1e15;
    if (read.ec != std::errc{} || !(bytes >= 1.0) || bytes > most)
        throw InputError(
            fmt::format("{}: it takes a size such as 8MB or 500kB, not \"{}\"", name, text));
    return static_cast<std::int64_t>(std::llround(bytes));
}

}  // namespace fumon
