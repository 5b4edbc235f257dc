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

}  // namespace

std::string scene_of(const Case& one, int cells) {
    const double width = strip_rows * one.length / cells;
    std::string text = fmt::format(
        "# Written by water_examination (tests/examination): a flow with an exact solution, of\n"
        "# Delestre et al. (2013), on a strip of {} x {} cells, until {:g} s.\n"
        "title = \"{}\"\n\n[model]\nname = \"water\"\ngravity = {}\n",
        cells, strip_rows, one.duration, one.title, exact::gravity);
    text += friction_of(one.parameters);
    text += "edges_x = \"wall\"\nedges_y = \"periodic\"\n";
    if (one.parameters.rain > 0.0) text += fmt::format("rain = {:g}\n", one.parameters.rain);
    text += fmt::format("time_step = {:g}\n", one.duration / steps);
    if (one.behind == 0.0)
        text += fmt::format("initial_water = \"surface\"\nsurface = {:.9g}\n", one.level);
    if (one.behind > 0.0) text += region_of(0.0, 0.5 * one.length, width, one.behind);
    if (one.before > 0.0) text += region_of(0.5 * one.length, one.length, width, one.before);
    for (const EdgeSettings& edge : one.parameters.edges) text += edge_of(edge, width);
    text += bed_of(one, cells).empty()
                ? fmt::format("\n[grid]\nnx = {}\nny = {}\ncell_size = {:.9g}\n", cells, strip_rows,
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
    const Grid bed = one.bed(cells, strip_rows);
    bool is_flat = true;
    for (const double height : bed.values()) is_flat = is_flat && height == 0.0;
    if (is_flat) return {};
    std::string row;
    for (int x = 0; x < cells; ++x) row += fmt::format("{}{:.9g}", x == 0 ? "" : " ", bed(x, 0));
    std::string text = fmt::format(
        "ncols {}\nnrows {}\nxllcorner 0\nyllcorner 0\ncellsize {:.9g}\nNODATA_value -9999\n",
        cells, strip_rows, one.length / cells);
    for (int y = 0; y < strip_rows; ++y) text += row + "\n";
    return text;
}

}  // namespace fumon::examination
