#pragma once

#include <string>
#include <vector>

#include "base/error.h"

namespace fumon {

/// Gathers the faults of a scene, so that all of them are told at once.
class Faults {
  public:
    /// `source` names the scene in messages.
    explicit Faults(std::string source) : source_(std::move(source)) {}

    /// Keeps a fault, once; reports where there are enough.
    void add(const InputError& fault);

    /// Runs work() and keeps the InputError that it throws; whether it threw none.
    template <class Work>
    bool attempt(const Work& work) {
        try {
            work();
            return true;
        } catch (const InputError& fault) {
            add(fault);
            return false;
        }
    }

    [[nodiscard]] bool none() const { return lines_.empty(); }

    /// Throws an InputError with a line for each fault, where there are any: those of the scene's
    /// file in its order, then those of the command line; the first 20, and how many more there
    /// are.
    void report() const;

    /// Of how many faults it is told at once, without a look for more.
    static constexpr std::size_t enough = 100;

  private:
    std::string source_;
    std::vector<std::string> lines_;
};

}  // namespace fumon
