#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "keys/keys.h"
#include "picture/fingerprint.h"

namespace fumon {

/// A fingerprint as it is written, in TOML that a person can read and compare line by line:
///
///     size = [1920, 1080]             # width and height, pixels
///     pixels = "5e0d…"                # SHA-256, as run.json has it
///     dhash = "00e1f3…"               # 64 bits, hexadecimal
///     red = [                         # of the thumbnail: 18 rows from the top, each with its 32
///       "181.2 181.9 …",              # levels 0.0 … 255.0 from the left
///       …
///     ]                               # and green and blue alike
struct FingerprintText {
    std::vector<std::int64_t> size;
    std::string pixels;
    std::string dhash;
    std::vector<std::string> red;
    std::vector<std::string> green;
    std::vector<std::string> blue;

    /// Lists its keys under a prefix ("recorded.map."), bound to it.
    void list_keys(const std::string& prefix, KeyTable& table);

    /// What the text says. Throws KeyError naming the key without prefix.
    [[nodiscard]] Fingerprint fingerprint() const;
};

/// The lines above, each ended, without comments. The same fingerprint gives the same bytes.
std::string fingerprint_text(const Fingerprint& fingerprint);

/// 16 hexadecimal digits.
std::string dhash_text(std::uint64_t hash);

}  // namespace fumon
