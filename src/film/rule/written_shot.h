#pragma once

#include <string>
#include <utility>
#include <vector>

namespace fumon {

/// A number as a film file has it: no more digits than are seen.
std::string written_number(double value, int digits = 0);

/// A text as a value of TOML, without its control characters.
std::string quoted_text(const std::string& text);

/// A text without placeholders, as films have it.
std::string without_placeholders(const std::string& text);

/// A [[shot]] as it is written: keys in turn, each with its value.
struct WrittenShot {
    std::string comment{};
    std::vector<std::pair<std::string, std::string>> keys{};

    /// Puts a key at the end, or another value in its place.
    void set(const std::string& key, const std::string& value);
    void set(const std::string& key, double value, int digits = 0);

    [[nodiscard]] std::string text() const;
};

}  // namespace fumon
