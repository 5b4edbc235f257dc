#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/grid.h"

namespace fumon {

/// One field of a series, packed. Its 16-bit numbers q are predicted, and the remainders r, modulo
/// 65536, are stored: as (r << 1) ^ (r >> 15), all high bytes and then all low bytes, deflated
/// (RFC 1950).
struct PackedField {
    bool over_previous = false;  ///< whether q is the difference to the field before it
    /// What is predicted from the neighbours west (w), south (s) and south-west (d), 0 beyond the
    /// edges: 0 nothing, 1 w + s − d, 2 half of w + s, rounded down.
    int predictor = 0;
    std::string bytes;
};

/// A series of fields of one size: value = low + step · q.
struct PackedFields {
    double low = 0.0;
    double step = 1.0;
    std::vector<PackedField> fields;
};

/// Packs values in steps of the 65535th part of their range, or, where that takes more than
/// `most_bytes` a value, in coarser ones, of at least a 4095th part. All fields have one size.
PackedFields packed_fields(const std::vector<Field<float>>& fields, double most_bytes);

/// The values of a series again, each within half a step. Throws Error where it is damaged.
std::vector<Field<float>> unpacked_fields(const PackedFields& packed, int nx, int ny);

}  // namespace fumon
