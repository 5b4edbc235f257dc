#pragma once

#include <functional>
#include <string>

#include "scene/figure/figure_settings.h"

namespace fumon {

/// Hears of a fault: the key's name within its panel or curve, and what is wrong with it.
using ChartFault = std::function<void(const std::string& key, const std::string& what)>;

/// Checks the keys of a panel's chart against each other.
void check_chart(const PanelSettings& panel, const ChartFault& refuse);

/// Checks what a curve of a panel of this kind says of its columns, its formula and its spread.
void check_chart_curve(const PanelSettings& panel, const CurveSettings& curve,
                       const ChartFault& refuse);

}  // namespace fumon
