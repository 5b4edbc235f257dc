#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "keys/word_or_real.h"

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

/// A list of tables ([[overlay]]). The keys of its items stand in the key table with their number:
/// "overlay.0.corner".
struct TableList {
    std::string path;
    std::string help;  ///< one line: what an item is
    std::function<std::size_t()> size;
    std::function<void(std::size_t)> resize;
};

/// A path as it stands in a scene's file, without the numbers of items: "figure.panel.0.curve" is
/// [[figure.panel.curve]].
std::string without_numbers(const std::string& path);

/// The most tables that a list may have.
inline constexpr std::size_t most_tables = 1000;

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

    /// A list of tables whose items list their keys with `list_item(item, path, table)`, where the
    /// path is the item's own: "overlay.0".
    template <class Item>
    void tables(const std::string& path, std::vector<Item>& items, std::string help,
                void (*list_item)(Item&, const std::string&, KeyTable&)) {
        lists_.push_back({path, std::move(help), [&items] { return items.size(); },
                          [&items](std::size_t size) { items.resize(size); }});
        for (std::size_t index = 0; index < items.size(); ++index)
            list_item(items[index], path + "." + std::to_string(index), *this);
    }

    [[nodiscard]] const std::vector<TableList>& lists() const& { return lists_; }
    const std::vector<TableList>& lists() && = delete;
    [[nodiscard]] const TableList* find_list(std::string_view path) const;

    [[nodiscard]] const std::vector<Key>& keys() const& { return keys_; }
    const std::vector<Key>& keys() && = delete;  // a temporary's keys would be gone
    [[nodiscard]] const Key* find(std::string_view path) const;

  private:
    void add(std::string path, KeyNotes notes, KeyTarget target);

    std::vector<Key> keys_;
    std::vector<TableList> lists_;
};

}  // namespace fumon
