#pragma once

#include <gtest/gtest.h>

#include <limits>
#include <string>

#include "base/snapshot.h"

namespace fumon::test {

/// One of a snapshot's numbers by its name. Where it has none the test fails, and it is NaN.
inline double number(const Snapshot& snapshot, const std::string& name) {
    for (const SnapshotNumber& one : snapshot.numbers) {
        if (one.name == name) return one.value;
    }
    ADD_FAILURE() << "there is no number " << name;
    return std::numeric_limits<double>::quiet_NaN();
}

}  // namespace fumon::test
