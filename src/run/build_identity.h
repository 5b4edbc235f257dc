#pragma once

#include <string>

namespace fumon {

/// Which program a build is. The same sources have the same identity wherever and whenever they are
/// built; src/build_identity.cmake computes it.
struct BuildIdentity {
    std::string sources;  ///< SHA-256 of all that decides what is computed and drawn, hexadecimal
    std::string tools;    ///< compiler, flags and the libraries that are compiled in, in words
};

const BuildIdentity& this_build();

/// The first digits of a build's sources, for messages.
inline std::string short_sources(const BuildIdentity& build) {
    constexpr std::size_t digits = 12;
    return build.sources.substr(0, digits);
}

}  // namespace fumon
