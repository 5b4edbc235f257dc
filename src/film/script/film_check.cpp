#include "film/script/film_check.h"

#include <fmt/format.h>

#include "base/error.h"
#include "base/nearest_name.h"
#include "film/script/film_sizes.h"
#include "picture/movie_format.h"

namespace fumon {

namespace {

void check_settings(const Film& film) {
    const FilmSettings& settings = film.settings;
    film_size(film);
    if (settings.supersampling == 3)
        throw InputError(film.at("film.supersampling") +
                         "film.supersampling is 1, 2 or 4 (0: the scene's), not 3");
    if (settings.format == "sheet" || settings.format == "poster") return;
    if (find_movie_format(settings.format) != nullptr) return;
    std::vector<std::string> known{"sheet", "poster"};
    for (const MovieFormat& format : movie_formats()) known.emplace_back(format.name);
    throw InputError(fmt::format("{}unknown film.format \"{}\"; {}", film.at("film.format"),
                                 settings.format, suggestion(settings.format, known)));
}

void check_place(const Film& film, const std::string& key, const std::vector<double>& place) {
    if (place.empty() || place.size() == 3) return;
    throw InputError(fmt::format("{}{} has {} numbers; it takes three: east, north, above the bed",
                                 film.at(key), key, place.size()));
}

void check_keys(const Film& film, std::size_t number, Faults& faults) {
    const Shot& shot = film.shots[number];
    const std::string path = fmt::format("shot.{}", number);
    faults.attempt([&] {
        if (shot.move == Move::keys && shot.keys.size() < 2) {
            throw InputError(fmt::format("{}{}.move = \"keys\" needs at least two [[shot.key]]",
                                         film.at(path + ".move"), path));
        }
        const bool takes_keys = shot.move == Move::keys || shot.move == Move::still ||
                                shot.move == Move::morning_to_evening;
        if (!shot.keys.empty() && !takes_keys) {
            throw InputError(
                fmt::format("{}{} has [[shot.key]] and a predefined move; write move = \"keys\"",
                            film.at(path + ".move"), path));
        }
        if (shot.move != Move::keys && shot.keys.size() > 1) {
            throw InputError(fmt::format(
                "{}{} has a still camera but {} [[shot.key]]; write move = \"keys\", or keep one",
                film.at(path + ".move"), path, shot.keys.size()));
        }
    });
    for (std::size_t k = 0; k < shot.keys.size(); ++k) {
        const std::string key = fmt::format("{}.key.{}", path, k);
        faults.attempt([&] {
            const ShotKey& one = shot.keys[k];
            const bool relative =
                !one.azimuth.is_word() || !one.elevation.is_word() || one.distance.word != "shot";
            if (one.at.empty() && !relative) {
                throw InputError(fmt::format(
                    "{}{}.at is missing: the camera's position; or .azimuth, .elevation and "
                    ".distance from what it looks at",
                    film.at(key + "."), key));
            }
            if (!one.at.empty() && relative) {
                throw InputError(fmt::format(
                    "{}{} has .at and .azimuth, .elevation or .distance; take one or the others",
                    film.at(key + ".at"), key));
            }
            check_place(film, key + ".at", shot.keys[k].at);
        });
        faults.attempt([&] { check_place(film, key + ".look_at", shot.keys[k].look_at.at); });
    }
}

void check_times(const Film& film, std::size_t number) {
    const Shot& shot = film.shots[number];
    const std::string path = fmt::format("shot.{}", number);
    if (shot.hold >= shot.seconds && shot.hold > 0.0) {
        throw InputError(fmt::format("{}{}.hold = {} leaves nothing of its {} seconds",
                                     film.at(path + ".hold"), path, shot.hold, shot.seconds));
    }
    if (shot.transition == Transition::cut) return;
    const double before = number > 0 ? film.shots[number - 1].seconds : shot.seconds;
    if (2.0 * shot.transition_seconds > std::min(before, shot.seconds)) {
        throw InputError(
            fmt::format("{}{}.transition_seconds = {} is more than half of the shorter shot ({} s)",
                        film.at(path + ".transition_seconds"), path, shot.transition_seconds,
                        std::min(before, shot.seconds)));
    }
}

void check_follow(const Film& film, std::size_t number) {
    const Shot& shot = film.shots[number];
    if (!shot.follow) return;
    const std::string path = fmt::format("shot.{}.follow", number);
    if (shot.subject.word.empty() || shot.subject.word == "middle") {
        throw InputError(fmt::format(
            "{}{} needs a .subject that may move, such as \"largest dune\" or \"highest\"",
            film.at(path), path));
    }
    if (shot.move == Move::still || shot.move == Move::orbit || shot.move == Move::push_in) return;
    throw InputError(fmt::format("{}{} is for move = \"still\", \"orbit\" and \"push-in\"",
                                 film.at(path), path));
}

}  // namespace

void check_film(const Film& film, Faults& faults) {
    faults.attempt([&] { check_settings(film); });
    faults.attempt([&] {
        if (film.shots.empty() && film.excerpts.empty())
            throw InputError(film.source + ":1:1: a film needs at least one [[shot]]");
        if (!film.shots.empty() && !film.excerpts.empty()) {
            throw InputError(film.at("excerpt.0.") +
                             "a film has [[shot]] or [[excerpt]], not both; cut the shots from a "
                             "film of their own");
        }
        if (!film.excerpts.empty() && !film.overlays.empty()) {
            throw InputError(film.at("overlay.0.kind") +
                             "[[overlay]] belongs to the films that [[excerpt]] cuts from");
        }
    });
    for (std::size_t i = 0; i < film.shots.size(); ++i) {
        check_keys(film, i, faults);
        const std::string subject = fmt::format("shot.{}.subject", i);
        faults.attempt([&] { check_place(film, subject, film.shots[i].subject.at); });
        faults.attempt([&] { check_times(film, i); });
        faults.attempt([&] { check_follow(film, i); });
    }
    for (std::size_t i = 0; i < film.captions.size(); ++i) {
        faults.attempt([&] {
            const Caption& caption = film.captions[i];
            if (caption.to > caption.from) return;
            const std::string key = fmt::format("caption.{}.to", i);
            throw InputError(fmt::format("{}{} = {} is not after its from = {}", film.at(key), key,
                                         caption.to, caption.from));
        });
    }
}

void check_excerpts(const Film& film, Faults& faults) {
    for (std::size_t i = 0; i < film.excerpts.size(); ++i) {
        faults.attempt([&] {
            const Excerpt& excerpt = film.excerpts[i];
            const std::string path = fmt::format("excerpt.{}", i);
            double length = 0.0;
            for (std::size_t k = 0; k < excerpt.read->shots.size(); ++k) {
                const Shot& shot = excerpt.read->shots[k];
                const bool fades = k > 0 && shot.transition == Transition::cross_fade;
                length += shot.seconds - (fades ? shot.transition_seconds : 0.0);
            }
            const double to = excerpt.to.is_word() ? length : excerpt.to.value;
            if (excerpt.from >= to || to > length + 1e-9) {
                throw InputError(fmt::format(
                    "{}{}: from {} to {} s is not within that film, whose shots last {} s",
                    film.at(path + (excerpt.to.is_word() ? ".from" : ".to")), path, excerpt.from,
                    to, length));
            }
            if (excerpt.transition == Transition::cut) return;
            if (2.0 * excerpt.transition_seconds > to - excerpt.from) {
                throw InputError(fmt::format(
                    "{}{}.transition_seconds = {} is more than half of the excerpt ({} s)",
                    film.at(path + ".transition_seconds"), path, excerpt.transition_seconds,
                    to - excerpt.from));
            }
        });
    }
}

}  // namespace fumon
