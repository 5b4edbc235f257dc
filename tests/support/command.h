#pragma once

#include <array>
#include <cstdio>
#include <string>

namespace fumon::test {

/// The exit status and all words of a command line.
struct Spoken {
    int status = -1;
    std::string words;
};

inline Spoken run_command(const std::string& command) {
    Spoken spoken;
    FILE* pipe = popen((command + " 2>&1").c_str(), "r");
    if (pipe == nullptr) return spoken;
    std::array<char, 4096> block{};
    while (const std::size_t got = fread(block.data(), 1, block.size(), pipe))
        spoken.words.append(block.data(), got);
    spoken.status = pclose(pipe);
    return spoken;
}

}  // namespace fumon::test
