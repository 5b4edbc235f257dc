#pragma once

#include <string>
#include <vector>

#include "film/script/film.h"
#include "keys/describe_key.h"
#include "keys/keys.h"

namespace fumon {

/// Every key of a film, bound to it.
KeyTable film_keys(Film& film);

/// The keys of films as `fumon describe film` lists them, or those of a part: a section ("shot") or
/// a key ("shot.move"); empty where it is no part of a film.
std::string describe_film(const std::string& part = {});
/// The same as JSON: a list of the objects of key_json().
std::string describe_film_json(const std::string& part = {});
/// The keys of films with the words that they take.
std::vector<KeyWords> film_key_words();

}  // namespace fumon
