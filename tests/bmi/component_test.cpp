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
#include "files/udunits_unit.h"
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

TEST(BmiComponent, AShippedSceneIsFoundByItsName) {
    BmiComponent component;
    component.Initialize("terada-ripples");
    EXPECT_EQ(component.GetComponentName(), "fumon sand");
    EXPECT_THROW(component.Initialize("terada-ripplez"), InputError);
    EXPECT_EQ(component.GetVarUnits("model.creep_rate"), "1") << "the former one is still there";
}

TEST(BmiComponent, UnitsAreThoseOfUdunits) {
    EXPECT_EQ(udunits_unit("", true), "1");
    EXPECT_EQ(udunits_unit("m", true), "m");
    EXPECT_EQ(udunits_unit("mm/h", true), "mm h-1");
    EXPECT_EQ(udunits_unit("kg/(m^2 s)", true), "kg m-2 s-1");
    EXPECT_EQ(udunits_unit("1/(m^2 yr)", true), "m-2 yr-1");
    EXPECT_EQ(udunits_unit("m2", true), "m2");
    EXPECT_EQ(udunits_unit("m/m", true), "1");
    EXPECT_EQ(udunits_unit("per mm", true), "mm-1");
    EXPECT_EQ(udunits_unit("deg", true), "degree");
    EXPECT_EQ(udunits_unit("degrees", true), "degree");
    for (const char* counted :
         {"share per step", "sites", "heights", "per site", "sites per height", "s/m^(1/3)",
          "m^(1/2)/s", "steps", "m^", "(m", "m)", "m/"})
        EXPECT_EQ(udunits_unit(counted, true), "1") << counted;
    EXPECT_EQ(udunits_unit("m or sites", true), "m");
    EXPECT_EQ(udunits_unit("m or sites", false), "1");
}

/// What the tester of CSDMS asks of a component: each variable, its type, unit and place.
TEST(BmiComponent, EveryModelKeepsTheRulesOfTheInterface) {
    const ScratchFolder folder;
    for (const char* name : {"sand", "sandpile", "dunes", "gully", "water", "airflow", "static"}) {
        SCOPED_TRACE(name);
        const bool is_section = std::string(name) == "airflow";
        write_text(folder / "scene.toml", "[model]\nname = \"" + std::string(name) +
                                              "\"\n[grid]\nnx = 32\nny = " +
                                              (is_section ? "1" : "20") + "\n[run]\nsteps = 2\n");
        BmiComponent component;
        component.Initialize((folder / "scene.toml").string());
        std::vector<std::string> names = component.GetInputVarNames();
        for (const std::string& output : component.GetOutputVarNames()) names.push_back(output);
        for (const std::string& variable : names) {
            SCOPED_TRACE(variable);
            const int size = component.GetGridSize(component.GetVarGrid(variable));
            EXPECT_EQ(component.GetVarType(variable), "double");
            EXPECT_EQ(component.GetVarItemsize(variable), static_cast<int>(sizeof(double)));
            EXPECT_EQ(component.GetVarNbytes(variable), size * component.GetVarItemsize(variable));
            EXPECT_EQ(component.GetVarLocation(variable), "node");
            EXPECT_EQ(component.GetVarUnits(variable).find_first_of("^/(),"), std::string::npos);
            std::vector<double> values(static_cast<std::size_t>(size));
            component.GetValue(variable, values.data());
            const auto* shown = static_cast<const double*>(component.GetValuePtr(variable));
            EXPECT_EQ(std::vector<double>(shown, shown + size), values);
        }
        EXPECT_EQ(component.GetStartTime(), component.GetCurrentTime());
        EXPECT_LE(component.GetCurrentTime(), component.GetEndTime());
        component.Update();
        EXPECT_GT(component.GetCurrentTime(), 0.0);
        component.Finalize();
    }
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
    GTEST_SKIP() << "built without libfumonbmi";
#endif
}

}  // namespace
}  // namespace fumon::test
