#include "keys/assign.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>
#include <string_view>

#include "base/error.h"
#include "base/nearest_name.h"

namespace fumon {

namespace {

std::vector<std::string> quoted(const std::vector<KeyWord>& words) {
    std::vector<std::string> all;
    all.reserve(words.size());
    for (const KeyWord& known : words) all.push_back(fmt::format("\"{}\"", known.word));
    return all;
}

std::vector<std::string> plain(const std::vector<KeyWord>& words) {
    std::vector<std::string> all;
    all.reserve(words.size());
    for (const KeyWord& known : words) all.emplace_back(known.word);
    return all;
}

/// Whether a key takes a text as one of its words.
bool is_word_of(const std::vector<KeyWord>& words, std::string_view text) {
    return std::ranges::any_of(words, [&](const KeyWord& known) { return known.word == text; });
}

std::string number_text(const char* kind, const KeyNotes& notes) {
    std::string text = kind;
    if (const std::string range = notes.range.text(); range != "any") text += " " + range;
    if (!notes.unit.empty()) text += " (" + notes.unit + ")";
    return text;
}

/// As short as reads back to the same number: 0.1, not 0.10000000000000001.
std::string toml_text(const toml::node& value) {
    if (const auto* real = value.as_floating_point()) {
        const std::string text = fmt::format("{}", real->get());
        return text.find_first_not_of("-0123456789") == std::string::npos ? text + ".0" : text;
    }
    if (const auto* list = value.as_array()) {
        std::string text;
        for (const toml::node& item : *list) text += (text.empty() ? "" : ", ") + toml_text(item);
        return "[" + text + "]";
    }
    std::ostringstream text;
    text << toml::node_view<const toml::node>(value);
    return text.str();
}

std::string as_written(const toml::node& value) {
    std::string line = toml_text(value);
    constexpr std::size_t longest = 60;
    if (line.size() <= longest) return line;
    std::size_t end = longest;
    while ((static_cast<unsigned char>(line[end]) & 0xC0U) == 0x80U) --end;  // whole characters
    return line.substr(0, end) + "…";
}

[[noreturn]] void refuse(const Key& key, const toml::node& value, const Locate& locate) {
    throw InputError(fmt::format("{}: {} is {}; it takes {}", locate(value.source()), key.path,
                                 as_written(value), accepted_values(key)));
}

std::optional<double> real_of(const toml::node& value) {
    if (const auto* real = value.as_floating_point()) return real->get();
    if (const auto* whole = value.as_integer()) return static_cast<double>(whole->get());
    return std::nullopt;
}

std::optional<std::int64_t> truncated(const toml::node& value) {
    if (const auto* whole = value.as_integer()) return whole->get();
    if (const auto* real = value.as_floating_point()) {
        constexpr double exact_limit = 9007199254740992.0;  // 2^53
        if (std::abs(real->get()) <= exact_limit && std::trunc(real->get()) == real->get()) {
            return static_cast<std::int64_t>(real->get());
        }
    }
    return std::nullopt;
}

double checked_real(const Key& key, const toml::node& value, const Locate& locate) {
    const auto real = real_of(value);
    if (!real || !std::isfinite(*real) || !key.notes.range.contains(*real))
        refuse(key, value, locate);
    return *real;
}

std::int64_t checked_whole(const Key& key, const toml::node& value, const Locate& locate) {
    const auto whole = truncated(value);
    if (!whole || !key.notes.range.contains(static_cast<double>(*whole)))
        refuse(key, value, locate);
    return *whole;
}

/// The items of a list; a single number counts as a list of one.
std::vector<const toml::node*> items_of(const toml::node& value) {
    std::vector<const toml::node*> items;
    if (const auto* list = value.as_array()) {
        for (const toml::node& item : *list) items.push_back(&item);
    } else {
        items.push_back(&value);
    }
    return items;
}

struct Assign {
    const Key& key;
    const toml::node& value;
    const Locate& locate;

