#include "film/rule/film_rule.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "base/error.h"
#include "base/find_named.h"
#include "base/nearest_name.h"
#include "film/camera/camera_distance.h"
#include "film/camera/moves.h"
#include "film/film_read.h"
#include "film/rule/run_look.h"
#include "film/rule/written_shot.h"

namespace fumon {

namespace {

struct StyleFacts {
    std::string_view name;
    FilmStyle style;
    double seconds;
    std::string_view size;
    double cap_height;  ///< of captions, pixels at 1080p
    double nearer;      ///< distances over the horizon, of a talk's
    double farther;     ///< those from what must fit across, likewise
};

constexpr std::array<StyleFacts, 4> styles{
    {{"talk", FilmStyle::talk, 16.0, "1080p", 28.0, 1.0, 1.0},
     {"social", FilmStyle::social, 12.0, "vertical", 44.0, 1.25, 1.8},
     {"loop", FilmStyle::loop, 12.0, "1080p", 28.0, 1.0, 1.0},
     {"survey", FilmStyle::survey, 18.0, "1080p", 28.0, 1.0, 1.0}}};

constexpr double enough_ground = 2.0 / 3.0;  // of a picture over a table

const StyleFacts& facts_of(FilmStyle style) {
    return *std::ranges::find(styles, style, &StyleFacts::style);
}

class RuledFilm {
  public:
    RuledFilm(const FilmRuns& runs, const FilmRule& rule, std::string run)
        : runs_(runs),
          style_(facts_of(rule.style)),
          look_(look_at_run(runs.first())),
          run_(std::move(run)),
          colours_(rule.colours),
          seconds_(rule.seconds != 0.0 ? rule.seconds : style_.seconds) {
        if (!(seconds_ >= shortest_film_by_rule)) {
            throw InputError(fmt::format("--seconds {}: a film by rule takes {} s at least",
                                         seconds_, shortest_film_by_rule));
        }
    }

    [[nodiscard]] std::string text() {
        if (style_.style == FilmStyle::loop) {
            add_loop();
        } else {
            add_shots();
        }
        std::string all = head();
        for (const WrittenShot& shot : shots_) all += shot.text() + "\n";
        return all + titles() + overlays();
    }

  private:
    /// The colours that were asked for.
    [[nodiscard]] std::string colour_settings() const {
        std::string text;
        for (const Override& setting : colours_)
            text += fmt::format("{} = {}\n", setting.path.substr(setting.path.find('.') + 1),
                                setting.value);
        return text;
    }

    [[nodiscard]] std::string settings() const {
        std::string text =
            fmt::format("[film]\nsize = \"{}\"\nrate = 30\nplates = \"none\"\n", style_.size);
        if (style_.cap_height != 28.0)
            text += fmt::format("cap_height = {}        # larger letters, for small screens\n",
                                style_.cap_height);
        std::string look;
        if (look_.widened)
            look +=
                "ground = \"endless\"      # sand to the horizon; without this line "
                "the block on its table\n";
        if (look_.land) look += land_settings();
        look += colour_settings();
        if (!look.empty()) text += "\n[look]\n" + look;
        if (look_.land && look_.showery)
            text += "\n[air]\nclouds = \"cumulus\"\ncloud_cover = 0.6\n";
        return text;
    }

    /// Land around a survey, and what covers it.
    [[nodiscard]] std::string land_settings() const {
        const bool plain = runs_.first().scene().view.look.cover == LandCover::bare;
        std::string text =
            "ground = \"endless\"      # invented land around the bed; without this "
            "line the block on its table\n";
        const bool is_sand = look_.largest == "highest";
        if (plain && !is_sand)
            text += "cover = \"auto\"          # grass, soil and rock by rule, not data\n";
        text += "survey_edge = \"line\"    # where the data end\ncontrast = 1.1\n";
        return text;
    }

    [[nodiscard]] std::string head() const {
        std::string text = fmt::format(
            "# A film by rule, {} s, of the run {}. Change what you like, then\n"
            "#\n"
            "#   fumon film {} FILE.toml -o film.mp4\n"
            "#\n"
            "# `fumon describe shot` lists what a shot takes.\n",
            written_number(seconds_, 1), run_, run_);
        return text + settings() + "\n";
    }

