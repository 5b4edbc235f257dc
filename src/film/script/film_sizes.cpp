#include "film/script/film_sizes.h"

#include <fmt/format.h>

#include <array>
#include <string_view>
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
    std::vector<std::string> known;
    known.reserve(named_sizes.size());
    for (const NamedSize& named : named_sizes) known.emplace_back(named.name);
    throw InputError(fmt::format("{}unknown film.size \"{}\"; {}", film.at("film.size"),
                                 settings.size, suggestion(settings.size, known)));
}

}  // namespace fumon
