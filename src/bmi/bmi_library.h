#pragma once

namespace bmi {
class Bmi;
}

extern "C" {

// The names are those by which frameworks look for them.
// NOLINTBEGIN(readability-identifier-naming)

/// A new component of libfumonbmi, for bmi_model_destroy() to take back.
__attribute__((visibility("default"))) bmi::Bmi* bmi_model_create();

__attribute__((visibility("default"))) void bmi_model_destroy(bmi::Bmi* component);

// NOLINTEND(readability-identifier-naming)
}
