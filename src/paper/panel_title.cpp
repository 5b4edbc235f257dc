#include "paper/panel_title.h"

#include <fmt/format.h>

#include <optional>
#include <string_view>

#include "figure/panels/step_text.h"
#include "scene/placeholders.h"

namespace fumon {

std::string panel_title(const PanelSettings& settings, const Scene& scene,
                        const Snapshot* snapshot) {
    constexpr std::string_view time_in_unit = "time:";
    return fill_placeholders(settings.title,
                             [&](const std::string& name) -> std::optional<std::string> {
                                 if (snapshot != nullptr && name == "step")
                                     return fmt::format("{}", snapshot->step);
                                 if (snapshot != nullptr && name == "time") {
                                     if (snapshot->time_unit == "steps")
                                         return fmt::format("{}", snapshot->step);
                                     return natural_time(snapshot->time, snapshot->time_unit);
                                 }
                                 if (snapshot != nullptr && name.starts_with(time_in_unit))
                                     return time_in(snapshot->time, snapshot->time_unit,
                                                    name.substr(time_in_unit.size()));
                                 return key_text(scene, name);
                             });
}

}  // namespace fumon
