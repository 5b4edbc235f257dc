#include "picture/pixels/ignore_rules.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <string_view>

#include "base/error.h"
#include "base/limits.h"
#include "base/nearest_name.h"
#include "files/input_file.h"
#include "files/png_reader.h"
#include "scene/figure/overlay_kinds.h"

namespace fumon {

namespace {

constexpr std::int64_t longest_side = 65535;  // pixels, of any picture

/// A box of four numbers; none where it is no box of pixels.
std::optional<PixelBox> box_of(const std::array<std::int64_t, 4>& numbers) {
    const auto [x, y, width, height] = numbers;
    const bool inside = x >= 0 && y >= 0 && width >= 1 && height >= 1;
    const bool small = std::all_of(numbers.begin(), numbers.end(),
                                   [](std::int64_t number) { return number <= longest_side; });
    if (!inside || !small) return std::nullopt;
    return PixelBox{x, y, width, height};
}

std::string box_text(const PixelBox& box) {
    return fmt::format("[{}, {}, {}, {}]", box.x, box.y, box.width, box.height);
}

constexpr const char* what_a_box_is =
    "x and y from the upper left corner, 0 or more, and a width and height of 1 or more, all whole "
    "pixels up to 65535";

PixelBox read_box(const toml::array& items, const std::string& place, const std::string& path) {
    std::array<std::int64_t, 4> numbers{};
    bool whole = items.size() == numbers.size();
    for (std::size_t i = 0; whole && i < numbers.size(); ++i) {
        const std::optional<std::int64_t> number = items[i].value_exact<std::int64_t>();
        whole = number.has_value();
        if (whole) numbers.at(i) = *number;
    }
    const auto box = whole ? box_of(numbers) : std::nullopt;
    if (box) return *box;
    throw InputError(
        fmt::format("{}: a box of {} is [x, y, width, height]: {}", place, path, what_a_box_is));
}

std::string read_overlay(const std::string& word, const std::string& place,
                         const std::string& path) {
    std::vector<std::string> known;
    for (const auto& kind : overlay_kinds) {
        if (kind.choice.enumerator != OverlayKind::coordinates)
            known.emplace_back(kind.choice.word);
    }
    if (std::find(known.begin(), known.end(), word) != known.end()) return word;
    if (word == "coordinates") {
        throw InputError(fmt::format(
            "{}: {}: coordinates cover the whole picture; name boxes or a mask", place, path));
    }
    throw InputError(fmt::format("{}: {}: unknown kind of overlay \"{}\"; {}", place, path, word,
                                 suggestion(word, known)));
}

void add_mask(IgnoredPixels& ignored, const std::filesystem::path& file) {
    const std::string bytes = read_input_file(file);
    const Image mask = PngReader(bytes, file.string()).image();
    if (mask.width != ignored.width || mask.height != ignored.height) {
        throw InputError(fmt::format(
            "{}: is a mask of {} x {} pixels for a picture of {} x {}; make it the same size",
            file.string(), mask.width, mask.height, ignored.width, ignored.height));
    }
    ignored.add(mask);
}

}  // namespace

PixelBox read_box(const std::string& text) {
    std::array<std::int64_t, 4> numbers{};
    const char* at = text.data();
    const char* end = at + text.size();
    bool good = true;
    for (std::size_t i = 0; good && i < numbers.size(); ++i) {
        const auto [next, fault] = std::from_chars(at, end, numbers.at(i));
        const bool last = i + 1 == numbers.size();
        good = fault == std::errc() && (last ? next == end : next != end && *next == ',');
        at = last || !good ? next : next + 1;
    }
    const auto box = good ? box_of(numbers) : std::nullopt;
    if (box) return *box;
    throw InputError(
        fmt::format("\"{}\" is not a box; write X,Y,WIDTH,HEIGHT: {}", text, what_a_box_is));
}

void read_ignore(const toml::node& value, const std::string& path, const Locate& locate,
                 IgnoreRules& rules) {
    if (!value.is_array()) {
        throw InputError(fmt::format(
            "{}: {} is a list of boxes and kinds of overlays, as [[0, 0, 120, 24], \"time\"]",
            locate(value.source()), path));
    }
    for (const toml::node& item : *value.as_array()) {
        const std::string place = locate(item.source());
        if (const auto* word = item.as_string()) {
            rules.overlays.push_back(read_overlay(word->get(), place, path));
        } else if (const toml::array* items = item.as_array()) {
            rules.boxes.push_back(read_box(*items, place, path));
        } else {
            throw InputError(fmt::format(
                "{}: {} takes boxes, [x, y, width, height], and kinds of overlays, as \"time\"",
                place, path));
        }
    }
}

IgnoredPixels ignored_pixels(const IgnoreRules& rules, const Image& picture,
                             const std::filesystem::path& folder,
                             const std::vector<PixelBox>& of_overlays) {
    IgnoredPixels ignored(picture.width, picture.height);
    for (const PixelBox& box : rules.boxes) {
        if (box.x >= picture.width || box.y >= picture.height) {
            throw InputError(
                fmt::format("ignore: the box {} lies outside of the picture of {} x {} pixels",
                            box_text(box), picture.width, picture.height));
        }
        ignored.add(box);
    }
    for (const PixelBox& box : of_overlays) ignored.add(box);
    if (!rules.mask.empty()) add_mask(ignored, folder / rules.mask);
    check_share(ignored);
    return ignored;
}

void check_share(const IgnoredPixels& ignored) {
    if (ignored.share() <= largest_ignored_share) return;
    throw InputError(
        fmt::format("{:.1f} % of the picture would be ignored, more than {:g} %; ignore less",
                    100.0 * ignored.share(), 100.0 * largest_ignored_share));
}

}  // namespace fumon
