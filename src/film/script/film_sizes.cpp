#include "film/script/film_sizes.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <optional>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "base/error.h"
#include "base/find_named.h"
#include "base/nearest_name.h"

namespace fumon {

namespace {

struct NamedSize {
    std::string_view name;
    FilmSize size;
};

constexpr std::array<NamedSize, 9> named_sizes{{{"1080p", {1920, 1080}},
                                                {"720p", {1280, 720}},
                                                {"360p", {640, 360}},
                                                {"4k", {3840, 2160}},
                                                {"8k", {7680, 4320}},
                                                {"vertical", {1080, 1920}},
                                                {"square", {1080, 1080}},
                                                {"widescreen", {2580, 1080}},
                                                {"small", {480, 270}}}};

/// Of "1920x1080"; nothing of any other text.
std::optional<FilmSize> sides_of(std::string_view text) {
    const std::size_t cross = text.find('x');
    if (cross == std::string_view::npos) return std::nullopt;
    const auto trimmed = [](std::string_view part) {
        while (part.starts_with(' ')) part.remove_prefix(1);
        while (part.ends_with(' ')) part.remove_suffix(1);
        return part;
    };
    FilmSize sides;
    const auto is_number = [](std::string_view digits, std::int64_t& number) {
        const char* end = digits.data() + digits.size();
        const auto [at, fault] = std::from_chars(digits.data(), end, number);
        return fault == std::errc() && at == end;
    };
    if (!is_number(trimmed(text.substr(0, cross)), sides.width)) return std::nullopt;
    if (!is_number(trimmed(text.substr(cross + 1)), sides.height)) return std::nullopt;
    return sides;
}

}  // namespace

std::string film_size_names() {
    std::string text;
    for (const NamedSize& named : named_sizes)
        text += fmt::format("{}{} ({} x {})", text.empty() ? "" : ", ", named.name,
                            named.size.width, named.size.height);
    return text;
}

FilmSize film_size(const Film& film) {
    const FilmSettings& settings = film.settings;
    if (settings.width != 0 || settings.height != 0) {
        for (const auto& [key, side] :
             {std::pair{"film.width", settings.width}, std::pair{"film.height", settings.height}}) {
            if (side < smallest_film_side) {
                throw InputError(fmt::format(
                    "{}{} = {}: a film has {} to {} pixels along each side; give both sides, or a "
                    "name in film.size",
                    film.at(key), key, side, smallest_film_side, largest_film_side));
            }
        }
        return {settings.width, settings.height};
    }
    if (const NamedSize* named = find_named(named_sizes, settings.size)) return named->size;
    if (const std::optional<FilmSize> sides = sides_of(settings.size)) {
        if (std::min(sides->width, sides->height) >= smallest_film_side &&
            std::max(sides->width, sides->height) <= largest_film_side)
            return *sides;
        throw InputError(fmt::format(
            "{}film.size = \"{}\": a film has {} to {} pixels along each side",
            film.at("film.size"), settings.size, smallest_film_side, largest_film_side));
    }
    std::vector<std::string> known;
    known.reserve(named_sizes.size());
    for (const NamedSize& named : named_sizes) known.emplace_back(named.name);
    throw InputError(
        fmt::format("{}unknown film.size \"{}\"; {}, or pixels as in "
                    "\"1920x1080\"",
                    film.at("film.size"), settings.size, suggestion(settings.size, known)));
}

}  // namespace fumon