    /// A shot in its place, with light across the relief.
    [[nodiscard]] WrittenShot begun(const std::string& comment, double share,
                                    const std::string& from, const std::string& to) const {
        WrittenShot shot{comment};
        const bool later = !shots_.empty();
        shot.set("seconds", share * whole_seconds(), 2);
        shot.set("from", from);
        shot.set("to", to);
        if (from != to) shot.set("pace", quoted_text(pace()));
        if (!look_.own_sun) {
            shot.set("sun_azimuth", look_.sun_azimuth);
            shot.set("sun_elevation", look_.sun_elevation);
        }
        if (later) {
            shot.set("transition", "\"cross-fade\"");
            shot.set("transition_seconds", fade(), 2);
        }
        return shot;
    }

    [[nodiscard]] std::string pace() const { return look_.shaped ? "change" : "linear"; }

    [[nodiscard]] double fade() const { return std::min(1.0, 0.05 * seconds_); }
    /// Of all shots: those of the film, and what cross-fades take of them.
    [[nodiscard]] double whole_seconds() const {
        return seconds_ + (style_.style == FilmStyle::loop ? 0.0 : 3.0 * fade());
    }

    void around(WrittenShot& shot, double azimuth, double elevation, double turn) const {
        shot.set("move", "\"orbit\"");
        shot.set("azimuth", azimuth);
        shot.set("elevation", elevation);
        shot.set("turn", turn);
    }

    /// On a table as the table allows; over the horizon so far that some waves of the bed, or a
    /// pile so many of its breadths away, are told apart.
    void stand(WrittenShot& shot, double waves, double breadths) const {
        if (!look_.endless || look_.land) {
            const bool whole = look_.section || look_.land || look_.flood;
            shot.set("distance", whole ? "\"fit\"" : "\"fill\"");
            return;
        }
        if (landform() == Landform::pile) {
            shot.set("subject", quoted_text(look_.largest));
            shot.set("distance", style_.farther * breadths * look_.breadth, 2);
            return;
        }
        constexpr double lengths_per_wave = 1.17;  // of a lens of 50 mm, across a wide picture
        shot.set(
            "distance",
            style_.nearer * std::clamp(lengths_per_wave * waves * look_.wavelength, 0.08, 0.75), 2);
    }

    [[nodiscard]] Landform landform() const { return runs_.first().first().landform; }
    [[nodiscard]] bool is_land() const {
        return landform() == Landform::terrain || landform() == Landform::water;
    }

    /// What a shot's subject, at any of three moments, leaves to the table; and whether it can be
    /// drawn at all.
    [[nodiscard]] std::optional<double> ground_of(const WrittenShot& shot) const {
        try {
            const Film film = parse_film(settings() + shot.text(), "by rule");
            const FilmStage stage = make_stage(film, runs_.first(), film_size(film));
            const StagedShot staged(film, 0, stage, runs_);
            double least = 1.0;
            for (const double share : {0.0, 0.5, 1.0}) {
                const auto bed = runs_.first().heights(staged.bed_at(share));
                least = std::min(least, ground_share(stage, *bed, staged.pose_at(share)));
            }
            return look_.endless ? 1.0 : least;
        } catch (const InputError&) {
            return std::nullopt;
        }
    }

    /// Steeper and nearer until the bed fills the picture.
    [[nodiscard]] WrittenShot composed(const WrittenShot& shot, double elevation) const {
        if (look_.section) return shot;
        WrittenShot best = shot;
        double most = -1.0;
        for (const double steeper : {0.0, 8.0, 16.0, 26.0}) {
            WrittenShot tried = shot;
            tried.set("elevation", std::min(80.0, elevation + steeper));
            const auto share = ground_of(tried);
            if (!share || *share <= most) continue;
            best = tried;
            most = *share;
            if (most >= enough_ground) break;
        }
        return best;
    }

