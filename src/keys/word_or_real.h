#pragma once

#include <string>

namespace fumon {

/// A key that takes either a number or one of a few words ("auto", "fit", "mask").
struct WordOrReal {
    std::string word;  ///< empty: `value` counts
    double value = 0.0;
    WordOrReal& operator=(double number) {
        word.clear();
        value = number;
        return *this;
    }
    [[nodiscard]] bool is_word() const { return !word.empty(); }
    friend bool operator==(const WordOrReal&, const WordOrReal&) = default;
};

}  // namespace fumon
