// Five steps of a scene, its bed raised by a tenth of its unit after each: coupled SCENE
#include <fumon/bmi.h>
#include <fumon/bmi_library.h>

#include <cstdio>
#include <exception>
#include <vector>

int main(int count, char** arguments) try {
    bmi::Bmi* model = bmi_model_create();
    model->Initialize(count > 1 ? arguments[1] : "terada-ripples");
    std::vector<double> bed(static_cast<std::size_t>(model->GetGridSize(0)));
    for (int step = 0; step < 5; ++step) {
        model->Update();
        model->GetValue("land_surface__elevation", bed.data());
        for (double& height : bed) height += 0.1;
        model->SetValue("land_surface__elevation", bed.data());
    }
    std::printf("%s: %zu cells at time %g %s\n", model->GetComponentName().c_str(), bed.size(),
                model->GetCurrentTime(), model->GetTimeUnits().c_str());
    bmi_model_destroy(model);
} catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
}
