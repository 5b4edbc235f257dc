#include "hop_law/hop_law_scene.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "base/error.h"
#include "models/air/section_flights.h"

namespace fumon {

namespace {

constexpr int table_bins = 20;

HopFits fits_of(std::span<const Flight> flights, std::span<const HopPoint> points) {
    HopFits fits;
    fits.flights = flights.size();
    fits.exponential = fit_exponential(points);
    fits.line = fit_linear(points);
    for (const Flight& flight : flights) fits.reynolds = std::max(fits.reynolds, flight.reynolds);
    return fits;
}

/// The flights in sites and model heights, slopes in heights a site.
std::vector<HopPoint> in_sites(const MeasuredHops& hops) {
    std::vector<HopPoint> points;
    points.reserve(hops.points.size());
    for (const HopPoint& point : hops.points) {
        points.push_back({point.height / hops.height, point.slope * hops.site / hops.height,
                          point.length / hops.site});
    }
    return points;
}

/// Upwind hops, which the sand model has not, count as none.
HopTable table_of(const MeasuredHops& hops) {
    HopTable table = tabulate(in_sites(hops), table_bins);
    for (double& length : table.lengths) length = std::max(length, 0.0);
    return table;
}

Override setting(const std::string& key, const std::string& value) {
    return {key, value, "the measured law", 0};
}

Override setting(const std::string& key, double value) {
    return setting(key, fmt::format("{}", value));
}

Override setting(const std::string& key, const std::vector<double>& values) {
    return setting(key, fmt::format("[{}]", fmt::join(values, ", ")));
}

std::string fit_line(const std::string& angle, const HopFits& fits) {
    return fmt::format("{:>8} {:>8} {:>10.4g} {:>8.3f} {:>+11.4g} {:>+9.4g} h {:>8.3f} {:>9.3g}",
                       angle, fits.flights, fits.exponential.base, fits.exponential.r_squared,
                       fits.line.constant, fits.line.per_height, fits.line.r_squared,
                       fits.reynolds);
}

}  // namespace

MeasuredHops measure_hops(std::span<const Flight> flights, std::span<const double> angles) {
    MeasuredHops hops;
    hops.angles.assign(angles.begin(), angles.end());
    hops.points = hop_points(flights);
    hops.pooled = fits_of(flights, hops.points);
    const std::size_t columns = flights.size() / angles.size();
    for (std::size_t k = 0; k < angles.size(); ++k) {
        const std::span<const HopPoint> points = hops.points;
        hops.of_angle.push_back(
            fits_of(flights.subspan(k * columns, columns), points.subspan(k * columns, columns)));
    }
    for (const HopPoint& point : hops.points) hops.height = std::max(hops.height, point.height);
    const double from_crest = hops.pooled.exponential.length(hops.height);
    if (!(from_crest > 0.0)) {
        throw Error(fmt::format(
            "flights do not grow with the height they start from: the fit l = a^h - 1 has a = "
            "{:.4g} per mm, the line c = {:+.4g} mm {:+.4g} h; take other model.launch_angles or "
            "another bed",
            hops.pooled.exponential.base, hops.pooled.line.constant, hops.pooled.line.per_height));
    }
    hops.site = from_crest / MeasuredHops::sites_from_crest;
    return hops;
}

std::vector<Override> law_settings(const MeasuredHops& hops, HopForm form) {
    switch (form) {
        case HopForm::exponential:
            return {setting("model.hop_length", "exponential"),
                    setting("model.exponential_base", hops.pooled.exponential.base),
                    setting("model.exponential_height", hops.height / 2.0),
                    setting("model.exponential_length", 10.0 * MeasuredHops::sites_from_crest)};
        case HopForm::linear: {
            const LinearLaw law = fit_linear(in_sites(hops));
            return {setting("model.hop_length", "linear"), setting("model.hop_base", law.constant),
                    setting("model.hop_per_height", law.per_height)};
        }
        case HopForm::table: {
            const HopTable table = table_of(hops);
            return {setting("model.hop_length", "tabulated"),
                    setting("model.hop_table_heights", table.heights),
                    setting("model.hop_table_lengths", table.lengths)};
        }
        case HopForm::slope: {
            const SlopeLaw law = fit_slope(in_sites(hops));
            if (law.factor < 0.0) {
                throw Error(fmt::format(
                    "these flights lengthen with the slope: l = {:.4g} - ({:.4g}) tanh(dh/dx) "
                    "sites, R^2 {:.3f}, but the dune rule L0 - alpha tanh(dh/dx) needs alpha >= 0; "
                    "take --form exponential, linear or table",
                    law.constant, law.factor, law.r_squared));
            }
            return {setting("model.hop_length", "slope"), setting("model.hop_base", law.constant),
                    setting("model.hop_slope_factor", law.factor)};
        }
    }
    return {};
}

std::vector<std::string> fit_lines(const MeasuredHops& hops) {
    std::vector<std::string> lines{fmt::format("{:>8} {:>8} {:>10} {:>8} {:>23} {:>8} {:>9}",
                                               "angle", "flights", "a per mm", "R^2", "line, mm",
                                               "R^2", "Reynolds")};
    for (std::size_t k = 0; k < hops.angles.size(); ++k)
        lines.push_back(fit_line(fmt::format("{:g}", hops.angles[k]), hops.of_angle[k]));
    lines.push_back(fit_line("all", hops.pooled));
    return lines;
}

std::string law_line(const MeasuredHops& hops, HopForm form) {
    switch (form) {
        case HopForm::exponential:
            return fmt::format(
                "L = 10 (a^(2 h0 h) - 1) / (a^(2 h0) - 1) sites, a = {:.4g} per mm, "
                "h0 = {:.4g} mm, R^2 {:.3f}",
                hops.pooled.exponential.base, hops.height / 2.0, hops.pooled.exponential.r_squared);
        case HopForm::linear: {
            const LinearLaw law = fit_linear(in_sites(hops));
            return fmt::format("L = {:.4g} {:+.4g} h sites, none upwind, R^2 {:.3f}", law.constant,
                               law.per_height, law.r_squared);
        }
        case HopForm::table:
            return fmt::format(
                "a table of {} mean lengths over the height, which stay beyond its "
                "ends",
                table_of(hops).heights.size());
        case HopForm::slope: {
            const SlopeLaw law = fit_slope(in_sites(hops));
            return fmt::format("L = {:.4g} - {:.4g} tanh(dh/dx) sites, R^2 {:.3f}", law.constant,
                               law.factor, law.r_squared);
        }
    }
    return {};
}

}  // namespace fumon
