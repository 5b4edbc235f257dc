#include "base/nearest_name.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <numeric>

namespace fumon {

namespace {

/// Optimal string alignment distance (Damerau 1964), ignoring case, where it is below `limit`; else
/// the limit or more.
std::size_t distance(std::string_view a, std::string_view b, std::size_t limit) {
    const std::size_t least = a.size() > b.size() ? a.size() - b.size() : b.size() - a.size();
    if (least >= limit) return least;
    const auto same = [](char p, char q) {
        return std::tolower(static_cast<unsigned char>(p)) ==
               std::tolower(static_cast<unsigned char>(q));
    };
    std::vector<std::size_t> before_last(b.size() + 1);
    std::vector<std::size_t> last(b.size() + 1);
    std::vector<std::size_t> current(b.size() + 1);
    std::iota(last.begin(), last.end(), std::size_t{0});
    std::size_t least_before = 0;  // of the row before
    for (std::size_t i = 1; i <= a.size(); ++i) {
        current[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t replaced = last[j - 1] + (same(a[i - 1], b[j - 1]) ? 0 : 1);
            current[j] = std::min({last[j] + 1, current[j - 1] + 1, replaced});
            if (i > 1 && j > 1 && same(a[i - 1], b[j - 2]) && same(a[i - 2], b[j - 1])) {
                current[j] = std::min(current[j], before_last[j - 2] + 1);
            }
        }
        const std::size_t least_now = *std::min_element(current.begin(), current.end());
        if (std::min(least_now, least_before) >= limit) return limit;
        least_before = least_now;
        std::swap(before_last, last);
        std::swap(last, current);
    }
    return last[b.size()];
}

std::vector<std::string_view> parts_of(std::string_view name) {
    std::vector<std::string_view> parts;
    for (std::size_t start = 0; start <= name.size();) {
        const std::size_t end = std::min(name.find('.', start), name.size());
        parts.push_back(name.substr(start, end - start));
        start = end + 1;
    }
    return parts;
}

std::size_t most_off(std::string_view word) {
    return std::max<std::size_t>(1, word.size() / 3);
}

/// Whether each part of a dotted name is near its own: "camera.target" means no "camera.margin",
/// however much else they share.
bool parts_are_near(std::string_view wrong, std::string_view name) {
    const auto a = parts_of(wrong);
    const auto b = parts_of(name);
    if (a.size() != b.size()) return true;
    return std::equal(a.begin(), a.end(), b.begin(), [](std::string_view p, std::string_view q) {
        return distance(p, q, most_off(p) + 1) <= most_off(p);
    });
}

}  // namespace

std::string nearest_name(std::string_view wrong, const std::vector<std::string>& known) {
    std::string nearest;
    std::size_t smallest = most_off(wrong) + 1;
    for (const std::string& name : known) {
        const std::size_t off = distance(wrong, name, smallest);
        if (off < smallest && parts_are_near(wrong, name)) {
            smallest = off;
            nearest = name;
        }
    }
    return nearest;
}

std::string suggestion(std::string_view wrong, const std::vector<std::string>& known) {
    const std::string nearest = nearest_name(wrong, known);
    if (!nearest.empty()) return fmt::format("did you mean \"{}\"?", nearest);
    return fmt::format("known: {}", fmt::join(known, ", "));
}

}  // namespace fumon
