#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "keys/word_or_real.h"
#include "scene/figure/figure_settings.h"
#include "scene/view/drape.h"
#include "scene/view/layers.h"

namespace fumon {

enum class Projection { perspective, orthographic, map };
enum class Framing { block, overview, low, along_crest, slip_face, aerial };

struct CameraSettings {
    Projection projection = Projection::perspective;
    Framing framing = Framing::block;
    double azimuth = 215.0;            ///< where the camera stands, degrees clockwise from north
    double elevation = 32.0;           ///< degrees above the horizon
    WordOrReal distance{"auto", 0.0};  ///< from the block's centre, in units of its longer side
    double field_of_view = 28.0;       ///< vertical, degrees (perspective)
    WordOrReal focal_length{"auto", 0.0};  ///< mm, of a lens before 36 × 24 mm (perspective)
    double roll = 0.0;                     ///< degrees to the right (perspective)
    double margin = 0.04;  ///< free border around the fitted block, share of the picture
    /// Where it stands and what it looks at: metres, or sites, eastward and northward from the
    /// bed's south-western corner, and above the bed there. Empty: around the block.
    std::vector<double> at;
    std::vector<double> look_at;
    double turn = 0.0;  ///< degrees of azimuth added over the whole run
    // How wide the lens is (perspective): by one of these, or a pinhole.
    WordOrReal f_number{"pinhole", 0.0};  ///< its focal length over its diameter; in metres
    double aperture = 0.0;                ///< its diameter, metres or sites; 0: a pinhole
    WordOrReal focus{"auto", 0.0};        ///< how far ahead it is sharp, metres or sites
    WordOrReal lens_samples{"auto", 0.0};

    /// Whether what is out of focus is blurred.
    [[nodiscard]] bool has_lens() const { return !f_number.is_word() || aperture > 0.0; }
};

enum class LightSource { sun, moon };

struct SunSettings {
    LightSource source = LightSource::sun;
    double azimuth = 300.0;   ///< degrees clockwise from north
    double elevation = 24.0;  ///< degrees above the horizon
    /// Degrees north and east, and a time as days_from_2000() reads it: where these are given,
    /// azimuth and elevation are the sun's there at the run's start. Empty: azimuth and elevation
    /// say.
    std::vector<double> place;
    std::string time;
    double hours = 0.0;     ///< that pass over the whole run
    double diameter = 2.5;  ///< apparent, degrees: the width of the penumbra
    double strength = 1.0;  ///< of direct light; 1 is a clear day
    double sky_strength = 1.0;
    double dust = 1.0;  ///< aerosol of the air against a clear day, for the sky "atmosphere"
    double haze = 0.0;  ///< aerial perspective at the far edge of the block, 0 … 1
};

enum class Planet { earth, mars };
enum class Clouds { none, cumulus, cirrus };
enum class Aerosol { automatic, thin, desert };

struct AirSettings {
    Planet planet = Planet::earth;
    Aerosol aerosol = Aerosol::automatic;
    Clouds clouds = Clouds::none;
    double cloud_cover = 0.35;             ///< share of the sky overhead
    std::int64_t cloud_seed = 1;           ///< by which they lie elsewhere
    WordOrReal cloud_height{"auto", 0.0};  ///< m of their base above the ground
    double cloud_wind = 270.0;             ///< degrees clockwise from north, where it comes from
    double cloud_drift = 0.0;              ///< km over the whole run
    WordOrReal visibility{"auto", 0.0};    ///< km, how far dark things are seen
};

enum class Colouring {
    natural,
    height,
    slope,
    change,
    water_depth,
    speed,
    froude,
    drainage,
    field,
    field_change
};
enum class ViewMode { scenic, figure };
enum class Marking { none, last_avalanche, ground };
enum class RockSurface { weathered, pavement };
enum class Ground { automatic, table, endless };
enum class FarGround { varied, alike };
enum class Background { surroundings, transparent };
enum class LandCover { bare, automatic };
enum class SurveyEdge { none, line, fade };
enum class SkyModel { automatic, automatic_0_2, two_colours, atmosphere, overcast };
enum class Tone { automatic, automatic_0_2, filmic, agx, agx_punchy, neutral };
enum class WaterTint { none, blue_green };
enum class PileSurface { smooth, cells };
enum class LightKind { automatic, sun, studio };
enum class BlockSides { plain, soil, layers };
enum class SandKind { quartz, iron_red, gypsum, carbonate, basalt, martian };
enum class FigureRelief { soft, clear };
enum class ColourSpan { run, frame };
enum class Datum { automatic, first, mean };
enum class DrapeLight { relit, as_it_is };

struct LookSettings {
    std::string preset;  ///< a look whose values stand for defaults; empty once a scene is read
    ViewMode mode = ViewMode::scenic;
    Colouring colour_by = Colouring::natural;
    std::string field;  ///< by name, where it is coloured by one
    std::string palette = "sand";
    bool palette_reversed = false;
    WordOrReal low{"auto", 0.0};           ///< value at the palette's start
    WordOrReal high{"auto", 0.0};          ///< value at its end
    ColourSpan range = ColourSpan::run;    ///< where low or high is "auto"
    WordOrReal exaggeration{"auto", 0.0};  ///< vertical
    Ground ground = Ground::automatic;
    FarGround far_copies = FarGround::varied;
    SurveyEdge survey_edge = SurveyEdge::none;  ///< of a bed that ends, on endless ground
    Background background = Background::surroundings;
    LightKind light = LightKind::automatic;
    SkyModel sky = SkyModel::automatic;
    Tone tone = Tone::automatic;
    double exposure = 0.0;  ///< stops
    WordOrReal contrast{"auto", 0.0};
    bool block_sides = true;
    BlockSides sides = BlockSides::plain;
    bool strata = false;  ///< layers and stones below the grid, on surfaces of real terrain
    LandCover cover = LandCover::bare;
    WordOrReal sea_level{"none", 0.0};  ///< of still water that is drawn over low ground, metres
    WordOrReal snow_line{"none", 0.0};  ///< of a cover by rule, in the bed's heights, metres
    SandKind sand = SandKind::quartz;
    double grain = 0.5;  ///< visible texture of the sand, 0 … 1
    PileSurface pile = PileSurface::smooth;
    double ripples = 1.0;              ///< steepness of wind ripples on endless ground, 0 … 1
    double plants = 1.0;               ///< share of the plants that are drawn one by one, 0 … 1
    WordOrReal contours{"none", 0.0};  ///< metres (or model heights) between lines of equal height
    WordOrReal room{"auto", 0.0};      ///< heights framed above the first bed
    WordOrReal footing{"auto", 0.0};   ///< heights of the block under the first bed's lowest place
    Datum datum = Datum::automatic;
    FigureRelief relief = FigureRelief::soft;  ///< of a figure
    double shading = 1.0;                      ///< hill shading of a figure, 0 … 1
    bool water = true;                         ///< draw the water, where the model has some
    WordOrReal water_clarity{"auto", 0.0};     ///< metres of water that hide half of the bed
    WaterTint water_tint = WaterTint::none;
    double turbidity = 0.15;  ///< 0 clear … 1 muddy
    bool air = true;          ///< draw the air over a profile, where the model has some
    Marking mark = Marking::none;
    RockSurface rock = RockSurface::weathered;  ///< where marked ground is rock
    std::string drape;            ///< a picture laid over the bed: a file; empty: none
    double drape_strength = 1.0;  ///< how far it hides the ground, 0 … 1
    DrapeLight drape_light = DrapeLight::relit;
    std::int64_t profile_start = 0;  ///< of a single row: the first site shown
    std::int64_t profile_sites = 0;  ///< and how many; 0: 900 or all

