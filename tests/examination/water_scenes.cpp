#include <fmt/format.h>

#include "examination/water_cases.h"

namespace fumon::examination {

namespace {

constexpr int steps = 100;

std::string friction_of(const GullyParameters& parameters) {
    if (parameters.friction == FrictionLaw::manning)
        return fmt::format("friction = \"manning\"\nmanning = {}\n", parameters.manning);
    if (parameters.friction == FrictionLaw::chezy)
        return fmt::format("friction = \"chezy\"\nchezy = {}\n", parameters.chezy);
    return "friction_coefficient = 0\n";
}

std::string edge_of(const EdgeSettings& edge, double width) {
    std::string text =
        fmt::format("\n[[edge]]\nside = \"{}\"\n", edge.side == GridSide::west ? "west" : "east");
    if (edge.kind == EdgeFlow::open) return text;
    const bool comes_in = edge.kind == EdgeFlow::discharge;
    text += fmt::format("kind = \"{}\"\nvalue = {:.9g}\n", comes_in ? "discharge" : "level",
                        comes_in ? edge.value * width : edge.value);
    if (edge.depth > 0.0) text += fmt::format("depth = {:.9g}\n", edge.depth);
    return text;
}

std::string region_of(double west, double east, double width, double depth) {
    return fmt::format("\n[[water]]\nwindow = [{:.9g}, 0, {:.9g}, {:.9g}]\ndepth = {:.9g}\n", west,
                       east, width, depth);
}

std::string map_of(const Case& one, const char* quantity) {
    return fmt::format("\n[[map]]\nquantity = \"{0}\"\nfile = \"{1}-{0}.asc\"\n", quantity,
                       one.name);
}

int rows_of(const Case& one, int cells) {
    return one.square ? cells : strip_rows;
}

/// North row first.
template <class Value>
std::string grid_of(const Case& one, int cells, const Value& value) {
    const int rows = rows_of(one, cells);
    std::string text = fmt::format(
        "ncols {}\nnrows {}\nxllcorner 0\nyllcorner 0\ncellsize {:.9g}\nNODATA_value -9999\n",
        cells, rows, one.length / cells);
    for (int y = rows - 1; y >= 0; --y) {
        for (int x = 0; x < cells; ++x)
            text += fmt::format("{}{:.9g}", x == 0 ? "" : " ", value(x, y));
        text += "\n";
    }
    return text;
}

}  // namespace

std::string scene_of(const Case& one, int cells) {
    const int rows = rows_of(one, cells);
    const double width = rows * one.length / cells;
    std::string text = fmt::format(
        "# Written by water_examination (tests/examination): a flow with an exact solution, of\n"
        "# Delestre et al. (2013), on {} x {} cells, until {:g} s.\n"
        "title = \"{}\"\n\n[model]\nname = \"water\"\ngravity = {}\n",
        cells, rows, one.duration, one.title, exact::gravity);
    text += friction_of(one.parameters);
    if (one.parameters.limiter_tolerance > 0.0)
        text += fmt::format("limiter_tolerance = {:g}\n", one.parameters.limiter_tolerance);
    if (one.parameters.limiter_steepness < 2.0)
        text += fmt::format("limiter_steepness = {:g}\n", one.parameters.limiter_steepness);
    if (one.parameters.shore_velocity == ShoreVelocity::even) text += "shore_velocity = \"even\"\n";
    if (one.parameters.shore_cells == ShoreCells::planes) text += "shore_cells = \"planes\"\n";
    text += fmt::format("edges_x = \"wall\"\nedges_y = \"{}\"\n", one.square ? "wall" : "periodic");
    if (one.parameters.rain > 0.0) text += fmt::format("rain = {:g}\n", one.parameters.rain);
    text += fmt::format("time_step = {:.9g}\n", one.duration / steps);
    if (one.behind == 0.0 && !one.basin)
        text += fmt::format("initial_water = \"surface\"\nsurface = {:.9g}\n", one.level);
    if (one.behind > 0.0) text += region_of(0.0, 0.5 * one.length, width, one.behind);
    if (one.before > 0.0) text += region_of(0.5 * one.length, one.length, width, one.before);
    for (const EdgeSettings& edge : one.parameters.edges) text += edge_of(edge, width);
    if (!depth_of(one, cells).empty()) text += map_of(one, "depth");
    if (!velocity_of(one, cells).empty()) text += map_of(one, "velocity_y");
    text += bed_of(one, cells).empty()
                ? fmt::format("\n[grid]\nnx = {}\nny = {}\ncell_size = {:.9g}\n", cells, rows,
                              one.length / cells)
                : fmt::format("\n[bed]\nfile = \"{}.asc\"\n", one.name);
    return text + fmt::format("\n[run]\nsteps = {}\n\n[frames]\nevery = {}\n", steps, steps / 10);
}

std::string curve_of(const Case& one, int points) {
    std::string text = "x,depth\n";
    for (int k = 0; k < points; ++k) {
        const double x = (k + 0.5) * one.length / points;
        if (one.west + x > one.until) break;
        text += fmt::format("{:.9g},{:.9g}\n", x, one.exact(one.west + x, 0.0, one.duration).depth);
    }
    return text;
}

std::string bed_of(const Case& one, int cells) {
    const Grid bed = one.bed(cells, rows_of(one, cells));
    bool is_flat = true;
    for (const double height : bed.values()) is_flat = is_flat && height == 0.0;
    if (is_flat) return {};
    return grid_of(one, cells, [&](int x, int y) { return bed(x, y); });
}

std::string depth_of(const Case& one, int cells) {
    if (!one.basin) return {};
    const Setting setting = setting_of(one, cells);
    return grid_of(one, cells, [&](int x, int y) { return setting.water.depth(x, y); });
}

std::string velocity_of(const Case& one, int cells) {
    if (!one.basin) return {};
    const Setting setting = setting_of(one, cells);
    bool is_at_rest = true;
    for (const double v : setting.water.velocity_y.values()) is_at_rest = is_at_rest && v == 0.0;
    if (is_at_rest) return {};
    return grid_of(one, cells, [&](int x, int y) { return setting.water.velocity_y(x, y); });
}

}  // namespace fumon::examination
