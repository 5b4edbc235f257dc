// sweep.json against a sweep that is to go on, and the record of a run of it.

#include <algorithm>

#include "fuzz_input.h"
#include "sweep/sweep_manifest.h"

namespace {

using namespace fumon;

SweepPlan small_plan() {
    SweepPlan plan;
    plan.axes.push_back(read_axis("model.creep=0.1,0.2", "--over 1"));
    plan.seeds = read_seeds("1:2", 1);
    for (std::size_t n = 0; n < 4; ++n) plan.runs.push_back({n / 2, 1 + static_cast<int>(n % 2)});
    for (SweepRun& run : plan.runs) run.id.fill(static_cast<std::uint8_t>(&run - plan.runs.data()));
    plan.base = {{"run", {{"steps", 8}}}};
    plan.inputs.push_back({"bed.asc", "00ff"});
    return plan;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view text = fuzz::as_text(data, size);
    static const SweepPlan plan = small_plan();
    static const SweepPlan without_axes = [] {
        SweepPlan one = plan;
        one.axes.clear();
        return one;
    }();
    if (listed_runs(text) < -1) fuzz::broken_promise("runs can be counted", text);
    for (const SweepPlan* now : {&plan, &without_axes}) {
        std::vector<std::size_t> order = previous_sweep(text, *now).order;
        std::sort(order.begin(), order.end());
        if (std::adjacent_find(order.begin(), order.end()) != order.end() ||
            (!order.empty() && order.back() >= now->runs.size()))
            fuzz::broken_promise("each run has one number", text);
    }
    const RunRecord record = parse_run_record(text, plan.runs[0].id);
    if (record.status == RunStatus::failed) fuzz::broken_promise("a recorded run is done", text);
    return 0;
}
