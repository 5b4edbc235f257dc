#pragma once

#include <cstddef>
#include <vector>

#include "film/camera/bed_clock.h"
#include "film/camera/stage.h"

namespace fumon {

/// A dune on its way through a shot, at even shares of it.
struct FollowedDune {
    std::vector<glm::dvec3> places;  ///< of its centre at half its height, block lengths; smooth
    double breadth = 0.0;            ///< the side of a square of its area at first, block lengths
};

/// The places of dune number shot.dune of the shot's first bed, of those that separate_dunes()
/// finds there, the one with most sand first. From bed to bed it is the dune nearest to where it
/// was; where dunes merge or part, its place passes over to the new piece's centre little by
/// little. A line through the beds nearby (Cleveland 1979, without its robust weights) smooths the
/// places. Throws InputError, located, where there is no such dune, where it is lost, and where it
/// leaves a bed that does not go on.
FollowedDune followed_dune(const Film& film, std::size_t shot, const FilmStage& stage,
                           const StoredBeds& beds, const BedClock& clock);

/// The places of what the subject of a shot names, on its way through the shot: of "largest dune"
/// those of followed_dune(), and of another landmark those that it has in some beds of the shot,
/// smoothed likewise. One place, that of the shot's last bed, where that dune is not there at
/// first, is lost, or leaves a bed that does not go on.
FollowedDune followed_subject(const Film& film, std::size_t shot, const FilmStage& stage,
                              const StoredBeds& beds, const BedClock& clock);

/// The stream of a bed that drains most, from its head to where it leaves the bed, at even
/// distances along a smoothed way, block lengths. Throws InputError, located, where it is shorter
/// than a tenth of the bed's longer side.
std::vector<glm::dvec3> followed_stream(const Film& film, std::size_t shot, const FilmStage& stage,
                                        const Snapshot& bed);

}  // namespace fumon
