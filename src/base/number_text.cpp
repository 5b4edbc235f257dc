#include "base/number_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cstddef>

namespace fumon {

namespace {

std::string between_thousands(const std::string& digits) {
    std::string text;
    const std::size_t whole = std::min(digits.find('.'), digits.size());
    for (std::size_t place = 0; place < digits.size(); ++place) {
        const bool third = place < whole && (whole - place) % 3 == 0;
        const bool inside =
            place > 0 && std::isdigit(static_cast<unsigned char>(digits[place - 1]));
        if (third && inside) text += ',';
        text += digits[place];
    }
    return text;
}

}  // namespace

std::string with_commas(std::int64_t number) {
    return between_thousands(fmt::format("{}", number));
}

std::string with_commas(double number, int decimals) {
    return between_thousands(fmt::format("{:.{}f}", number, decimals));
}

}  // namespace fumon