    void add_shots() {
        const bool moves = look_.changes;
        const std::string early = moves ? fmt::format("\"{} %\"", look_.early) : "\"end\"";
        const std::string late = moves ? fmt::format("\"{} %\"", look_.late) : "\"end\"";
        const std::string start = !moves            ? "\"end\""
                                  : look_.begin > 0 ? fmt::format("\"{} %\"", look_.begin)
                                                    : "\"start\"";
        const double azimuth = look_.camera_azimuth;
        const bool sands = look_.endless && !look_.land;
        const double high = look_.section ? 18.0 : sands ? 24.0 : 34.0;
        const double low = look_.section ? 14.0 : sands ? 11.0 : look_.land ? 24.0 : 30.0;

        WrittenShot whole =
            begun(moves ? "the whole, as it begins" : "the whole", 0.26, start, early);
        const bool from_map =
            style_.style == FilmStyle::survey || (!sands && is_land() && !look_.flood);
        if (from_map) {
            whole.set("move", "\"map-to-perspective\"");
            whole.set("azimuth", azimuth);
            whole.set("elevation", high);
        } else {
            around(whole, azimuth - 12.0, high, 16.0);
        }
        stand(whole, 16.0, 2.4);
        add_whole(whole, high);

        WrittenShot growth = begun(!moves               ? "and from its side"
                                   : pace() == "change" ? "it grows: as much change in each frame"
                                                        : "what happens to it",
                                   0.3, early, !is_land() ? late : "\"end\"");
        around(growth, azimuth - 4.0, low, 24.0);
        stand(growth, 11.0, 1.9);
        WrittenShot grown = composed(growth, low);
        if (look_.flood) {
            growth.comment = "with the front";
            growth.set("subject", "\"flood front\"");
            growth.set("follow", "true");
            growth.set("distance", 0.55, 2);
            growth.set("turn", 10.0);
            grown = composed(growth, 24.0);
        } else if (is_land() && !sands) {
            growth.set("subject", quoted_text(look_.largest));
            growth.set("distance", 0.62, 2);
            const WrittenShot nearer = composed(growth, low);
            if (ground_of(nearer).value_or(0.0) >= enough_ground) grown = nearer;
        }
        shots_.push_back(grown);

        shots_.push_back(look_.flood && moves ? front_again(start, early)
                                              : close_shot(moves ? late : "\"end\""));

        WrittenShot last =
            begun("time stands still, the camera goes round", 0.24, "\"end\"", "\"end\"");
        around(last, azimuth - (look_.section ? 20.0 : 35.0), high - 2.0,
               look_.section ? 40.0 : 75.0);
        stand(last, 13.0, 1.8);
        last.set("hold", std::min(0.5, 0.03 * seconds_), 2);
        add_whole(last, high - 2.0);
    }

    /// A flood's basin stays whole, even where it is long and leaves much of the table.
    void add_whole(const WrittenShot& shot, double elevation) {
        shots_.push_back(look_.flood ? shot : composed(shot, elevation));
    }

    /// A flood's first third once more, low beside its front.
    [[nodiscard]] WrittenShot front_again(const std::string& start,
                                          const std::string& early) const {
        constexpr double low = 16.0;  // degrees
        WrittenShot again = begun("its front again, from near", 0.2, start, early);
        around(again, look_.camera_azimuth - 30.0, low, 25.0);
        again.set("subject", "\"flood front\"");
        again.set("follow", "true");
        again.set("distance", 0.34, 2);
        return composed(again, low);
    }

    /// What is largest: followed where it wanders and can be, else as it is at the end.
    [[nodiscard]] WrittenShot close_shot(const std::string& from) const {
        const bool sands = look_.endless && !look_.land;
        const double low = sands ? 14.0 : look_.land ? 22.0 : 30.0;
        if (look_.section) {
            WrittenShot near = begun("from near", 0.2, "\"end\"", "\"end\"");
            around(near, look_.camera_azimuth - 15.0, 12.0, 20.0);
            near.set("distance", 1.0, 1);
            return near;
        }
        const auto shot_from = [&](const std::string& begin) {
            WrittenShot shot =
                begun(fmt::format("close to the {}", look_.largest), 0.2, begin, "\"end\"");
            around(shot, look_.camera_azimuth - 25.0, low, 40.0);
            stand(shot, 3.5, 1.7);
            shot.set("subject", quoted_text(look_.largest));
            const bool crests = sands && look_.largest == "highest";
            if (!crests) shot.set("distance", "\"near\"");
            return shot;
        };
        if (landform() == Landform::water && look_.largest == "deepest channel") {
            WrittenShot stream =
                begun("down the stream that drains most", 0.2, "\"end\"", "\"end\"");
            stream.set("move", "\"follow-stream\"");
            stream.set("distance", 0.09, 2);
            stream.set("focal_length", 26.0);
            constexpr double enough = 0.6;
            if (const auto share = ground_of(stream); share && *share > enough) return stream;
        }
        WrittenShot follows = shot_from(from);
        follows.set("follow", "true");
        if (look_.largest == "largest dune" && from != "\"end\"" && ground_of(follows))
            return composed(follows, low);
        WrittenShot at_end = composed(shot_from("\"end\""), low);
        if (ground_of(at_end).value_or(0.0) >= enough_ground) return at_end;
        WrittenShot whole = shot_from("\"end\"");  // it takes most of its block
        whole.comment = "from near";
        std::erase_if(whole.keys, [](const auto& key) { return key.first == "subject"; });
        whole.set("distance", "\"fill\"");
        return composed(whole, low);
    }

