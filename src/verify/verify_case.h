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

/// The version whose defaults hold for a case, as SceneText::version: of the fumon that made this
/// record of it, where there is one and its defaults are asked for.
std::string version_of(const Baseline& baseline, const BaselineCase& one, CaseDefaults defaults,
                       const std::string& record);

/// The scene of a case with its settings. Throws InputError located at the case. A baseline may
/// come from anyone: where it is not trusted, scene/trust.h holds, and messages tell nothing of the
/// files that it names, nor whether they are there.
Scene scene_of(const Baseline& baseline, const BaselineCase& one, bool trusted,
               const std::string& version);

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
                    const std::string& version, const WorkOptions& work);

/// The expected picture of a record (see record_name()) that is kept beside the baseline; none
/// where the case keeps none or the file is not there. Throws InputError where it is not the
/// picture that was recorded, ignored pixels apart.
std::optional<Image> recorded_picture(const Baseline& baseline, const BaselineCase& one,
                                      const std::string& name, const BaselineRecord& record,
                                      const IgnoredPixels& ignored = {});

}  // namespace fumon
