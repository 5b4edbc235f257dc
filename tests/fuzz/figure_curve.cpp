// Curves of a figure from a table: the input's first lines are the curve's settings, as lines of a
// scene's [[figure.panel.curve]]; behind an empty line follows the table.

#include "paper/figure_curve.h"

#include <cmath>
#include <cstddef>

#include "read_scene.h"

namespace {

using namespace fumon;

bool has_columns(const CurveSettings& settings, const Table& table) {
    if (table.find(settings.x) == nullptr || table.find(settings.y) == nullptr) return false;
    return settings.group_by.empty() || table.find(settings.group_by) != nullptr;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view input = fuzz::as_text(data, size);
    const std::size_t gap = input.find("\n\n");
    if (gap == std::string_view::npos) return -1;
    const auto scene = fuzz::read_scene_text(
        "[[figure.panel]]\nkind = \"plot\"\n[[figure.panel.curve]]\ntable = \"file\"\n"
        "file = \"table.csv\"\n" +
        std::string(input.substr(0, gap)));
    if (!scene || scene->figure.panels.empty() || scene->figure.panels[0].curves.empty()) return -1;
    CurvePlan plan{
        scene->figure.panels[0].curves[0], "figure.panel.0.curve.0", {}, {}, *scene, 0, {}};
    try {
        fuzz::taken([&] {
            plan.table = parse_csv_table({"table.csv", input.substr(gap + 2)});
            if (!has_columns(plan.settings, plan.table)) return;
            for (const CurvePoints& points : curve_points(plan, plan.table)) {
                if (points.x.empty() || points.x.size() != points.y.size())
                    fuzz::broken_promise("a curve has points", points.name);
                const Table drawn = parse_csv_table({"curve.csv", curve_csv(points)});
                std::size_t with_data = 0;  // the others break its line
                for (std::size_t i = 0; i < points.x.size(); ++i)
                    with_data += std::isfinite(points.x[i]) && std::isfinite(points.y[i]) ? 1 : 0;
                if (drawn.rows() != with_data)
                    fuzz::broken_promise("a curve's table has its points", curve_csv(points));
            }
        });
    } catch (const InputError&) {
        throw;
    } catch (const Error&) {  // a law that cannot be fitted
    }
    return 0;
}
