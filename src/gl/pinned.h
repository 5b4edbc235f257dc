#pragma once

#include <string>
#include <vector>

namespace fumon::gl {

/// Makes Mesa's llvmpipe draw the same pixels on every x86-64 processor with SSE4.1, given one
/// version of Mesa and LLVM. Sets environment variables: a fixed processor level (SSE 4.1, without
/// FMA; about a fifth slower), a fixed number of raster threads, and no switch that changes what is
/// drawn; the user's own settings of these are overridden. Applies to the whole process; call it
/// before other threads start. Throws Error if a context was made before, since Mesa reads its
/// environment once.
void pin_rendering();

[[nodiscard]] bool rendering_is_pinned();

/// The user's environment variables that were overridden, one line for each.
[[nodiscard]] const std::vector<std::string>& overridden_by_pinning();

/// Why pinning does not fix this renderer's pixels on this processor; empty if it does. It works
/// for llvmpipe on x86-64 with SSE4.1 only.
[[nodiscard]] std::string pinning_obstacle(const std::string& renderer);

}  // namespace fumon::gl
