#include "film/titles.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/error.h"
#include "figure/overlays/overlay_text.h"
#include "film/card_backdrop.h"
#include "scene/placeholders.h"

namespace fumon {

namespace {

constexpr double safe_margin_share = 0.05;     // of the picture's width and height
constexpr double title_size_ratio = 2.2;       // of a caption's
constexpr double caption_fade_seconds = 0.25;  // seconds
constexpr std::uint8_t darkness = 16;          // of a card's ground
constexpr double veil_opacity = 0.35;          // of black under a card over the picture

std::string filled(const Film& film, const std::string& key, const std::string& text,
                   const Scene& scene, const Snapshot& first, const TitleFacts& facts) {
    const TimeText times = time_text_of(scene, first);
    try {
        return fill_placeholders(text, [&](const std::string& name) -> std::optional<std::string> {
            if (name == "title") return facts.title;
            if (name == "remake") return facts.remake;
            if (name == "version") return FUMON_VERSION;
            if (name == "step" || name == "time") return std::nullopt;
            return filled_text("{" + name + "}", scene, times, 0, 0.0);
        });
    } catch (const InputError& fault) {
        throw placed(film.at(key), fault);
    }
}

double caption_font(const Film& film, int width, int height) {
    return film.settings.cap_height / cap_height_em * std::min(width, height) / usual_side_pixels;
}

std::vector<LetteredLine> lines_of(const Film& film, std::size_t number, const Scene& scene,
                                   const Snapshot& first, const TitleFacts& facts, double font) {
    const Card& card = film.cards[number];
    const std::string path = fmt::format("card.{}", number);
    std::string title = card.title;
    std::vector<std::string> below = card.lines;
    if (title.empty() && below.empty()) {
        title = "{title}";
        if (card.place == CardPosition::end) below = {"Made with fumon {version}", "{remake}"};
    }
    std::vector<LetteredLine> lines;
    if (!title.empty())
        lines.push_back({filled(film, path + ".title", title, scene, first, facts),
                         title_size_ratio * font, true});
    for (const std::string& line : below)
        lines.push_back({filled(film, path + ".lines", line, scene, first, facts), font, false});
    return lines;
}

/// Seconds as SubRip has them: "00:01:02,345".
std::string subrip_time(double seconds) {
    const auto all = static_cast<std::int64_t>(std::llround(1000.0 * seconds));
    return fmt::format("{:02}:{:02}:{:02},{:03}", all / 3'600'000, all / 60'000 % 60,
                       all / 1000 % 60, all % 1000);
}

void lay_veil(Image& image, double share) {
    for (std::uint8_t& value : image.rgb)
        value = static_cast<std::uint8_t>(std::lround((1.0 - share) * value));
}

}  // namespace

std::vector<ReadyCaption> ready_captions(const Film& film, const Scene& scene,
                                         const Snapshot& first, const TitleFacts& facts) {
    std::vector<ReadyCaption> captions;
    for (std::size_t i = 0; i < film.captions.size(); ++i) {
        const Caption& caption = film.captions[i];
        captions.push_back(
            {caption.from, caption.to,
             filled(film, fmt::format("caption.{}.text", i), caption.text, scene, first, facts)});
    }
    return captions;
}

std::string subrip(const std::vector<ReadyCaption>& captions) {
    std::vector<ReadyCaption> sorted = captions;
    std::ranges::stable_sort(sorted, {}, &ReadyCaption::from);
    std::string text;
    std::size_t number = 0;
    for (const ReadyCaption& caption : sorted)
        text += fmt::format("{}\n{} --> {}\n{}\n\n", ++number, subrip_time(caption.from),
                            subrip_time(caption.to), caption.text);
    return text;
}

Titles::Titles(const Film& film, const FilmStage& stage, const Snapshot& first,
               const TitleFacts& facts, const Timeline& timeline,
               const std::vector<CanvasBox>& taken)
    : film_(film),
      width_(static_cast<int>(stage.scene.view.image.width)),
      height_(static_cast<int>(stage.scene.view.image.height)),
      rate_(timeline.rate()),
      first_(timeline.shots_begin()),
      last_(timeline.shots_end() - 1) {
    const double font = caption_font(film, width_, height_);
    const double widest = (1.0 - 2.0 * safe_margin_share) * width_;
    for (std::size_t i = 0; i < film.cards.size(); ++i) {
        cards_.emplace_back(lines_of(film, i, stage.scene, first, facts, font), widest);
        const Card& card = film.cards[i];
        if (cards_.back().height() > (1.0 - 2.0 * safe_margin_share) * height_) {
            const std::string key = fmt::format("card.{}.lines", i);
            throw InputError(
                fmt::format("{}card.{} has more lines than fit into the picture", film.at(key), i));
        }
        if (card.ground != CardBackground::picture) continue;
        const std::int64_t shots = timeline.shots_end() - timeline.shots_begin();
        const std::int64_t frames =
            std::clamp<std::int64_t>(std::lround(card.seconds * rate_), 1, shots);
        over_.push_back({i,
                         card.place == CardPosition::start ? timeline.shots_begin()
                                                           : timeline.shots_end() - frames,
                         frames});
    }
    bottom_ = (1.0 - safe_margin_share) * height_;
    double highest = 0.0;
    double broadest = 0.0;
    for (ReadyCaption& caption : ready_captions(film, stage.scene, first, facts)) {
        Lettering lettering({{caption.text, font, false}}, widest);
        highest = std::max(highest, lettering.height());
        broadest = std::max(broadest, lettering.width());
        captions_.push_back({std::move(caption), std::move(lettering)});
    }
    for (bool moved = !captions_.empty(); moved;) {
        moved = false;
        const CanvasBox room =
            grown({0.5 * (width_ - broadest), bottom_ - highest, broadest, highest}, 0.5 * font);
        for (const CanvasBox& box : taken) {
            if (box.y < 0.5 * height_ || !overlap(box, room)) continue;
            bottom_ = box.y - 0.6 * font;
            moved = true;
        }
    }
}

double Titles::opacity_of(const Card& card, double seconds) const {
    if (card.fade <= 0.0) return 1.0;
    const double length = std::round(card.seconds * rate_) / rate_;
    const double fade = std::min(card.fade, 0.5 * length);
    const bool stays = card.place == CardPosition::end;  // the film ends with it
    const double coming = seconds / fade;
    const double going = stays ? 1.0 : (length - seconds) / fade;
    return std::clamp(std::min(coming, going), 0.0, 1.0);
}

double Titles::opacity_at(const OverPicture& over, std::int64_t frame) const {
    const std::int64_t within = frame - over.first;
    if (within < 0 || within >= over.frames) return 0.0;
    // None of a card that comes is on the first frame, which slides show until a film plays.
    return opacity_of(film_.cards[over.number], static_cast<double>(within) / rate_);
}

void Titles::darken(Image& image, std::int64_t frame) const {
    for (const OverPicture& over : over_) {
        const double opacity = opacity_at(over, frame);
        if (opacity > 0.0) lay_veil(image, veil_opacity * opacity);
    }
}

void Titles::draw(Image& image, std::int64_t frame) const {
    const double second = static_cast<double>(frame) / rate_;
    for (const Placed& placed : captions_) {
        const double fade =
            std::min(caption_fade_seconds, 0.5 * (placed.caption.to - placed.caption.from));
        const double opacity =
            std::min(second - placed.caption.from, placed.caption.to - second) / fade;
        if (opacity <= 0.0) continue;
        placed.lettering.draw(image, 0.5 * width_, bottom_ - placed.lettering.height(),
                              std::min(1.0, opacity));
    }
    for (const OverPicture& over : over_) {
        const double opacity = opacity_at(over, frame);
        if (opacity <= 0.0) continue;
        const Lettering& lettering = cards_[over.number];
        lettering.draw(image, 0.5 * width_, 0.5 * (height_ - lettering.height()), opacity);
    }
}

const Image& Titles::ground_of(std::size_t card, const PictureOf& picture) {
    const auto [found, added] = grounds_.try_emplace(card, width_, height_);
    Image& ground = found->second;
    if (!added) return ground;
    const Card& settings = film_.cards[card];
    if (settings.ground == CardBackground::blurred) {
        ground = card_backdrop(picture(settings.place == CardPosition::start ? first_ : last_));
    } else {
        std::ranges::fill(ground.rgb, darkness);
    }
    return ground;
}

Image Titles::card(std::size_t card, double share, const PictureOf& picture) {
    Image image = ground_of(card, picture);
    const Card& settings = film_.cards[card];
    const Lettering& lettering = cards_[card];
    lettering.draw(image, 0.5 * width_, 0.5 * (height_ - lettering.height()),
                   opacity_of(settings, share * settings.seconds));
    return image;
}

std::optional<CanvasBox> Titles::caption_box() const {
    if (captions_.empty()) return std::nullopt;
    double height = 0.0;
    double width = 0.0;
    for (const Placed& placed : captions_) {
        height = std::max(height, placed.lettering.height());
        width = std::max(width, placed.lettering.width());
    }
    return CanvasBox{0.5 * (width_ - width), bottom_ - height, width, height};
}

std::string Titles::missing_letters() const {
    for (const Lettering& lettering : cards_)
        if (!lettering.missing_letters().empty()) return lettering.missing_letters();
    for (const Placed& placed : captions_)
        if (!placed.lettering.missing_letters().empty()) return placed.lettering.missing_letters();
    return "";
}

}  // namespace fumon
