#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "figure/canvas/canvas.h"
#include "film/camera/stage.h"
#include "film/lettering.h"
#include "film/script/film.h"
#include "film/timeline.h"

namespace fumon {

/// What the words of cards and captions may name besides the keys of the run's scene.
struct TitleFacts {
    std::string title;
    std::string remake;  ///< the command that makes the film again
};

/// A caption with its words filled in.
struct ReadyCaption {
    double from = 0.0;  ///< seconds
    double to = 0.0;
    std::string text;
};

/// The captions of a film. Throws InputError, located, for a name that there is not.
std::vector<ReadyCaption> ready_captions(const Film& film, const Scene& scene,
                                         const Snapshot& first, const TitleFacts& facts);

/// Captions as a SubRip file (.srt).
std::string subrip(const std::vector<ReadyCaption>& captions);

/// The cards and captions of a film, drawn over its frames: within a twentieth of the picture's
/// width and height from its edges (title-safe), captions below, above overlays that stand there.
class Titles {
  public:
    /// `taken`: boxes of the overlays. Throws InputError, located.
    Titles(const Film& film, const FilmStage& stage, const Snapshot& first, const TitleFacts& facts,
           const Timeline& timeline, const std::vector<CanvasBox>& taken);

    /// Darkens a frame of the film under the card that stands over it, before overlays are drawn.
    void darken(Image& image, std::int64_t frame) const;
    /// Over a frame of the film.
    void draw(Image& image, std::int64_t frame) const;
    /// Draws a frame of the film's shots without its titles.
    using PictureOf = std::function<Image(std::int64_t frame)>;
    /// A card that stands before or after the shots, `share` of which has passed. What a blurred
    /// one stands on is asked for once.
    [[nodiscard]] Image card(std::size_t card, double share, const PictureOf& picture);
    /// Where captions stand; none: there are none.
    [[nodiscard]] std::optional<CanvasBox> caption_box() const;
    /// One line for the user where no font has a letter; else empty.
    [[nodiscard]] std::string missing_letters() const;

  private:
    struct OverPicture {
        std::size_t number = 0;  ///< of film.cards
        std::int64_t first = 0;  ///< frames
        std::int64_t frames = 0;
    };
    struct Placed {
        ReadyCaption caption;
        Lettering lettering;
    };

    [[nodiscard]] double opacity_of(const Card& card, double seconds) const;
    [[nodiscard]] double opacity_at(const OverPicture& over, std::int64_t frame) const;
    const Image& ground_of(std::size_t card, const PictureOf& picture);

    Film film_;
    int width_;
    int height_;
    double rate_;
    std::int64_t first_;  ///< frame of the shots
    std::int64_t last_;
    std::vector<Lettering> cards_;
    std::map<std::size_t, Image> grounds_;
    std::vector<OverPicture> over_;
    std::vector<Placed> captions_;
    double bottom_ = 0.0;  ///< of captions, pixels from above
};

}  // namespace fumon
