#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <string_view>
#include <type_traits>
#include <unordered_map>
#include <variant>
#include <vector>

#include "keys/key_role.h"
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

/// What a key's absence meant in earlier versions of fumon, and the word "auto" where it takes it.
struct EarlierDefault {
    std::string_view until{};  ///< the first version with today's default, "1.2.3"; empty for none
    std::string_view value{};  ///< as TOML
};

/// The unit of a text that is a date and time, with or without quotes.
inline constexpr const char* iso_time = "ISO 8601";

/// The unit, range and help of a key.
struct KeyNotes {
    std::string unit{};  ///< "sites", "m", "degrees"; empty for none
    Range range{};
    std::string help{};     ///< one line
    bool required = false;  ///< has no default: a scene must say
    EarlierDefault earlier{};
    EarlierDefault earliest{};  ///< of a default that has changed twice: the first one
};

/// A word that a key takes.
struct KeyWord {
    std::string_view word;
    std::string_view help;
    std::string_view unit{};  ///< of what it chooses, where that is a quantity
};

/// An enumerator, and the word by which scenes call it.
template <class Enumeration>
struct Choice {
    Enumeration enumerator;
    std::string_view word;
    std::string_view help;
    std::string_view unit{};  ///< of what it chooses, where that is a quantity
};

/// An enumeration bound by its words.
struct ChoiceTarget {
    std::function<int()> get;      ///< the value's number in its enumeration
    std::function<void(int)> set;  ///< by that number
    std::vector<KeyWord> words;
    std::vector<int> enumerators;  ///< the number that each word stands for

    /// The word of the present value. Throws std::logic_error for an enumerator without one.
    [[nodiscard]] std::string_view word() const;
    /// The unit of the present word; empty where it chooses no quantity.
    [[nodiscard]] std::string_view unit() const;
    /// Sets the value by its word; false where no enumerator has it.
    [[nodiscard]] bool choose(std::string_view word) const;
};

/// Words of one form that a key takes besides those with a name: "40 %".
struct WordForm {
    std::string_view example;
    std::string_view help;
    bool (*matches)(std::string_view);
};

struct WordOrRealTarget {
    WordOrReal* value;
    std::vector<KeyWord> words;
    std::vector<WordForm> forms{};
};

/// Reals, `smallest` to `largest` of them; or one of a few words in their place.
struct RealListTarget {
    std::vector<double>* values;
    std::size_t smallest;
    std::size_t largest;
    std::string* word = nullptr;  ///< none: no words are taken; empty: `values` count
    std::vector<KeyWord> words{};
};

struct IntegerListTarget {
    std::vector<std::int64_t>* values;
};

struct TextListTarget {
    std::vector<std::string>* values;
};

using KeyTarget = std::variant<bool*, std::int64_t*, double*, std::string*, ChoiceTarget,
                               WordOrRealTarget, RealListTarget, IntegerListTarget, TextListTarget>;

/// One scene key: its path ("camera.azimuth"), what is said of it, the value it is bound to, and
/// what that decides.
struct Key {
    std::string path;
    KeyNotes notes;
    KeyTarget target;
    KeyRole role = KeyRole::parameter;
};

/// A list of tables ([[overlay]]). The keys of its items stand in the key table with their number:
/// "overlay.0.corner".
struct TableList {
    std::string path;
    std::string help;  ///< one line: what an item is
    std::function<std::size_t()> size;
    std::function<void(std::size_t)> resize;
    KeyRole role = KeyRole::parameter;  ///< of its items' keys
};

/// A path as it stands in a scene's file, without the numbers of items: "figure.panel.0.curve" is
/// [[figure.panel.curve]].
std::string without_numbers(const std::string& path);

/// The most tables that a list may have, counted over all items that have one of its name.
inline constexpr std::size_t most_tables = 1000;

/// The one table from which scenes are read, checked, described and written back.
class KeyTable {
  public:
    /// Gives the keys and lists that follow a role. Those before the first call are parameters, as
    /// a model's keys all are.
    void role(KeyRole role) { role_ = role; }

    void boolean(std::string path, bool& value, KeyNotes notes);
    void integer(std::string path, std::int64_t& value, KeyNotes notes);
    void real(std::string path, double& value, KeyNotes notes);
    void text(std::string path, std::string& value, KeyNotes notes);
    void word_or_real(std::string path, WordOrReal& value, std::vector<KeyWord> words,
                      KeyNotes notes, std::vector<WordForm> forms = {});
    void real_list(std::string path, std::vector<double>& values, std::size_t smallest,
                   std::size_t largest, KeyNotes notes);
    void word_or_list(std::string path, std::string& word, std::vector<double>& values,
                      std::size_t smallest, std::size_t largest, std::vector<KeyWord> words,
                      KeyNotes notes);
    void text_list(std::string path, std::vector<std::string>& values, KeyNotes notes);
    void integer_list(std::string path, std::vector<std::int64_t>& values, KeyNotes notes);

    template <class Enumeration>
    void choice(std::string path, Enumeration& value,
                const std::vector<Choice<std::type_identity_t<Enumeration>>>& choices,
                KeyNotes notes) {
        ChoiceTarget target{[&value] { return static_cast<int>(value); },
                            [&value](int number) { value = static_cast<Enumeration>(number); },
                            {},
                            {}};
        for (const auto& [enumerator, word, help, unit] : choices) {
            target.words.push_back({word, help, unit});
            target.enumerators.push_back(static_cast<int>(enumerator));
        }
        add(std::move(path), std::move(notes), std::move(target));
    }

    /// A list of tables whose items list their keys with `list_item(item, path, table)`, where the
    /// path is the item's own: "overlay.0".
    template <class Item>
    void tables(const std::string& path, std::vector<Item>& items, std::string help,
                void (*list_item)(Item&, const std::string&, KeyTable&)) {
        lists_.push_back({path, std::move(help), [&items] { return items.size(); },
                          [&items](std::size_t size) { items.resize(size); }, role_});
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

    struct PathHash {
        using is_transparent = void;
        std::size_t operator()(std::string_view path) const {
            return std::hash<std::string_view>{}(path);
        }
    };

    std::vector<Key> keys_;
    std::unordered_map<std::string, std::size_t, PathHash, std::equal_to<>> places_;  ///< in keys_
    std::vector<TableList> lists_;
    KeyRole role_ = KeyRole::parameter;
};

}  // namespace fumon
