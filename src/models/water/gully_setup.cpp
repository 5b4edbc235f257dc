#include "models/water/gully_setup.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/elementary.h"
#include "base/error.h"
#include "models/water/cip_scheme.h"
#include "models/water/finite_volume_scheme.h"
#include "models/water/water_setup.h"

namespace fumon {

namespace {

constexpr double published_slope = 0.04;
constexpr double published_factor = 1.0;  // K_f of the paper's slopes, of some hundredths
constexpr double terrain_factor =
    1e-5;  // cuts millimetres on hillsides, decimetres in streams, in an hour
constexpr double published_diffusion = 1.0;  // m²/s; on a terrain in metres it would level it

bool all_periodic(const WaterDomain& domain) {
    return domain.edges_x == EdgeKind::periodic && domain.edges_y == EdgeKind::periodic;
}

EdgeKind decided(EdgeKind edge, bool from_file, bool has_walls) {
    if (edge != EdgeKind::automatic) return edge;
    if (from_file) return EdgeKind::open;
    return has_walls ? EdgeKind::wall : EdgeKind::periodic;
}

/// Whether a scene says more of the edges of an axis.
bool has_segments(const GullyParameters& parameters, bool across_x) {
    return std::ranges::any_of(parameters.edges, [&](const EdgeSettings& edge) {
        return (edge.side == GridSide::west || edge.side == GridSide::east) == across_x;
    });
}

WaterDomain domain_of(const GullyParameters& parameters, ModelSetup& setup) {
    WaterDomain domain;
    domain.dx = setup.scale.dx;
    domain.dy = setup.scale.dy;
    domain.slope = parameters.slope.is_word() ? (setup.from_file ? 0.0 : published_slope)
                                              : parameters.slope.value;
    domain.slope_x = parameters.slope_x;
    domain.edges_x = decided(parameters.edges_x, setup.from_file,
                             parameters.basin || has_segments(parameters, true));
    domain.edges_y = decided(parameters.edges_y, setup.from_file,
                             parameters.basin || has_segments(parameters, false));
    domain.segments = edge_segments_of(parameters, domain, setup.bed.nx(), setup.bed.ny());
    domain.nodata = std::move(setup.nodata);
    return domain;
}

void check_scheme(const GullyParameters& parameters, const WaterDomain& domain) {
    if (parameters.scheme == WaterScheme::finite_volume) return;
    if (parameters.transport == SedimentTransport::loads) {
        throw KeyError("model.transport",
                       "the CIP schemes carry no loads; take model.scheme = \"finite-volume\"");
    }
    if (parameters.friction == FrictionLaw::manning) {
        throw KeyError("model.friction",
                       "the CIP schemes have no Manning friction; take model.scheme = "
                       "\"finite-volume\", or model.friction = \"chezy\"");
    }
    for (const MapQuantity quantity : {MapQuantity::rain, MapQuantity::roughness}) {
        if (!has_map(parameters, quantity)) continue;
        throw KeyError("model.scheme",
                       "the CIP schemes have one rain and one friction for all cells; take "
                       "model.scheme = \"finite-volume\" for maps of them");
    }
    if (domain.slope_x != 0.0) {
        throw KeyError("model.slope_x",
                       "the CIP schemes slope along y alone; take model.scheme = "
                       "\"finite-volume\"");
    }
    if (!all_periodic(domain)) {
        throw KeyError("model.scheme",
                       "the CIP schemes need periodic edges; take model.scheme = "
                       "\"finite-volume\" for open edges and walls");
    }
    if (!domain.nodata.empty()) {
        throw KeyError("model.scheme",
                       "the CIP schemes need a bed without holes, but it has cells without data; "
                       "take model.scheme = \"finite-volume\" or bed.nodata = \"fill\"");
    }
}

void check_slope(const GullyParameters& parameters) {
    if (parameters.slope_x == 0.0 || parameters.transport != SedimentTransport::as_printed) return;
    throw KeyError("model.slope_x",
                   "eq. 12 as printed has its y axis down the plane; take another "
                   "model.transport, or turn the scene so that it slopes along y");
}

void check_motion(const GullyParameters& parameters, const WaterDomain& domain, bool from_file) {
    const bool brought =
        parameters.rain > 0.0 || !parameters.rain_times.empty() || !parameters.regions.empty() ||
        !parameters.edges.empty() || has_map(parameters, MapQuantity::rain) ||
        has_map(parameters, MapQuantity::depth) || has_map(parameters, MapQuantity::level);
    if (parameters.basin || brought) return;
    const bool dry = parameters.initial_water == InitialWater::dry ||
                     (parameters.depth == 0.0 && parameters.initial_water != InitialWater::surface);
    if (dry) {
        throw KeyError(parameters.depth == 0.0 ? "model.depth" : "model.initial_water",
                       "there is no water at the start and no rain; give model.depth with "
                       "model.initial_water = \"film\" or \"level\", or set model.rain");
    }
    if (domain.slope == 0.0 && domain.slope_x == 0.0 && all_periodic(domain) && !from_file &&
        parameters.channel_depth == 0.0 && parameters.initial_water == InitialWater::film) {
        throw KeyError("model.slope",
                       "model.slope is 0, and a film on a level periodic plane has nowhere to "
                       "flow; give a slope, rain, a channel or a terrain file");
    }
}

/// How the bed changes, with every "auto" decided.
void decide_sediment(GullyParameters& parameters, bool from_file) {
    if (parameters.transport_factor.is_word())
        parameters.transport_factor = from_file ? terrain_factor : published_factor;
    const bool fixed = parameters.transport == SedimentTransport::none;
    const bool loads = parameters.transport == SedimentTransport::loads;
    if (parameters.bed_diffusion.is_word()) {
        parameters.bed_diffusion = from_file || fixed || loads ? 0.0 : published_diffusion;
    } else if (fixed && parameters.bed_diffusion.value > 0.0) {
        throw KeyError("model.bed_diffusion",
                       "model.transport = \"none\" is a fixed bed, which does not diffuse; leave "
                       "the key out, or take model.transport_factor = 0 with another transport for "
                       "diffusion alone");
    }
}

Relief decided_relief(const GullyParameters& parameters, bool from_file) {
    const bool published = parameters.scheme == WaterScheme::cip_as_published;
    if (parameters.relief == Relief::automatic)
        return from_file && !published ? Relief::steep : Relief::gentle;
    if (parameters.relief == Relief::steep && published) {
        throw KeyError("model.relief",
                       "model.scheme = \"cip-as-published\" is for gentle relief; leave the key "
                       "out or take another scheme");
    }
    return parameters.relief;
}

/// C_f in water of model.depth.
double friction_in_film(const GullyParameters& parameters) {
    if (parameters.friction != FrictionLaw::manning) return constant_friction(parameters);
    if (parameters.depth == 0.0) return 0.0;
    const double root = elementary::exp(elementary::log_of_normal(parameters.depth) / 3.0);
    return parameters.gravity * (parameters.manning * parameters.manning) / root;
}

/// √(g h S / C_f), the speed at which friction holds the plane's pull, m/s; 0 for flow at rest.
double initial_speed(const GullyParameters& parameters, const WaterDomain& domain) {
    const double friction = friction_in_film(parameters);
    switch (parameters.initial_flow) {
        case InitialFlow::rest:
            return 0.0;
        case InitialFlow::automatic:
            if (friction == 0.0) return 0.0;
            break;
        case InitialFlow::uniform:
            if (friction == 0.0 && (domain.slope > 0.0 || domain.slope_x != 0.0)) {
                throw KeyError("model.initial_flow",
                               "without friction no uniform flow exists; take "
                               "model.initial_flow = \"rest\" or a model.friction_coefficient");
            }
            break;
    }
    const double slope =
        domain.slope_x == 0.0
            ? domain.slope
            : std::sqrt(domain.slope * domain.slope + domain.slope_x * domain.slope_x);
    if (slope == 0.0) return 0.0;
    return std::sqrt(parameters.gravity * parameters.depth * slope / friction);
}

/// A Gaussian trough down the middle of the plane.
void cut_channel(const GullyParameters& parameters, double dx, Grid& bed) {
    if (parameters.channel_depth == 0.0) return;
    const int middle = bed.nx() / 2;
    for (int x = 0; x < bed.nx(); ++x) {
        const double across = (x - middle) * dx / parameters.channel_width;
        const double cut = parameters.channel_depth * elementary::exp(-0.5 * across * across);
        for (int y = 0; y < bed.ny(); ++y) bed(x, y) -= cut;
    }
}

/// The height of a level surface over the bed, under which the water is `depth` deep in the mean.
double level_of(double depth, const Grid& bed, const Mask& nodata) {
    std::vector<double> heights;
    heights.reserve(bed.size());
    for (std::size_t cell = 0; cell < bed.size(); ++cell) {
        if (nodata.empty() || nodata.values()[cell] == 0) heights.push_back(bed.values()[cell]);
    }
    std::ranges::sort(heights);
    const double volume = depth * static_cast<double>(heights.size());
    double below = 0.0;  // sum of the heights that the water covers
    for (std::size_t covered = 1; covered <= heights.size(); ++covered) {
        below += heights[covered - 1];
        const double level = (volume + below) / static_cast<double>(covered);
        if (covered == heights.size() || level <= heights[covered]) return level;
    }
    return 0.0;
}

Water water_of(const GullyParameters& parameters, const WaterDomain& domain, const Grid& bed,
               const std::vector<CellMap>& maps) {
    const int nx = bed.nx();
    const int ny = bed.ny();
    Water water{Grid(nx, ny), Grid(nx, ny), Grid(nx, ny)};
    const double speed = initial_speed(parameters, domain);
    const bool is_level = parameters.initial_water == InitialWater::level;
    const double level = is_level ? level_of(parameters.depth, bed, domain.nodata) : 0.0;
    for (std::size_t cell = 0; cell < bed.size(); ++cell) {
        if (!domain.nodata.empty() && domain.nodata.values()[cell] != 0) continue;
        double& depth = water.depth.values()[cell];
        switch (parameters.initial_water) {
            case InitialWater::film:
                depth = parameters.depth;
                break;
            case InitialWater::level:
                depth = std::max(0.0, level - bed.values()[cell]);
                break;
            case InitialWater::surface:
                depth = std::max(0.0, parameters.surface - bed.values()[cell]);
                break;
            case InitialWater::dry:
                break;
        }
        if (!(depth > 0.0)) continue;
        if (domain.slope_x == 0.0) {
            water.velocity_y.values()[cell] = -speed;
            continue;
        }
        const double slope =
            std::sqrt(domain.slope * domain.slope + domain.slope_x * domain.slope_x);
        water.velocity_x.values()[cell] = speed * (domain.slope_x / slope);
        water.velocity_y.values()[cell] = -speed * (domain.slope / slope);
    }
    fill_from_maps(parameters, domain, bed, maps, water);
    fill_regions(parameters, domain, bed, water);
    return water;
}

}  // namespace

GullyStart start_of_gully(const GullyParameters& parameters, ModelSetup& setup) {
    GullyStart start;
    start.parameters = parameters;
    start.on_terrain = setup.from_file;
    start.domain = domain_of(parameters, setup);
    if (start.parameters.scheme == WaterScheme::automatic) {
        const bool plane =
            all_periodic(start.domain) && start.domain.nodata.empty() &&
            start.domain.slope_x == 0.0 && parameters.friction != FrictionLaw::manning &&
            parameters.transport != SedimentTransport::loads &&
            !has_map(parameters, MapQuantity::rain) && !has_map(parameters, MapQuantity::roughness);
        start.parameters.scheme = plane ? WaterScheme::cip : WaterScheme::finite_volume;
    }
    check_rain(parameters);
    check_maps(parameters, start.domain, setup.maps);
    check_slope(parameters);
    check_scheme(start.parameters, start.domain);
    check_motion(parameters, start.domain, setup.from_file);
    decide_sediment(start.parameters, setup.from_file);
    start.parameters.relief = decided_relief(start.parameters, setup.from_file);
    start.bed = std::move(setup.bed);
    cut_channel(parameters, start.domain.dx, start.bed);
    start.water = water_of(parameters, start.domain, start.bed, setup.maps);
    start.roughness = roughness_of(parameters, start.domain, setup.maps);
    start.soil = soil_of(parameters, start.domain, setup.maps);
    start.rain_maps = rain_maps_of(parameters, start.domain, setup.maps);
    return start;
}

std::unique_ptr<SedimentLoads> make_loads(const GullyStart& start, WorkerPool& pool) {
    const GullyParameters& parameters = start.parameters;
    if (parameters.transport != SedimentTransport::loads) return nullptr;
    const WaterDomain& domain = start.domain;
    Grid friction = start.roughness;
    for (double& cell : friction.values()) cell = friction_factor(parameters, cell);
    const LoadGround ground{start.bed.nx(),
                            start.bed.ny(),
                            domain.dx,
                            domain.dy,
                            domain.slope,
                            domain.slope_x,
                            domain.edges_x == EdgeKind::periodic,
                            domain.edges_y == EdgeKind::periodic,
                            domain.nodata,
                            parameters.gravity,
                            parameters.friction == FrictionLaw::manning,
                            friction_factor(parameters),
                            std::move(friction)};
    return std::make_unique<SedimentLoads>(parameters.loads, ground, pool);
}

std::unique_ptr<ShallowWaterScheme> make_water_scheme(const GullyStart& start, WorkerPool& pool) {
    switch (start.parameters.scheme) {
        case WaterScheme::cip:
        case WaterScheme::cip_as_published:
            return std::make_unique<CipScheme>(start.parameters, start.domain, start.water, pool);
        case WaterScheme::automatic:
        case WaterScheme::finite_volume:
            break;
    }
    return std::make_unique<FiniteVolumeScheme>(start.parameters, start.domain, pool,
                                                start.roughness);
}

}  // namespace fumon