    [[nodiscard]] bool draws_contours() const { return contours.word != "none"; }
};

struct ImageSettings {
    std::int64_t width = 1920;
    std::int64_t height = 1080;
    std::int64_t supersampling = 2;  ///< 1, 2 or 4 samples along each side of a pixel
    double dots_per_inch = 300.0;    ///< written into the PNG
    bool deep_colour = false;        ///< PNG of 16 bits a channel
    std::int64_t quality = 92;       ///< of JPEG and WebP, 1 … 100
    bool lossless = false;           ///< WebP without loss
    std::string language = "en";     ///< of what fumon writes on it
    std::vector<std::string> words;  ///< others in their place: files, or "words: wind = 風"
};

enum class SectionArrows { arrows, streamlines, none };
enum class SectionColour { speed, velocity_x, velocity_z, pressure };

/// The figure of a section (look.mode = "figure" and a model with one).
struct SectionSettings {
    std::vector<std::string> panels;  ///< empty: velocity, pressure and stress, where there are any
    SectionArrows arrows = SectionArrows::arrows;
    SectionColour colour_by = SectionColour::speed;  ///< of the velocity's panel
    WordOrReal low{"auto", 0.0};                     ///< of the velocity's panel, m/s, or Pa
    WordOrReal high{"auto", 0.0};
    WordOrReal font_size{"auto", 0.0};  ///< points

    friend bool operator==(const SectionSettings&, const SectionSettings&) = default;
};

/// Sand blown over brinks and in wisps over stoss sides ("streamers", Baas 2003).
struct StreamerSettings {
    double strength = 0.0;           ///< 0 none … 1
    WordOrReal length{"auto", 0.0};  ///< m (or sites) that plumes reach downwind
    double travel = 0.25;            ///< m (or sites) that they go on by in a step
};

/// A person who stands on the bed, as a scale: the first is 1.75 m tall.
struct PersonSettings {
    std::vector<double> at;          ///< metres east and north of the bed's south-western corner
    WordOrReal facing{"auto", 0.0};  ///< degrees clockwise from north
};

enum class TrackKind { foot };

/// Prints in the sand along a line.
struct TrackSettings {
    TrackKind kind = TrackKind::foot;
    std::vector<double>
        along;              ///< metres east and north of the bed's south-western corner, in turn
    std::int64_t seed = 1;  ///< by which prints differ
};

/// All that decides how a snapshot looks.
struct View {
    CameraSettings camera;
    SunSettings sun;
    AirSettings air;
    LookSettings look;
    SectionSettings section;
    ImageSettings image;
    std::vector<OverlaySettings> overlays;
    std::vector<PersonSettings> persons;
    std::vector<TrackSettings> tracks;
    StreamerSettings streamers;
    std::vector<LayerSettings> layers;
    std::shared_ptr<const Drape> drape{};  ///< of look.drape, once it is read; null: none
    std::shared_ptr<const PlacedLayers> placed_layers{};  ///< once they are read; null: none

    /// What is laid over the ground: the drape and the areas of layers; null: nothing.
    [[nodiscard]] const Drape* laid() const {
        return placed_layers && placed_layers->areas ? placed_layers->areas.get() : drape.get();
    }
};

}  // namespace fumon
