#pragma once

namespace fumon {

/// What a model shapes: it decides which measures there are and what pictures may show of it.
enum class Landform {
    terrain,  ///< a bed as it is, which nothing shapes
    bed,      ///< a bed under the wind
    profile,  ///< a bed, shaped or not, of a single row
    pile,     ///< grains that fall and topple, with avalanches
    water,    ///< a bed under running water
    air,      ///< the air over a bed, which snapshots show as a section
};

}  // namespace fumon
