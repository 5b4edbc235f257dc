#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "keys/override.h"
#include "keys/word_or_real.h"
#include "scene/scene.h"

namespace fumon {

/// Most runs that a film of excerpts shows one after the other.
inline constexpr std::int64_t most_joined_runs = 24;

/// What the from and to of a shot count.
enum class FilmClock { step, time };
/// How the time of the run passes during a shot.
enum class Pace { linear, logarithmic, eased, change };
/// How the camera passes along its path.
enum class CameraSpeed { constant, eased };
/// Ready camera moves.
enum class Move {
    still,
    keys,
    orbit,
    push_in,
    crane,
    fly_over,
    along_crest,
    map_to_perspective,
    morning_to_evening,
    follow_dune,
    follow_stream
};
enum class Transition { cut, cross_fade };
enum class CardPosition { start, end };
enum class CardBackground { picture, dark, blurred };
enum class Plates { translucent, none };

/// What a film shows of the time between two stored beds.
enum class RecordsBetween { held, blend };

/// What stands behind the bed.
enum class FilmBackground { scene, transparent };

/// How several runs stand in one picture.
enum class PanesShow { grid, wipe, difference };

/// Runs side by side.
struct PaneSettings {
    PanesShow show = PanesShow::grid;
    std::int64_t columns = 0;                   ///< 0: by the picture's shape
    std::string label;                          ///< empty: what differs between the runs
    bool scale = true;                          ///< what varies is drawn beside the label
    std::vector<double> wipe_places{0.1, 0.9};  ///< shares of the width, over each shot
};

/// The whole film.
struct FilmSettings {
    std::string title;               ///< empty: the scene's
    std::string size = "1080p";      ///< by name
    std::int64_t width = 0;          ///< pixels; 0: by name
    std::int64_t height = 0;         ///< likewise
    double rate = 30.0;              ///< frames per second
    std::string format = "h264";     ///< name of a movie format
    std::int64_t quality = 18;       ///< constant rate factor
    std::int64_t supersampling = 0;  ///< 0: the scene's
    double cap_height = 28.0;        ///< of captions, pixels where the shorter side has 1080
    Plates plates = Plates::translucent;
    FilmBackground background = FilmBackground::scene;
    RecordsBetween between = RecordsBetween::held;
    double poster_second = -1.0;  ///< below 0: the middle
    bool draft = false;           ///< coarser ground, encoded quickly
    double frames_for_one = 1.0;  ///< of the film, for each of a draft's
};

/// What a camera looks at.
struct ViewTarget {
    std::string word;        ///< what is there ("highest"); empty: `at` counts
    std::vector<double> at;  ///< as camera.look_at; empty: none is named
    [[nodiscard]] bool is_named() const { return !word.empty() || !at.empty(); }
};

/// A place of the camera on its way.
struct ShotKey {
    std::vector<double> at;  ///< as camera.at; empty: as azimuth, elevation and distance say
    ViewTarget look_at;      ///< none: the shot's subject
    WordOrReal azimuth{"shot", 0.0};
    WordOrReal elevation{"shot", 0.0};
    WordOrReal distance{"shot", 0.0};
    WordOrReal focal_length{"shot", 0.0};
    WordOrReal sun_azimuth{"shot", 0.0};
    WordOrReal sun_elevation{"shot", 0.0};
    WordOrReal exposure{"shot", 0.0};
};

struct Shot {
    double seconds = 5.0;
    double hold = 0.0;  ///< seconds at its end in which all stands still
    WordOrReal from{"start", 0.0};
    WordOrReal to{"end", 0.0};
    FilmClock clock = FilmClock::step;
    Pace pace = Pace::linear;
    Move move = Move::still;
    CameraSpeed speed = CameraSpeed::eased;
    WordOrReal azimuth{"scene", 0.0};       ///< degrees, where the camera stands
    WordOrReal elevation{"scene", 0.0};     ///< degrees
    WordOrReal distance{"fit", 0.0};        ///< block lengths
    WordOrReal focal_length{"scene", 0.0};  ///< mm
    WordOrReal sun_azimuth{"scene", 0.0};
    WordOrReal sun_elevation{"scene", 0.0};
    WordOrReal exposure{"scene", 0.0};        ///< stops
    ViewTarget subject;                       ///< none: the bed's middle
    bool follow = false;                      ///< whether the camera goes with the subject
    double turn = 360.0;                      ///< degrees of an orbit
    std::int64_t dune = 1;                    ///< that is followed: 1 is the largest
    WordOrReal clearance{"auto", 0.0};        ///< least height over the ground, m or sites
    Transition transition = Transition::cut;  ///< from what comes before
    double transition_seconds = 1.0;
    std::vector<ShotKey> keys;
    std::vector<Override> looks;  ///< keys of the look that differ from the film's: "look.palette"
};

struct Film;

/// Where a layer's file lies, and how it was seen from where a film was made (LayerRecord::from).
struct FoundLayer {
    std::string file;
    std::string from{};
};

/// Files of layers, by the keys of their settings (for_each_layer()) or as these write them.
using LayerFiles = std::map<std::string, FoundLayer>;

/// A piece of another film, without its cards and captions.
struct Excerpt {
    std::string film;      ///< a film file, the name of one that fumon ships, or its text
    std::int64_t run = 1;  ///< which of the film's runs it shows
    double from = 0.0;     ///< seconds of that film's shots
    WordOrReal to{"end", 0.0};
    Transition transition = Transition::cut;  ///< from what comes before
    double transition_seconds = 1.0;
    std::shared_ptr<const Film> read{};  ///< what is cut from; set by parse_film
};

/// Large lettering at the film's start or end.
struct Card {
    CardPosition place = CardPosition::start;
    CardBackground ground = CardBackground::picture;
    double seconds = 4.0;
    std::string title;               ///< large
    std::vector<std::string> lines;  ///< below it
    double fade = 0.6;               ///< seconds in which it comes and goes
};

/// A line below the picture for a while.
struct Caption {
    double from = 0.0;  ///< seconds of the film
    double to = 3.0;
    std::string text;
};

/// A film that is cut from a run's stored beds: a value.
struct Film {
    FilmSettings settings;
    PaneSettings panes;
    std::vector<Shot> shots;
    std::vector<Excerpt> excerpts;  ///< instead of shots
    std::vector<Card> cards;
    std::vector<Caption> captions;
    std::vector<OverlaySettings> overlays;
    std::vector<Override> looks;  ///< keys of the look that differ from the run's scene

    LayerFiles found_layers;  ///< of a film made again, whose own folder they may not be in

    std::string source;                            ///< the file's name, for messages
    std::map<std::string, std::string> locations;  ///< key path → "file:line:column"

    /// "file:line:column: " of a key, or of the file where the key is not written.
    [[nodiscard]] std::string at(const std::string& key) const;
};

}  // namespace fumon
