#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "scene/scene.h"

namespace fumon {

/// The allowed numbers of a key. Both ends belong to it unless said.
struct Range {
    double low = -std::numeric_limits<double>::infinity();
    double high = std::numeric_limits<double>::infinity();
    bool low_open = false;  ///< the low end itself is not allowed
    [[nodiscard]] bool contains(double value) const {
        return (low_open ? value > low : value >= low) && value <= high;
    }
    /// "> 0", "0 … 90", "any".
    [[nodiscard]] std::string text() const;
};

/// What a user needs to know of a key besides its type.
struct KeyNotes {
    std::string unit{};  ///< "sites", "m", "degrees"; empty for none
    Range range{};
    std::string help{};  ///< one line
};

struct ChoiceName {
    std::string_view name;
    std::string_view help;
};

/// An enumeration bound by its names; the n-th name belongs to the n-th enumerator.
struct ChoiceTarget {
    std::function<int()> get;
    std::function<void(int)> set;
    std::vector<ChoiceName> names;
};

struct WordOrRealTarget {
    WordOrReal* value;
    std::vector<ChoiceName> words;
};

/// Reals, `smallest` to `largest` of them.
struct RealListTarget {
    std::vector<double>* values;
    std::size_t smallest;
    std::size_t largest;
};

struct IntegerListTarget {
    std::vector<std::int64_t>* values;
};

struct TextListTarget {
    std::vector<std::string>* values;
};

using KeyTarget = std::variant<bool*, std::int64_t*, double*, std::string*, ChoiceTarget,
                               WordOrRealTarget, RealListTarget, IntegerListTarget, TextListTarget>;

/// One scene key: its path ("camera.azimuth"), what is said of it, and the value it is bound to.
struct Key {
    std::string path;
    KeyNotes notes;
    KeyTarget target;
};

/// The one table from which scenes are read, checked, described and written back.
class KeyTable {
  public:
    void boolean(std::string path, bool& value, KeyNotes notes);
    void integer(std::string path, std::int64_t& value, KeyNotes notes);
    void real(std::string path, double& value, KeyNotes notes);
    void text(std::string path, std::string& value, KeyNotes notes);
    void word_or_real(std::string path, WordOrReal& value, std::vector<ChoiceName> words,
                      KeyNotes notes);
    void real_list(std::string path, std::vector<double>& values, std::size_t smallest,
                   std::size_t largest, KeyNotes notes);
    void text_list(std::string path, std::vector<std::string>& values, KeyNotes notes);
    void integer_list(std::string path, std::vector<std::int64_t>& values, KeyNotes notes);

    template <class Enumeration>
    void choice(std::string path, Enumeration& value, std::vector<ChoiceName> names,
                KeyNotes notes) {
        add(std::move(path), std::move(notes),
            ChoiceTarget{[&value] { return static_cast<int>(value); },
                         [&value](int index) { value = static_cast<Enumeration>(index); },
                         std::move(names)});
    }

    [[nodiscard]] const std::vector<Key>& keys() const& { return keys_; }
    const std::vector<Key>& keys() && = delete;  // a temporary's keys would be gone
    [[nodiscard]] const Key* find(std::string_view path) const;

  private:
    void add(std::string path, KeyNotes notes, KeyTarget target);

    std::vector<Key> keys_;
};

/// Every key of the scene, bound to it: the common ones, then those of its model.
KeyTable scene_keys(Scene& scene);

}  // namespace fumon
