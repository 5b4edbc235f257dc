#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "film/beds/stored_beds.h"
#include "run/terminal/status_line.h"
#include "run/terminal/work_options.h"
#include "scene/scene.h"

namespace fumon {

/// The frames of a run that are drawn from its stored beds, after it and anywhere: files with the
/// bytes that the run would have written.
class StoredFrames {
  public:
    /// Frames go to FOLDER/frames, the movie to FOLDER/movie.mp4. A run that wrote no frames is
    /// drawn as if its scene asked for frames and a movie, unless `settings` speak of them. Beds
    /// outlive it. The look's range, where it is left to the values (look.range = "run"), is that
    /// of all frames together.
    StoredFrames(const StoredBeds& beds, std::filesystem::path folder,
                 const std::vector<std::string>& settings);

    /// How many frames the run has.
    [[nodiscard]] std::int64_t count() const { return static_cast<std::int64_t>(steps_.size()); }
    [[nodiscard]] std::filesystem::path frame(std::int64_t number) const;
    [[nodiscard]] std::filesystem::path movie() const { return folder_ / "movie.mp4"; }

    /// Throws InputError where the bed of one of these frames is not stored, and says what to ask
    /// for.
    void check(const std::vector<std::int64_t>& numbers) const;

    /// Draws those of the frames that are not there yet and that no other program is drawing.
    /// Returns how many were there already and how many it drew; fewer than asked for when
    /// interrupted. Throws Error where drawing or writing fails.
    struct Drawn {
        std::int64_t kept = 0;
        std::int64_t drawn = 0;
        std::int64_t elsewhere = 0;  ///< that another program is drawing
    };
    Drawn draw(const std::vector<std::int64_t>& numbers, const WorkOptions& work,
               StatusLine& status) const;

    /// The frames that are not there, in their order.
    [[nodiscard]] std::vector<std::int64_t> missing() const;

    /// Makes the movie of all frames, with the bytes of the run's. Throws Error where a frame is
    /// missing or is another one.
    void write_movie(StatusLine& status) const;

  private:
    void fix_colours();
    [[nodiscard]] bool is_there(std::int64_t number, const std::string& environment) const;

    const StoredBeds& beds_;
    std::filesystem::path folder_;
    Scene scene_;
    std::string resolved_;
    std::vector<std::int64_t> steps_;     ///< of the frames
    std::vector<std::ptrdiff_t> places_;  ///< of their beds among those stored; −1: none
};

/// Numbers as ranges: "3, 5 to 9".
std::string ranges_text(const std::vector<std::int64_t>& numbers);

}  // namespace fumon
