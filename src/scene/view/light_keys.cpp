#include "keys/keys.h"
#include "scene/view/view_keys.h"

namespace fumon {

void list_sun_keys(SunSettings& sun, KeyTable& table) {
    table.choice("sun.source", sun.source,
                 {{LightSource::sun, "sun", "daylight"},
                  {LightSource::moon, "moon",
                   "a clear night under a full moon at the sun's place: dark, bluish as eyes see "
                   "it, stars"}},
                 {.help = "source of the light"});
    table.real("sun.azimuth", sun.azimuth,
               {.unit = "degrees",
                .range = {-360, 360},
                .help = "where the sun stands, clockwise from north"});
    table.real("sun.elevation", sun.elevation,
               {.unit = "degrees", .range = {1, 90}, .help = "above the horizon"});
    table.real_list(
        "sun.place", sun.place, 0, 2,
        {.unit = "degrees",
         .range = {-180, 180},
         .help = "latitude and longitude (north and east positive) that place the sun, with "
                 "sun.time, instead of sun.azimuth and sun.elevation; the bed's y is true north"});
    table.text("sun.time", sun.time,
               {.unit = iso_time,
                .help = "when, with its offset from UTC: \"2026-03-20T06:40+00:00\" or "
                        "\"2026-03-20T06:40Z\"; the run's start where sun.hours pass"});
    table.real(
        "sun.hours", sun.hours,
        {.range = {-8784, 8784},
         .help = "hours that pass during the run, evenly with its steps, so that the sun moves"});
    table.real("sun.diameter", sun.diameter,
               {.unit = "degrees",
                .range = {0.1, 30},
                .help = "apparent size: the width of the shadows' soft edge"});
    table.real("sun.strength", sun.strength,
               {.range = {0, 10}, .help = "factor of direct sunlight; 1 is a clear day"});
    table.real("sun.sky_strength", sun.sky_strength,
               {.range = {0, 10}, .help = "factor of light from the sky; 1 is a clear day"});
    table.real("sun.dust", sun.dust,
               {.range = {0, 100},
                .help = "aerosol of the air, for the sky \"atmosphere\"; 1 is a clear day"});
    table.real("sun.haze", sun.haze,
               {.range = {0, 1},
                .help = "aerial perspective at the far edge of the block",
                .earlier = {"0.3.0", "0.35"}});
}

void list_air_keys(AirSettings& air, KeyTable& table) {
    table.choice("air.planet", air.planet,
                 {{Planet::earth, "earth", "blue sky"},
                  {Planet::mars, "mars",
                   "thin air full of fine dust: butterscotch sky, blue around a low sun"}},
                 {.help = "planet whose air scatters the light, for look.sky = \"atmosphere\""});
    table.choice(
        "air.aerosol", air.aerosol,
        {{Aerosol::automatic, "auto", "desert over endless ground on Earth, else thin"},
         {Aerosol::thin, "thin",
          "almost none in the sky, and haze that dims all colours alike, as before version 0.3"},
         {Aerosol::desert, "desert",
          "a clear day in a desert: hides far dunes and whitens the sky above them"}},
        {.help = "aerosol in the lowest air", .earlier = {"0.3.0", "\"thin\""}});
    table.choice(
        "air.clouds", air.clouds,
        {{Clouds::none, "none", "a clear sky, or the even cover of look.sky = \"overcast\""},
         {Clouds::cumulus, "cumulus", "of fair weather: flat bases, heads like cauliflowers"},
         {Clouds::cirrus, "cirrus", "high ice, drawn out into threads"}},
        {.help = "kind of clouds, for look.sky = \"atmosphere\" in scenic views"});
    table.real("air.cloud_cover", air.cloud_cover,
               {.range = {0, 1}, .help = "approximate share of the ground under clouds"});
    table.integer("air.cloud_seed", air.cloud_seed,
                  {.range = {0, 1e9}, .help = "seed of the clouds' places"});
    table.word_or_real("air.cloud_height", air.cloud_height,
                       {{"auto", "1800 of cumulus, 8500 of cirrus"}},
                       {.unit = "m",
                        .range = {300, 15000},
                        .help = "height of the clouds' base above the ground"});
    table.real("air.cloud_wind", air.cloud_wind,
               {.unit = "degrees",
                .range = {-360, 360},
                .help = "direction from which the wind at the clouds' height blows, clockwise from "
                        "north; cirrus stretches along it"});
    table.real(
        "air.cloud_drift", air.cloud_drift,
        {.unit = "km",
         .range = {-1e4, 1e4},
         .help =
             "distance that clouds drift with that wind during the run, evenly with its steps"});
    table.word_or_real(
        "air.visibility", air.visibility,
        {{"auto",
          "over endless ground 30 km on a clear day in a desert, less with sun.dust over 1 (in "
          "thin "
          "air 40 km, and no more than 80 km over sun.dust); where the bed ends in a plain, eight "
          "times its longer side if that is more; around a block on a table as sun.haze says"}},
        {.unit = "km",
         .range = {1e-4, 1e5},
         .help = "distance at which dark objects near the ground vanish in haze (Koschmieder "
                 "1924); without metres the bed's longer side counts as 1 km"});
}

}  // namespace fumon
