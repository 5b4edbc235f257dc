#include "models/registry.h"

#include <gtest/gtest.h>

#include <set>

#include "base/worker_pool.h"
#include "files/netcdf/number_names.h"
#include "scene/initial_bed.h"
#include "scene/read.h"

namespace fumon {
namespace {

TEST(Registry, SnapshotsHaveTheLandformOfTheirModel) {
    std::set<std::string> names;
    for (const ModelEntry& entry : models()) {
        EXPECT_TRUE(names.emplace(entry.name).second) << entry.name;
        const Scene scene = parse_scene("[run]\nsteps = 1\n[grid]\nnx = 100\n[model]\nname = \"" +
                                            std::string(entry.name) + "\"\n",
                                        "scene.toml", "");
        InitialBed initial = make_initial_bed(scene);
        WorkerPool pool(1);
        const auto model = entry.make(scene.model.parameters,
                                      {std::move(initial.bed), {}, initial.scale, 1, pool, false});
        EXPECT_EQ(model->name(), entry.name);
        const Snapshot snapshot = model->snapshot();
        EXPECT_EQ(snapshot.landform, entry.landform) << entry.name;
        EXPECT_EQ(snapshot.section != nullptr, entry.landform == Landform::air) << entry.name;
        for (const SnapshotNumber& number : snapshot.numbers)
            EXPECT_GT(variable_of_number(number.name), "bed_height")
                << "ParaView opens a file at its first name";
    }
}

TEST(Registry, NamesTheModelsOfALandform) {
    EXPECT_EQ(models_of(Landform::pile), "sandpile");
    EXPECT_EQ(models_of(Landform::air), "airflow");
    EXPECT_EQ(models_of(Landform::profile), "") << "which is how a bed is measured";
    EXPECT_EQ(terrain_model().name, "static");
}

}  // namespace
}  // namespace fumon
