#pragma once

#include <string>

#include "keys/keys.h"
#include "scene/figure/chart_settings.h"

namespace fumon {

/// Lists the keys of a panel's chart; `path` is the panel's: "figure.panel.0".
void list_chart_keys(ChartSettings& chart, const std::string& path, KeyTable& table);

}  // namespace fumon
