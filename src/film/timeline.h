#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "film/script/film.h"

namespace fumon {

/// A shot, a piece of another film, or a card that is not over one, on the film's way.
struct FilmPart {
    enum class Kind { shot, excerpt, card };
    Kind kind = Kind::shot;
    std::size_t number = 0;  ///< of film.shots, film.excerpts or film.cards
    std::int64_t first = 0;  ///< frame of the film
    std::int64_t frames = 0;
    std::int64_t overlap = 0;  ///< of these, how many the part before it still shows
    std::int64_t begin = 0;    ///< of an excerpt, the first frame of its film
    std::int64_t held = 0;     ///< the last ones of a shot, which are like the one before them
};

/// What a frame of the film shows: a part, at a share of it.
struct FramePart {
    const FilmPart* part = nullptr;
    double share = 0.0;      ///< 0 … 1
    double weight = 1.0;     ///< in a cross-fade
    std::int64_t frame = 0;  ///< of the film
};

/// Which frame shows what. Lengths in seconds become whole numbers of frames.
class Timeline {
  public:
    explicit Timeline(const Film& film);

    [[nodiscard]] std::int64_t frames() const { return frames_; }
    [[nodiscard]] const std::vector<FilmPart>& parts() const { return parts_; }
    /// One part, or the two of a cross-fade, the one that goes first.
    [[nodiscard]] std::vector<FramePart> at(std::int64_t frame) const;
    /// What a frame between shots_begin() and shots_end() shows besides a card: the last where
    /// several are seen.
    [[nodiscard]] FramePart shot_at(std::int64_t frame) const;
    /// The first and the frame after the last one of the shots, without cards before and
    /// after.
    [[nodiscard]] std::int64_t shots_begin() const { return shots_begin_; }
    [[nodiscard]] std::int64_t shots_end() const { return shots_end_; }
    [[nodiscard]] double rate() const { return rate_; }

  private:
    void add(FilmPart part, double seconds, double overlap);

    std::vector<FilmPart> parts_;
    double rate_;
    std::int64_t frames_ = 0;
    std::int64_t shots_begin_ = 0;
    std::int64_t shots_end_ = 0;
};

}  // namespace fumon
