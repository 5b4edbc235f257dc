#pragma once

#include <cstddef>
#include <fstream>
#include <string>

namespace fumon::test {

/// The most bytes of address space that this process ever had, those it asked for and never touched
/// included.
inline std::size_t peak_memory() {
    std::ifstream status("/proc/self/status");
    for (std::string word; status >> word;) {
        std::size_t kibibytes = 0;
        if (word == "VmPeak:" && status >> kibibytes) return kibibytes << 10U;
    }
    return 0;
}

}  // namespace fumon::test
