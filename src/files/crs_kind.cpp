#include "files/crs_kind.h"

#include "files/wkt.h"

namespace fumon {

namespace {

bool has_word(const std::string& name, std::string_view word) {
    return name.find(word) != std::string::npos;
}

const std::string& first_value(const WktNode* node) {
    static const std::string none;
    return node == nullptr || node->values.empty() ? none : node->values.front();
}

/// The unit of a projected system: its own, or that of its axes.
const WktNode* unit_of(const WktNode& system) {
    if (const WktNode* unit = system.child({"UNIT", "LENGTHUNIT"})) return unit;
    const WktNode* axis = system.child({"AXIS"});
    return axis == nullptr ? nullptr : axis->child({"UNIT", "LENGTHUNIT"});
}

}  // namespace

CrsKind crs_kind(std::string_view wkt) {
    CrsKind kind;
    const auto root = parse_wkt(wkt);
    if (!root) return kind;
    const WktNode* system = root->find({"PROJCS", "PROJCRS", "PROJECTEDCRS"});
    if (system == nullptr) {
        kind.geographic =
            root->find({"GEOGCS", "GEOGCRS", "GEODCRS", "GEOGRAPHICCRS", "GEODETICCRS"}) != nullptr;
        return kind;
    }
    kind.projected = true;
    const std::string& name = first_value(system);
    kind.utm = has_word(name, "UTM zone") || has_word(name, "UTM_Zone");
    const std::string& method = first_value(system->find({"PROJECTION", "METHOD"}));
    kind.mercator = has_word(method, "Mercator") && !has_word(method, "Transverse") &&
                    !has_word(method, "Oblique");
    if (const WktNode* unit = unit_of(*system)) {
        kind.metres = unit->number(1).value_or(1.0);
        kind.unit = first_value(unit);
    }
    return kind;
}

}  // namespace fumon
