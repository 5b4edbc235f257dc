#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>

#include "base/grid.h"

namespace fumon {

/// What the definitions of a fields file's variables share. All calls throw NetcdfFault where the
/// library fails; their caller holds the NetcdfLock.

void put_text(int file, int variable, const char* name, std::string_view text);
void put_number(int file, int variable, const char* name, double value);

/// A unit as udunits knows it: "1" for sites, grains and the like.
std::string unit_in_file(const std::string& unit);

/// Puts long_name and units; a unit that udunits does not know stands in brackets in the long name.
void describe(int file, int variable, const std::string& long_name, const std::string& unit);

/// Rows of a field's chunk: of about 1 MiB at most, as even as the number of rows allows.
int rows_of_chunk(const Grid& field);

/// Makes NaN a variable's _FillValue, and lets the library keep a single chunk of it in memory: a
/// chunk is written whole, once, and never read again, and the library's own cache of 16 MiB for
/// every variable would only take memory.
void fill_with_nan(int file, int variable, std::size_t chunk_values);

/// Has a variable's chunks shuffled and deflated.
void compress(int file, int variable);

/// Gives every chunk of a variable a checksum (Fletcher's, of 32 bits), which a reader of NetCDF-4
/// compares: bytes that have changed are an error, not values.
void protect(int file, int variable);

/// Defines a coordinate variable, float64, in one chunk with its checksum.
int define_coordinate(int file, const char* name, int dimension, std::size_t length);

/// Defines a float64 field over (time, row, column), compressed in chunks of rows_of_chunk.
int define_field(int file, const std::array<int, 3>& over, const std::string& name,
                 const Grid& field);

}  // namespace fumon
