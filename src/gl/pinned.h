#pragma once

#include <string>
#include <vector>

namespace fumon::gl {

/// Makes Mesa's llvmpipe draw the same pixels on every x86-64 processor, one version of Mesa and
/// LLVM given: by its environment, of which a fixed level of the processor (SSE 4.1, without FMA;
/// about a fifth slower), a fixed number of raster threads and no switch that changes what it
/// draws. What the user has set otherwise is overridden. For the whole process; to be called before
/// its other threads start. Throws Error where a context was made before: Mesa reads its
/// environment once.
void pin_rendering();

[[nodiscard]] bool rendering_is_pinned();

/// What of the user's environment was overridden, one line a variable.
[[nodiscard]] const std::vector<std::string>& overridden_by_pinning();

/// Why this renderer's pixels are not fixed by it, or empty where they are: only llvmpipe's are,
/// and on x86-64 only.
[[nodiscard]] std::string why_not_pinned(const std::string& renderer);

}  // namespace fumon::gl
