// The library libfumonbmi: what a program that couples models loads. It makes components of the
// Basic Model Interface and takes them back.

#include "bmi/component.h"

extern "C" {

// The names are those by which frameworks look for them.
// NOLINTBEGIN(readability-identifier-naming)

__attribute__((visibility("default"))) bmi::Bmi* bmi_model_create() {
    return new fumon::BmiComponent;
}

__attribute__((visibility("default"))) void bmi_model_destroy(bmi::Bmi* component) {
    delete component;
}

// NOLINTEND(readability-identifier-naming)
}
