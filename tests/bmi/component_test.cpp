// A model as a component of the Basic Model Interface, as a C++ program that couples models uses
// it. Every function of every model is called in tests/python/test_bmi.py.

#include "bmi/component.h"

#include <dlfcn.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <exception>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "base/error.h"
#include "models/shared/state_hash.h"
#include "support/program.h"

namespace fumon::test {
namespace {

constexpr const char* ripples =
    "[model]\nname = \"sand\"\n[grid]\nnx = 12\nny = 8\n[run]\nsteps = 4\n";
constexpr const char* elevation = "land_surface__elevation";

/// Steps a component and sets every cell of its bed 1 higher; the bed then.
std::vector<double> raised(bmi::Bmi& component, const std::string& scene) {
    component.Initialize(scene);
    component.UpdateUntil(3.0);
    EXPECT_EQ(component.GetCurrentTime(), 3.0);
    std::array<int, 2> shape{};
    component.GetGridShape(component.GetVarGrid(elevation), shape.data());
    EXPECT_EQ(shape, (std::array{8, 12}));
    const auto cells = static_cast<std::size_t>(component.GetVarNbytes(elevation) /
                                                component.GetVarItemsize(elevation));
    std::vector<double> bed(cells);
    component.GetValue(elevation, bed.data());
    for (double& height : bed) height += 1.0;
    const auto* shown = static_cast<const double*>(component.GetValuePtr(elevation));
    component.SetValue(elevation, bed.data());
    EXPECT_EQ(std::vector<double>(shown, shown + cells), bed);
    component.Update();
    component.GetValue(elevation, bed.data());
    return bed;
}

TEST(BmiComponent, ACppProgramStepsAndChangesAModel) {
    const ScratchFolder folder;
    write_text(folder / "ripples.toml", ripples);
    const auto component = std::make_unique<BmiComponent>();
    const std::vector<double> bed = raised(*component, (folder / "ripples.toml").string());
    double sum = 0.0;
    for (const double height : bed) sum += height;
    EXPECT_GT(sum, static_cast<double>(bed.size())) << "sand stays, raised by 1";
    component->Finalize();
    EXPECT_THROW(component->Update(), InputError);
}

TEST(BmiComponent, AChangeThatIsRefusedLeavesTheModel) {
    const ScratchFolder folder;
    write_text(folder / "ripples.toml", ripples);
    CoupledModel model((folder / "ripples.toml").string());
    model.step();
    const Sha256 before = state_hash(model.model());
    const auto rate = std::ranges::find(model.variables(), "model.creep_rate", &Variable::name);
    ASSERT_NE(rate, model.variables().end());
    EXPECT_THROW(model.set(*rate, {-7.0}), InputError);
    EXPECT_EQ(state_hash(model.model()), before);
    EXPECT_EQ(model.model().steps_done(), 1);
    model.set(*rate, model.values(*rate));
    EXPECT_EQ(state_hash(model.model()), before) << "set to what it is";
}

TEST(BmiComponent, TheLibraryMakesThem) {
#ifdef FUMON_BMI_LIBRARY
    const ScratchFolder folder;
    write_text(folder / "ripples.toml", ripples);
    const std::string scene = (folder / "ripples.toml").string();
    void* library = dlopen(FUMON_BMI_LIBRARY, RTLD_NOW | RTLD_LOCAL);
    ASSERT_NE(library, nullptr) << dlerror();
    const auto create = reinterpret_cast<bmi::Bmi* (*)()>(dlsym(library, "bmi_model_create"));
    const auto destroy = reinterpret_cast<void (*)(bmi::Bmi*)>(dlsym(library, "bmi_model_destroy"));
    ASSERT_TRUE(create != nullptr && destroy != nullptr);
    bmi::Bmi* component = create();
    BmiComponent linked;
    EXPECT_EQ(raised(*component, scene), raised(linked, scene));
    EXPECT_THROW(component->GetGridSize(9), std::exception);
    destroy(component);
#else
    GTEST_SKIP() << "built without the Python module, and so without libfumonbmi";
#endif
}

}  // namespace
}  // namespace fumon::test
