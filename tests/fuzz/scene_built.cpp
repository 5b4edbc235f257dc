// Scenes that are taken and have a small grid: their beds and models.

#include "base/worker_pool.h"
#include "models/registry.h"
#include "read_scene.h"
#include "scene/initial_bed.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace fumon;
    const auto scene = fuzz::read_small_scene(data, size);
    if (!scene) return -1;
    fuzz::taken([&] {
        const InitialBed initial = make_initial_bed(*scene);
        static WorkerPool pool(1, "fuzz");
        const auto model = find_model(scene->model.name)
                               ->make(scene->model.parameters,
                                      {initial.bed, initial.nodata, initial.scale,
                                       static_cast<std::uint64_t>(scene->seed), pool, false});
        if (model->snapshot().bed.size() == 0) fuzz::broken_promise("a model has a bed", "");
    });
    return 0;
}
