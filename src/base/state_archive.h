#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace fumon {

/// Saves a state, for example to a checkpoint, or restores it. The owner of the state names its
/// values one after the other, and the same list serves both directions, so that what is saved and
/// what is restored cannot differ. Saving leaves the values as they are; restoring replaces them,
/// and throws InputError if a stored value has another name, kind or length.
class StateArchive {
  public:
    StateArchive() = default;
    StateArchive(const StateArchive&) = delete;
    StateArchive& operator=(const StateArchive&) = delete;
    virtual ~StateArchive() = default;

    virtual void values(std::string_view name, std::span<double> values) = 0;
    virtual void values(std::string_view name, std::span<std::int64_t> values) = 0;
    /// Lists come back with their length.
    virtual void list(std::string_view name, std::vector<double>& values) = 0;
    virtual void list(std::string_view name, std::vector<std::int64_t>& values) = 0;
    virtual void text(std::string_view name, std::string& text) = 0;

    /// Throws InputError "FILE: WHY; take …" for a restored value that is impossible.
    [[noreturn]] virtual void refuse(const std::string& why) const = 0;

    void value(std::string_view name, double& one) { values(name, std::span(&one, 1)); }
    void value(std::string_view name, std::int64_t& one) { values(name, std::span(&one, 1)); }
    void value(std::string_view name, bool& one) {
        std::int64_t number = one ? 1 : 0;
        value(name, number);
        one = number != 0;
    }
    /// A count: refuses one below 0.
    void count(std::string_view name, std::int64_t& one) {
        value(name, one);
        if (one < 0) refuse(std::string(name) + " is negative");
    }
};

}  // namespace fumon
