#pragma once

#include "film/film.h"
#include "keys/keys.h"

namespace fumon {

/// Every key of a film, bound to it.
KeyTable film_keys(Film& film);

/// The keys of films as `fumon describe film` tells them.
std::string describe_film();
/// The same as JSON: a list of what key_json() tells.
std::string describe_film_json();

}  // namespace fumon
