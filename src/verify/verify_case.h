#pragma once

#include <optional>

#include "base/image.h"
#include "picture/baseline.h"
#include "run/terminal/work_options.h"
#include "scene/scene.h"

namespace fumon {

/// Of which fumon the defaults hold that a case's scene leaves to it.
enum class CaseDefaults {
    as_recorded,  ///< the one that recorded the case, so that old baselines hold
    of_today,     ///< this one, for a case that is to be recorded
};

/// The scene of a case with its settings. Throws InputError located at the case. A baseline may
/// come from anyone: where it is not trusted, scene/trust.h holds, and messages tell nothing of the
/// files that it names, nor whether they are there.
Scene scene_of(const Baseline& baseline, const BaselineCase& one, bool trusted,
               CaseDefaults defaults);

/// A case as it looks now.
struct DrawnCase {
    Image image;
    BaselineRecord record;
    IgnoredPixels ignored;
    int signal = 0;  ///< that stopped it before it was drawn, or 0
};

/// Runs the case's scene to its step or time and draws it. Throws InputError located at the case
/// where scene, step or bed are wrong, Error where the run or OpenGL fails.
DrawnCase draw_case(const Baseline& baseline, const BaselineCase& one, bool trusted,
                    CaseDefaults defaults, const WorkOptions& work);

/// The expected picture that is kept beside the baseline; none where the case keeps none or the
/// file is not there. Throws InputError where it is not the picture that was recorded, ignored
/// pixels apart.
std::optional<Image> recorded_picture(const Baseline& baseline, const BaselineCase& one,
                                      const BaselineRecord& record,
                                      const IgnoredPixels& ignored = {});

}  // namespace fumon