    void operator()(bool* target) const {
        const auto* truth = value.as_boolean();
        if (truth == nullptr) refuse(key, value, locate);
        *target = truth->get();
    }
    void operator()(std::int64_t* target) const { *target = checked_whole(key, value, locate); }
    void operator()(double* target) const { *target = checked_real(key, value, locate); }
    void operator()(std::string* target) const {
        // TOML has a type of its own for a time, which needs no quotes.
        *target = key.notes.unit == iso_time && value.is_date_time() ? as_written(value)
                                                                     : checked_text(value);
    }
    void operator()(const ChoiceTarget& target) const {
        const auto* text = value.as_string();
        if (text == nullptr) refuse(key, value, locate);
        if (target.choose(text->get())) return;
        const std::string nearest = nearest_name(text->get(), plain(target.words));
        throw InputError(
            fmt::format("{}: {} is \"{}\"; it takes one of {}{}", locate(value.source()), key.path,
                        text->get(), fmt::join(quoted(target.words), ", "),
                        nearest.empty() ? "" : fmt::format(" (did you mean \"{}\"?)", nearest)));
    }
    void operator()(const WordOrRealTarget& target) const {
        if (const auto* text = value.as_string()) {
            const bool is_form = std::ranges::any_of(
                target.forms, [&](const WordForm& form) { return form.matches(text->get()); });
            if (!is_form && !is_word_of(target.words, text->get())) refuse(key, value, locate);
            *target.value = {text->get(), 0.0};
            return;
        }
        *target.value = {"", checked_real(key, value, locate)};
    }
    void operator()(const RealListTarget& target) const {
        if (const auto* text = value.as_string(); text != nullptr && target.word != nullptr) {
            if (!is_word_of(target.words, text->get())) refuse(key, value, locate);
            *target.word = text->get();
            target.values->clear();
            return;
        }
        std::vector<double> reals;
        for (const toml::node* item : items_of(value))
            reals.push_back(checked_real(key, *item, locate));
        if (reals.size() < target.smallest || reals.size() > target.largest)
            refuse(key, value, locate);
        *target.values = reals;
        if (target.word != nullptr) target.word->clear();
    }
    void operator()(const IntegerListTarget& target) const {
        std::vector<std::int64_t> wholes;
        for (const toml::node* item : items_of(value))
            wholes.push_back(checked_whole(key, *item, locate));
        *target.values = wholes;
    }
    void operator()(const TextListTarget& target) const {
        std::vector<std::string> texts;
        for (const toml::node* item : items_of(value)) texts.push_back(checked_text(*item));
        *target.values = texts;
    }

    [[nodiscard]] std::string checked_text(const toml::node& item) const {
        const auto* text = item.as_string();
        if (text == nullptr) refuse(key, item, locate);
        return text->get();
    }
};

template <class Value>
Value& item_at(const Key& key, std::vector<Value>& values, std::size_t index,
               const toml::node& value, const Locate& locate) {
    if (index < values.size()) return values[index];
    throw InputError(fmt::format("{}: {} has no item {}; it has {} (counted from 0)",
                                 locate(value.source()), key.path, index, values.size()));
}

}  // namespace

std::string accepted_values(const Key& key) {
    struct Text {
        const Key& key;
        std::string operator()(const bool*) const { return "true or false"; }
        std::string operator()(const std::int64_t*) const {
            return number_text("a whole number", key.notes);
        }
        std::string operator()(const double*) const { return number_text("a number", key.notes); }
        std::string operator()(const std::string*) const { return "a text in quotes"; }
        std::string operator()(const ChoiceTarget& target) const {
            return fmt::format("one of {}", fmt::join(quoted(target.words), ", "));
        }
        std::string operator()(const WordOrRealTarget& target) const {
            std::vector<std::string> words = quoted(target.words);
            for (const WordForm& form : target.forms)
                words.push_back(fmt::format("\"{}\"", form.example));
            return fmt::format("{} or {}", fmt::join(words, ", "),
                               number_text("a number", key.notes));
        }
        std::string operator()(const RealListTarget& target) const {
            const std::string count =
                target.smallest == target.largest
                    ? fmt::format("{}", target.largest)
                    : fmt::format("{} to {}", target.smallest, target.largest);
            std::string list =
                number_text(fmt::format("a list of {} numbers", count).c_str(), key.notes);
            if (target.words.empty()) return list;
            return fmt::format("{} or {}", fmt::join(quoted(target.words), ", "), list);
        }
        std::string operator()(const IntegerListTarget&) const {
            return number_text("a list of whole numbers", key.notes);
        }
        std::string operator()(const TextListTarget&) const { return "a list of texts in quotes"; }
    };
    return std::visit(Text{key}, key.target);
}

void assign(const Key& key, const toml::node& value, const Locate& locate) {
    std::visit(Assign{key, value, locate}, key.target);
}

void assign_item(const Key& key, std::size_t index, const toml::node& value, const Locate& locate) {
    if (const auto* reals = std::get_if<RealListTarget>(&key.target)) {
        item_at(key, *reals->values, index, value, locate) = checked_real(key, value, locate);
    } else if (const auto* wholes = std::get_if<IntegerListTarget>(&key.target)) {
        item_at(key, *wholes->values, index, value, locate) = checked_whole(key, value, locate);
    } else if (const auto* texts = std::get_if<TextListTarget>(&key.target)) {
        item_at(key, *texts->values, index, value, locate) =
            Assign{key, value, locate}.checked_text(value);
    } else {
        throw InputError(fmt::format("{}: {} is not a list; it takes {}", locate(value.source()),
                                     key.path, accepted_values(key)));
    }
}

}  // namespace fumon
