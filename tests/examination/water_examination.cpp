// Runs the cases with exact solutions and prints what comes of them as a table:
//
//     water_examination [CASE…] [--cells 100,200,400] [--limiter-tolerance 0.01]
//                       [--limiter-steepness 1.3]
//     water_examination [CASE…] --scenes FOLDER
//
// or writes their scenes, on 100 (squares: 50) cells, with their beds, their water at the start
// where it differs from cell to cell, and exact depths at the end. What it prints are L1 errors of
// the depth over the exact volume; the order of all cells and of those more than five from shores
// and kinks, each from the last two grids and by a least-squares line through all of them; the
// budget of water; seconds of the processor; and beside them those of a plain scheme of first
// order.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <vector>

#include "examination/water_cases.h"

namespace {

using namespace fumon::examination;

std::vector<int> numbers_of(const std::string& text) {
    std::vector<int> numbers;
    for (std::size_t at = 0; at < text.size();) {
        std::size_t length = 0;
        numbers.push_back(std::stoi(text.substr(at), &length));
        at += length + 1;
    }
    return numbers;
}

/// By a least-squares line through the logarithms of the errors over those of the grids' cells,
/// from grid `first` on.
std::string order(const std::vector<int>& grids, const std::vector<Outcome>& outcomes,
                  double Errors::*error, std::size_t first) {
    double cells = 0.0;
    double errors = 0.0;
    const std::size_t count = grids.size() - first;
    if (count < 2) return "–";
    for (std::size_t k = first; k < grids.size(); ++k) {
        if (!(outcomes[k].errors.*error > 1e-13)) return "–";
        cells += std::log(grids[k]) / static_cast<double>(count);
        errors += std::log(outcomes[k].errors.*error) / static_cast<double>(count);
    }
    double squares = 0.0;
    double products = 0.0;
    for (std::size_t k = first; k < grids.size(); ++k) {
        const double off = std::log(grids[k]) - cells;
        squares += off * off;
        products += off * (std::log(outcomes[k].errors.*error) - errors);
    }
    return fmt::format("{:.2f}", 0.0 - products / squares);
}

std::string error_text(double error) {
    return error < 1e-13 ? "0" : fmt::format("{:.1e}", error);
}

void print_case(const Case& one, const std::vector<int>& grids) {
    std::vector<Outcome> ours;
    std::vector<Outcome> plain;
    for (const int cells : grids) {
        ours.push_back(run_case(one, cells, 1));
        plain.push_back(run_plainly(one, cells));
    }
    std::string line = "| " + one.title + " |";
    double mass = 0.0;
    for (const Outcome& outcome : ours) {
        line += ' ' + error_text(outcome.errors.depth) + " |";
        mass = std::max(mass, outcome.errors.mass);
    }
    const std::size_t last = grids.size() - 1;
    const std::size_t pair = last == 0 ? 0 : last - 1;
    fmt::print("{} {} | {} | {} | {} | {:.0e} | {:.2f} | {} | {} | {:.2f} |\n", line,
               order(grids, ours, &Errors::depth, pair), order(grids, ours, &Errors::depth, 0),
               order(grids, ours, &Errors::away, pair), order(grids, ours, &Errors::away, 0), mass,
               ours[last].seconds, error_text(plain[last].errors.depth),
               order(grids, plain, &Errors::depth, pair), plain[last].seconds);
    std::fflush(stdout);
}

void write_scene(const Case& one, const std::filesystem::path& folder) {
    const int cells = cells_of_scene(one);
    std::ofstream(folder / (one.name + ".toml")) << scene_of(one, cells);
    constexpr int points = 200;
    std::ofstream(folder / (one.name + ".csv")) << curve_of(one, points);
    const auto write = [&](const char* end, const std::string& grid) {
        if (!grid.empty()) std::ofstream(folder / (one.name + end)) << grid;
    };
    write(".asc", bed_of(one, cells));
    write("-depth.asc", depth_of(one, cells));
    write("-velocity_y.asc", velocity_of(one, cells));
}

}  // namespace

int main(int count, char** arguments) {
    std::vector<int> grids{100, 200, 400};
    std::vector<std::string> names;
    std::filesystem::path folder;
    std::optional<double> tolerance;
    std::optional<double> steepness;
    for (int k = 1; k < count; ++k) {
        const std::string word = arguments[k];
        if (word == "--cells" && k + 1 < count) {
            grids = numbers_of(arguments[++k]);
        } else if (word == "--limiter-tolerance" && k + 1 < count) {
            tolerance = std::stod(arguments[++k]);
        } else if (word == "--limiter-steepness" && k + 1 < count) {
            steepness = std::stod(arguments[++k]);
        } else if (word == "--scenes" && k + 1 < count) {
            folder = arguments[++k];
        } else {
            names.push_back(word);
        }
    }
    const auto is_asked = [&](const Case& one) {
        return names.empty() || std::ranges::find(names, one.name) != names.end();
    };
    if (!folder.empty()) {
        for (const Case& one : all_cases()) {
            if (is_asked(one)) write_scene(one, folder);
        }
        return 0;
    }
    std::string head = "| case |";
    std::string rule = "|---|";
    for (const int cells : grids) {
        head += fmt::format(" {} |", cells);
        rule += "---|";
    }
    fmt::print(
        "{} order | of all grids | away from shores and kinks | of all grids | budget | s | first "
        "order: error | order | s |\n"
        "{}---|---|---|---|---|---|---|---|---|\n",
        head, rule);
    for (Case one : all_cases()) {
        if (tolerance) one.parameters.limiter_tolerance = *tolerance;
        if (steepness) one.parameters.limiter_steepness = *steepness;
        if (is_asked(one)) print_case(one, grids);
    }
    return 0;
}
