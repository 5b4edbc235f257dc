#pragma once

#include <cstdint>
#include <vector>

#include "render/air/section_air.h"
#include "render/colour/palette.h"

namespace fumon {

class WorkerPool;

/// The air of a section as a picture: red, green, blue and opacity, lowest row first. It spans the
/// section's whole length, column 0 centred half a cell from its left edge, and its heights `low` …
/// `high` (metres).
struct AirSheet {
    int width = 0;
    int height = 0;
    double low = 0.0;
    double high = 0.0;
    std::vector<std::uint8_t> rgba;
};

/// The share of the palette at which a speed is painted, 0 … 1, the fastest air of the section
/// having the highest.
double air_palette_share(double speed, double fastest);

/// The fastest air of a section, m/s; 0 without a velocity.
double fastest_air(const SectionAir& air);

/// Paints a section `width` pixels wide: its speed in the palette, thinner towards the section's
/// top, with streamlines in white. `low` is the height where the picture begins, metres;
/// `rise` how much larger heights are drawn than lengths.
AirSheet paint_air_sheet(const SectionAir& air, const Palette& palette, int width, double low,
                         double rise, WorkerPool& pool);

}  // namespace fumon
