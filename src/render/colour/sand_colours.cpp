#include "render/colour/sand_colours.h"

namespace fumon {

SandColours sand_colours(const LookSettings& look) {
    switch (look.sand) {
        case SandKind::quartz:
            break;
        case SandKind::iron_red:
            return {{0.500F, 0.228F, 0.092F}, {0.385F, 0.150F, 0.052F}};
        case SandKind::gypsum:
            return {{0.800F, 0.785F, 0.750F}, {0.690F, 0.672F, 0.640F}};
        case SandKind::carbonate:
            return {{0.740F, 0.660F, 0.520F}, {0.620F, 0.530F, 0.390F}};
        case SandKind::basalt:
            return {{0.105F, 0.096F, 0.090F}, {0.062F, 0.056F, 0.053F}};
        case SandKind::martian:
            return {{0.330F, 0.190F, 0.118F}, {0.190F, 0.112F, 0.074F}};
    }
    if (look.ground == Ground::endless || look.light == LightKind::studio)
        return {{0.615F, 0.436F, 0.262F}, {0.490F, 0.320F, 0.178F}};
    return {{0.800F, 0.500F, 0.235F}, {0.600F, 0.315F, 0.120F}};
}

}  // namespace fumon
