#pragma once

#include <bit>
#include <cstdint>
#include <cstring>
#include <string>
#include <type_traits>

namespace fumon {

static_assert(std::endian::native == std::endian::little,
              "numbers are appended as they lie in memory");

/// Appends a number as four or eight bytes, the lowest first.
template <class Number>
void append_number(std::string& bytes, std::type_identity_t<Number> number) {
    char memory[sizeof(Number)];
    std::memcpy(memory, &number, sizeof(Number));
    bytes.append(memory, sizeof(Number));
}

}  // namespace fumon
