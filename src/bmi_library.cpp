// The library libfumonbmi: what a program that couples models loads. It makes components of the
// Basic Model Interface and takes them back.

#include "bmi/bmi_library.h"

#include <mutex>

#include "base/data_files.h"
#include "base/platform.h"
#include "bmi/component.h"

extern "C" {

bmi::Bmi* bmi_model_create() {
    static std::once_flag once;
    std::call_once(once, [] {
        fumon::add_data_of_library(
            fumon::platform::file_with(reinterpret_cast<const void*>(&bmi_model_create)));
    });
    return new fumon::BmiComponent;
}

void bmi_model_destroy(bmi::Bmi* component) {
    delete component;
}
}
