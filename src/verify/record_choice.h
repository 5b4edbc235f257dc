#pragma once

#include <string>

#include "picture/baseline.h"
#include "picture/verdict.h"

namespace fumon {

/// The record of a case that a picture drawn here is held against.
struct RecordChoice {
    std::string name;                        ///< see record_name()
    const BaselineRecord* record = nullptr;  ///< null where none is recorded
    RecordUse use;
};

/// That of the first of the case's environments that this one is; else, the environment not being
/// known, the common one; else that of the first environment that has one.
RecordChoice choose_record(const Baseline& baseline, const BaselineCase& one,
                           const RenderingEnvironment& here);

/// The name of the record that a picture drawn here replaces: the environment's where it has one or
/// is asked for (`of_this_environment`), else the common one. Throws InputError where it is asked
/// for and none of the case's environments is this one.
std::string record_to_write(const Baseline& baseline, const BaselineCase& one,
                            const RenderingEnvironment& here, bool of_this_environment);

}  // namespace fumon