    void add_loop() {
        WrittenShot round =
            begun("once round: the end is the beginning", 1.0, "\"end\"", "\"end\"");
        const double frames = std::max(2.0, std::round(30.0 * seconds_));
        const double elevation = look_.land ? 28.0 : look_.endless ? 22.0 : 34.0;
        around(round, look_.camera_azimuth, elevation, 0.0);
        round.set("turn", 360.0 * (frames - 1.0) / frames, 3);
        round.set("speed", "\"constant\"");
        stand(round, 13.0, 1.8);
        add_whole(round, elevation);
    }

    [[nodiscard]] std::string titles() const {
        if (look_.title.empty() || style_.style == FilmStyle::loop) return {};
        std::string text = fmt::format(
            "[[card]]                  # over the first shot\nplace = "
            "\"start\"\ntitle = {}\nseconds = {}\n",
            quoted_text(without_placeholders(look_.title)),
            written_number(std::min(3.5, 0.22 * seconds_), 2));
        text += "lines = []\n\n";
        return text;
    }

    [[nodiscard]] std::string overlays() const {
        if (style_.style == FilmStyle::loop) return {};
        const Snapshot& first = runs_.first().first();
        std::string text;
        if (look_.changes) {
            text += fmt::format(
                "[[overlay]]\nkind = \"time\"\ncorner = \"upper-left\"\ntext = "
                "\"{}\"\n\n",
                first.date                   ? "{date}"
                : first.time_unit == "steps" ? "step {step}"
                                             : "{time}");
        }
        if (first.scale.in_metres && !look_.section)
            text +=
                "[[overlay]]               # true at the depth of what the camera looks at\n"
                "kind = \"scale-bar\"\ncorner = \"lower-left\"\n\n";
        if (!first.winds.empty() && landform() == Landform::bed)
            text += "[[overlay]]\nkind = \"arrow\"\ncorner = \"upper-right\"\n\n";
        const bool coloured = runs_.first().scene().view.look.colour_by != Colouring::natural;
        const bool asked = std::ranges::find(colours_, "look.palette", &Override::path) !=
                           colours_.end();  // natural colours have none, and mean no quantity
        if (asked || (coloured && colours_.empty()))
            text += fmt::format("[[overlay]]\nkind = \"colour-bar\"\ncorner = \"{}-right\"\n\n",
                                style_.style == FilmStyle::survey ? "upper" : "lower");
        if (style_.style == FilmStyle::survey)
            text += "[[overlay]]\nkind = \"inset-map\"\ncorner = \"lower-right\"\nsize = 0.24\n\n";
        return text;
    }

    const FilmRuns& runs_;
    const StyleFacts& style_;
    RunLook look_;
    std::string run_;
    std::vector<Override> colours_;
    double seconds_;
    std::vector<WrittenShot> shots_;
};

}  // namespace

FilmStyle film_style(const std::string& name) {
    if (const StyleFacts* found = find_named(styles, name)) return found->style;
    std::vector<std::string> known;
    known.reserve(styles.size());
    for (const StyleFacts& one : styles) known.emplace_back(one.name);
    throw InputError(
        fmt::format("--style: unknown style \"{}\"; {}", name, suggestion(name, known)));
}

std::string film_style_names() {
    std::string names;
    for (const StyleFacts& one : styles)
        names += (names.empty() ? "" : ", ") + std::string(one.name);
    return names;
}

std::string film_by_rule(const FilmRuns& runs, const FilmRule& rule, const std::string& run) {
    std::string text = RuledFilm(runs, rule, run).text();
    while (text.ends_with("\n\n")) text.pop_back();
    return text;
}

}  // namespace fumon
