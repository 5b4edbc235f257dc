#include "models/dunes/setup/dunes_parameters.h"

namespace fumon {

namespace {

void list_wind(DuneWind& wind, const std::string& path, KeyTable& table) {
    table.real(
        path + ".from", wind.from,
        {.unit = "degrees",
         .range = {-360, 360},
         .help = "direction from which it blows, clockwise from north; 270 blows toward +x"});
    table.real(
        path + ".strength", wind.strength,
        {.range = {0, 100, true}, .help = "its drift over flat sand, in parts of model.flux"});
    table.real(path + ".duration", wind.duration,
               {.unit = "yr",
                .range = {0, 1e6, true},
                .help = "time for which it blows, in whole steps, before the next wind; for a "
                        "table, the time of all its winds together"});
    table.text(path + ".table", wind.table,
               {.help = "a file of winds (direction,speed,frequency or direction,flux; see "
                        "fumon orientation), which blow in turn instead of this one; as seen from "
                        "the scene's folder"});
    table.real(path + ".gust_angle", wind.gust_angle,
               {.unit = "degrees",
                .range = {0, 90},
                .help = "gusts come from directions drawn about it: their standard deviation"});
    table.real(path + ".gust_strength", wind.gust_strength,
               {.range = {0, 1},
                .help = "gusts are as strong as drawn about its strength: their standard "
                        "deviation, in parts of it"});
    table.real(
        path + ".gust_duration", wind.gust_duration,
        {.unit = "yr", .range = {0, 1e6, true}, .help = "how long a gust lasts, in whole steps"});
    table.word_or_real(
        path + ".threshold_ratio", wind.threshold_ratio,
        {{"auto",
          "of winds whose speed or friction velocity is given, also by a table, what these are; of "
          "others \"none\""},
         {"none", "a wind far above the threshold: the drift follows the stress"}},
        {.range = {1, 1e3, true},
         .help = "its friction velocity over that at which sand begins to move, which "
                 "slopes raise: near 1 relief counts for more and flat beds grow "
                 "longer waves or none (Gadal et al. 2019); of speed_up = "
                 "\"relief\"",
         .earlier = {"0.3.0", "\"none\""}});
    table.word_or_real(
        path + ".speed", wind.speed, {{"none", "its drift is given by its strength"}},
        {.unit = "m/s",
         .range = {0, 150},
         .help = "at wind.speed_height; its drift is then the saturated flux (Sauermann et al. "
                 "2001; Duran & Moore 2013) of u* = 0.4 speed / ln(speed_height / "
                 "model.roughness), and none up to the threshold"});
    table.word_or_real(path + ".friction_velocity", wind.friction_velocity,
                       {{"none", "its drift is given by its strength or speed"}},
                       {.unit = "m/s", .range = {0, 10}, .help = "u*, instead of a speed"});
    table.real(path + ".speed_height", wind.speed_height,
               {.unit = "m",
                .range = {0, 1e3, true},
                .help = "of the anemometer above the ground, of its speed or those of its table"});
}

void list_feature(DuneFeature& feature, const std::string& path, KeyTable& table) {
    constexpr double farthest = 1e6;  // m
    table.choice(
        path + ".kind", feature.kind,
        {{FeatureKind::rock, "rock", "rock that stands on the floor"},
         {FeatureKind::sand, "sand", "a heap of sand"},
         {FeatureKind::source, "source", "a heap of sand that is filled up again after every step"},
         {FeatureKind::clearing, "clearing", "ground from which plants are taken"},
         {FeatureKind::grass, "grass", "grass, up to model.grass_cover"},
         {FeatureKind::shrubs, "shrubs", "shrubs, up to model.shrub_cover"}},
        {.help = "what is set on the ground"});
    table.choice(path + ".shape", feature.shape,
                 {{FeatureShape::block, "block", "a box with vertical sides"},
                  {FeatureShape::cone, "cone", "rises evenly to its middle"},
                  {FeatureShape::hill, "hill", "a squared cosine, level at its foot and top"}},
                 {.help = "its shape; of plants and clearings, how they fade outward"});
    table.real(path + ".x", feature.x,
               {.unit = "m",
                .range = {-farthest, farthest},
                .help = "of its middle, from the bed's western edge"});
    table.real(path + ".y", feature.y,
               {.unit = "m",
                .range = {-farthest, farthest},
                .help = "of its middle, from the bed's southern edge"});
    table.real(
        path + ".length", feature.length,
        {.unit = "m", .range = {0, farthest, true}, .help = "along its axis, from foot to foot"});
    table.real(path + ".width", feature.width,
               {.unit = "m",
                .range = {0, farthest},
                .help = "across its axis, from foot to foot; 0: as its length"});
    table.real(path + ".height", feature.height,
               {.unit = "m", .range = {0, 1e4}, .help = "of rock, sand and sources"});
    table.real(path + ".axis", feature.axis,
               {.unit = "degrees",
                .range = {-360, 360},
                .help = "of its length, clockwise from north; 90 lies along x"});
    table.real(path + ".ravines", feature.ravines,
               {.range = {0, 1},
                .help = "of rock: how deep ravines cut it at most, in parts of its height there; "
                        "drawn by the seed"});
}

void list_species(DuneSpecies& species, const std::string& name, const std::string& plural,
                  KeyTable& table) {
    table.real("model." + name + "_cover", species.cover,
               {.range = {0, 1}, .help = "of " + plural + " at first, where they grow"});
    table.real("model." + name + "_share", species.share,
               {.range = {0, 1},
                .help = "of the cells, drawn by the seed, on which " + plural + " grow at first"});
    table.real_list("model." + name + "_balances", species.balances, 5, 5,
                    {.unit = "m/yr",
                     .range = {-1e3, 1e3},
                     .help = "rising rates of deposition at which the cover of " + plural +
                             " changes by -1, 0, its growth, 0 and -1 a year; linear between "
                             "and beyond them (Baas 2002; Nield & Baas 2008)"});
    table.real("model." + name + "_growth", species.growth,
               {.unit = "1/yr",
                .range = {0, 1e3},
                .help = "of the cover of " + plural + " at the third of these balances"});
    table.real("model." + name + "_height", species.height,
               {.unit = "m",
                .range = {0, 50, true},
                .help = "of " + plural +
                        " where their cover is whole; in proportion to its root "
                        "where it is less; of model.plant_shelter = \"okin\""});
}

void list_plant_keys(DunesParameters& dunes, KeyTable& table) {
    table.choice("model.plants", dunes.plants,
                 {{DunePlants::none, "none", "none"},
                  {DunePlants::fixed, "fixed", "their cover stays as it is at first"},
                  {DunePlants::grow, "grow", "two species grow, spread, and are buried"}},
                 {.help = "plants, which hold sand: less is lifted under them, more stays, and it "
                          "lies more steeply"});
    list_species(dunes.grass, "grass", "grasses, which thrive on burial,", table);
    list_species(dunes.shrubs, "shrub", "shrubs, which thrive on ground at rest,", table);
    table.real("model.plant_spread", dunes.plant_spread,
               {.unit = "m/yr",
                .range = {0, 1e3},
                .help = "how fast plants spread to the cells beside them, on the mean"});
    table.real("model.plant_pioneers", dunes.plant_pioneers,
               {.unit = "1/(m^2 yr)",
                .range = {0, 1e3},
                .help = "first plants on bare sand far from others, on the mean"});
    table.real("model.growth_period", dunes.growth_period,
               {.unit = "yr",
                .range = {0, 1e3, true},
                .help = "interval between growths of plants, in whole steps; each uses the balance "
                        "of sand since the last"});
    table.real("model.cover_without_lift", dunes.cover_without_lift,
               {.range = {0, 1, true},
                .help = "cover of plants from which on no sand is lifted; less cover lets less "
                        "in proportion"});
    table.real("model.plant_repose_angle", dunes.plant_repose_angle,
               {.unit = "degrees",
                .range = {5, 60},
                .help = "model.repose_angle under a plant cover of 0.3 or more; in proportion "
                        "under less"});
    table.choice(
        "model.plant_shelter", dunes.plant_shelter,
        {{DunePlantShelter::none, "none",
          "plants do not slow the wind; model.cover_without_lift says what they hold"},
         {DunePlantShelter::raupach, "raupach",
          "among plants of cover p the stress on the sand is 1/(1 + model.plant_drag p) of the "
          "wind's (Raupach et al. 1993)"},
         {DunePlantShelter::okin, "okin",
          "so, and behind plants of height h the friction velocity recovers as exp(-x/(c h)), c = "
          "model.shelter_length (Okin 2008)"}},
        {.help = "how plants slow the wind at the ground; of continuous transport"});
    table.real("model.plant_drag", dunes.plant_drag,
               {.range = {0, 1e3},
                .help = "drag of plants over that of the ground, for a whole cover (Duran & Moore "
                        "2013: 16); of model.plant_shelter"});
    table.real("model.shelter_length", dunes.shelter_length,
               {.unit = "plant heights",
                .range = {0, 100, true},
                .help = "behind a plant over which the lack of friction velocity falls by a factor "
                        "e; of model.plant_shelter = \"okin\""});
}

void list_transport_keys(DunesParameters& dunes, KeyTable& table) {
    constexpr double longest_hop = 1e4;
    table.choice(
        "model.transport", dunes.transport,
        {{DuneTransport::continuous, "continuous",
          "every cell gives a layer to the wind, which is spread over the cells it reaches "
          "(after Nilles, Guenther & Mueller 2024)"},
         {DuneTransport::slabs, "slabs", "random slabs hop until they come to rest (Werner 1995)"}},
        {.help = "how the wind carries sand"});
    table.real(
        "model.flux", dunes.flux,
        {.unit = "m^2/yr",
         .range = {0, 1e6, true},
         .help = "drift over flat sand, where it is saturated: volume per width and year; of "
                 "winds of strength 1"});
    table.real("model.grain_diameter", dunes.grain_diameter,
               {.unit = "mm",
                .range = {0.05, 2},
                .help = "of the sand, where speeds of winds give the drift and its threshold"});
    table.real("model.roughness", dunes.roughness,
               {.unit = "m",
                .range = {1e-6, 1},
                .help = "of the ground, by which a wind's speed becomes a friction velocity"});
    table.word_or_real(
        "model.saturation_length", dunes.saturation_length,
        {{"auto", "1.3 m, or a cell's size where that is more"},
         {"hops",
          "hops are of one length, model.hop_length; the drift saturates over "
          "model.hop_length (2 - p)/(2 p), with p = model.deposit_on_sand"}},
        {.unit = "m",
         .range = {0, longest_hop, true},
         .help = "length over which the drift comes within 1/e of a new wind's; of continuous "
                 "transport",
         .earlier = {"0.3.0", "\"hops\""}});
    table.real("model.hop_length", dunes.hop_length,
               {.unit = "m",
                .range = {0, longest_hop, true},
                .help = "of a hop over flat ground, of slabs and where model.saturation_length is "
                        "\"hops\""});
    table.real("model.deposit_on_sand", dunes.deposit_on_sand,
               {.range = {0, 1, true}, .help = "share that a hop's end on sand leaves there"});
    table.real("model.deposit_on_rock", dunes.deposit_on_rock,
               {.range = {0, 1, true}, .help = "share that a hop's end on bare rock leaves there"});
    table.real("model.slope_drift", dunes.slope_drift,
               {.range = {0, 10},
                .help = "drift down a slope of 1, in parts of the saturated one over flat sand; of "
                        "continuous transport"});
    table.word_or_real(
        "model.time_step", dunes.time_step,
        {{"auto",
          "such that a step of the strongest wind takes at most 3 % of a cell's size "
          "away where it meets sand"}},
        {.unit = "yr",
         .range = {0, 1e3, true},
         .help = "of continuous transport; a step of slabs takes as long as its "
                 "hops give model.flux"});
    table.word_or_real("model.slab_height", dunes.slab_height,
                       {{"auto", "a third of a cell's size (Werner 1995)"}},
                       {.unit = "m", .range = {0, 1e3, true}, .help = "of slabs"});
    table.choice("model.order", dunes.order,
                 {{SlabOrder::parallel, "parallel",
                   "the picks of a sub-step read the bed at its start; avalanches follow it"},
                  {SlabOrder::sequential, "sequential",
                   "slab after slab, each with its avalanches, on one thread (Werner 1995)"}},
                 {.help = "of slabs"});
    table.integer("model.substeps", dunes.substeps,
                  {.range = {16, 4096}, .help = "sub-steps of a step of slabs in parallel order"});
}

void list_wind_keys(DunesParameters& dunes, KeyTable& table) {
    table.choice(
        "model.speed_up", dunes.speed_up,
        {{DuneSpeedUp::none, "none",
          "the same wind everywhere; dunes of slabs grow of their randomness, continuous drift "
          "makes none"},
         {DuneSpeedUp::height, "height",
          "hops grow with the height above the mean surface (Momiji et al. 2000), which slows "
          "the growth of slabs' dunes; continuous drift makes none"},
         {DuneSpeedUp::relief, "relief",
          "the drift follows the linear shear stress (A + iB) k_w^2/|k| h (Jackson & Hunt "
          "1975; Kroy et al. 2002), of the bed with its separation bubbles; continuous "
          "transport only"}},
        {.help = "how the wind speeds up over dunes"});
    table.real("model.hop_per_height", dunes.hop_per_height,
               {.unit = "1/m", .range = {0, 1e3}, .help = "C1/L0 of speed_up = \"height\""});
    table.real("model.hop_per_height_squared", dunes.hop_per_height_squared,
               {.unit = "1/m^2", .range = {0, 1e3}, .help = "C2/L0 of speed_up = \"height\""});
    table.real("model.shear_in_phase", dunes.shear_in_phase,
               {.range = {0, 100}, .help = "A of speed_up = \"relief\""});
    table.real("model.shear_ahead", dunes.shear_ahead,
               {.range = {0, 100}, .help = "B of speed_up = \"relief\": ahead of the crests"});
    table.choice(
        "model.wind_bend", dunes.wind_bend,
        {{DuneBend::none, "none", "the wind blows straight on everywhere"},
         {DuneBend::shear, "shear",
          "the linear shear stress across the wind, C k_w k_n/|k| h, turns hops aside (Hunt et al. "
          "1988): outward before a hill, inward behind it"},
         {DuneBend::contours, "contours",
          "hops turn along the contours of the relief on scales of 200 and 50 m (Nilles, Guenther "
          "& Mueller 2024)"}},
        {.help = "how relief turns the wind; of continuous transport with speed_up = \"relief\""});
    table.real("model.shear_across", dunes.shear_across,
               {.range = {0, 100}, .help = "C of wind_bend = \"shear\""});
    table.real("model.slope_deflection", dunes.slope_deflection,
               {.range = {0, 2},
                .help = "drift across the wind down a slope of 1 across it, in parts of the local "
                        "drift (Hersen 2004); .2 makes barchans as wide as real ones; of speed_up "
                        "= \"relief\""});
    table.choice(
        "model.shadow", dunes.shadow,
        {{DuneShadow::soft, "soft", "grows from model.shadow_soft_angle to model.shadow_angle"},
         {DuneShadow::hard, "hard", "begins at model.shadow_angle (Werner 1995)"}},
        {.help = "where higher ground upwind keeps the wind off"});
    table.real("model.shadow_angle", dunes.shadow_angle,
               {.unit = "degrees",
                .range = {1, 60},
                .help = "ground at least this far below the line to a crest upwind has no wind"});
    table.real("model.shadow_soft_angle", dunes.shadow_soft_angle,
               {.unit = "degrees",
                .range = {0, 60, true},
                .help = "ground less far below it has the whole wind; below model.shadow_angle"});
    table.word_or_real(
        "model.windward_angle", dunes.windward_angle,
        {{"none", "the wind follows any slope that faces it"}},
        {.unit = "degrees",
         .range = {5, 60},
         .help = "before steeper slopes, such as slip faces of another wind, still air lies below "
                 "this angle, and they speed the wind up no more than it (EN 1991-1-4: 16.7); of "
                 "speed_up = \"relief\""});
}

void list_ground_keys(DunesParameters& dunes, KeyTable& table) {
    table.real("model.repose_angle", dunes.repose_angle,
               {.unit = "degrees",
                .range = {5, 60},
                .help = "dynamic: sliding sand comes to rest at it, within 0.4 degrees"});
    table.real("model.static_angle", dunes.static_angle,
               {.unit = "degrees",
                .range = {5, 60},
                .help = "a slope at rest slides from here on; model.repose_angle or more"});
    table.integer("model.avalanche_passes", dunes.avalanche_passes,
                  {.range = {1, 1e9},
                   .help = "largest number of avalanche passes in a step; the run warns where they "
                           "do not suffice"});
    table.boolean("model.avalanche_age", dunes.avalanche_age,
                  {.help = "keep the field avalanche_age: years since sand last slid from a cell"});
    const std::vector<Choice<DuneEdge>> edges{
        {DuneEdge::periodic, "periodic", "what leaves comes in on the other side"},
        {DuneEdge::open, "open", "sand leaves with the wind, model.influx comes in"}};
    table.choice("model.edges_x", dunes.edges_x, edges, {.help = "west and east edge"});
    table.choice("model.edges_y", dunes.edges_y, edges, {.help = "south and north edge"});
    table.real("model.influx", dunes.influx,
               {.range = {0, 1},
                .help = "drift that comes in over open edges, in parts of the saturated one"});
    table.choice("model.rock", dunes.rock,
                 {{DuneRock::level, "level", "at model.rock_level; the bed above it is sand"},
                  {DuneRock::bed, "bed", "the bed, with model.sand_cover of sand on it"}},
                 {.help = "the hard floor"});
    table.real("model.rock_level", dunes.rock_level,
               {.unit = "m", .range = {-1e5, 1e5}, .help = "of a flat floor"});
    table.real("model.sand_cover", dunes.sand_cover,
               {.unit = "m", .range = {0, 1e3}, .help = "sand on a floor that is the bed"});
    table.real("model.rock_wear", dunes.rock_wear,
               {.range = {0, 1},
                .help = "bare rock that landing sand turns to sand, in parts of its volume on a "
                        "level floor; more on slopes that face the wind; of continuous transport"});
    table.real("model.rock_repose_angle", dunes.rock_repose_angle,
               {.unit = "degrees",
                .range = {5, 89},
                .help = "worn rock that is steeper crumbles to sand"});
    table.word_or_real(
        "model.abrasion_height", dunes.abrasion_height,
        {{"none", "landing sand wears rock at any height"}},
        {.unit = "m",
         .range = {0, 1e3, true},
         .help = "wear falls by a factor e over this height above what ground upwind "
                 "and on either side reaches by a rise of 15 degrees, so that hills "
                 "are worn at their feet (yardangs)"});
    table.real("model.rock_dust", dunes.rock_dust,
               {.range = {0, 1},
                .help = "share of worn rock that is blown away as dust; it counts as outflow"});
    table.word_or_real("model.wall_angle", dunes.wall_angle, {{"none", "no ground is so steep"}},
                       {.unit = "degrees",
                        .range = {35, 89},
                        .help = "before ground that rises more steeply into the wind, from twice "
                                "its height on, the wind slackens, and turns back nearer than .4 "
                                "of its height (echo dunes; Tsoar 1983: about 55 degrees); of "
                                "continuous transport"});
    table.real("model.wall_drift", dunes.wall_drift,
               {.range = {0, 1},
                .help = "wind along the foot of such a wall toward its ends, in parts of the wind, "
                        "which keeps a corridor there clear of sand"});
}

}  // namespace

void list_keys(DunesParameters& dunes, KeyTable& table) {
    list_transport_keys(dunes, table);
    list_wind_keys(dunes, table);
    list_ground_keys(dunes, table);
    list_plant_keys(dunes, table);
    // After all of [model], which a written scene cannot open twice.
    table.tables("wind", dunes.winds, "a wind; they blow in turn, and then from the first again",
                 list_wind);
    table.tables("feature", dunes.features,
                 "something set on the ground before the first step; rock and sand in their order",
                 list_feature);
}

}  // namespace fumon
