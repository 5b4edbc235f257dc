#include "keys/keys.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "base/find_named.h"

namespace fumon {

namespace {

/// Plain digits where they are few, else a power of ten.
std::string limit_text(double limit) {
    constexpr double many_digits = 1e9;
    return std::abs(limit) < many_digits ? fmt::format("{}", limit) : fmt::format("{:.4g}", limit);
}

}  // namespace

std::string Range::text() const {
    const bool bounded_below = std::isfinite(low);
    const bool bounded_above = std::isfinite(high);
    if (bounded_below && bounded_above) {
        return low_open ? fmt::format("> {} and ≤ {}", limit_text(low), limit_text(high))
                        : fmt::format("{} … {}", limit_text(low), limit_text(high));
    }
    if (bounded_below) return fmt::format("{} {}", low_open ? ">" : "≥", limit_text(low));
    if (bounded_above) return fmt::format("≤ {}", limit_text(high));
    return "any";
}

std::string_view ChoiceTarget::word() const {
    const auto found = std::find(enumerators.begin(), enumerators.end(), get());
    if (found == enumerators.end()) throw std::logic_error("an enumerator has no word");
    return words[static_cast<std::size_t>(found - enumerators.begin())].word;
}

std::string_view ChoiceTarget::unit() const {
    const auto found = std::find(enumerators.begin(), enumerators.end(), get());
    if (found == enumerators.end()) throw std::logic_error("an enumerator has no word");
    return words[static_cast<std::size_t>(found - enumerators.begin())].unit;
}

bool ChoiceTarget::choose(std::string_view word) const {
    const auto found = std::find_if(words.begin(), words.end(),
                                    [&](const KeyWord& known) { return known.word == word; });
    if (found == words.end()) return false;
    set(enumerators[static_cast<std::size_t>(found - words.begin())]);
    return true;
}

std::string without_numbers(const std::string& path) {
    std::string name;
    for (std::size_t start = 0; start <= path.size();) {
        const std::size_t end = std::min(path.find('.', start), path.size());
        const std::string part = path.substr(start, end - start);
        if (part.find_first_not_of("0123456789") != std::string::npos)
            name += (name.empty() ? "" : ".") + part;
        start = end + 1;
    }
    return name;
}

void KeyTable::boolean(std::string path, bool& value, KeyNotes notes) {
    add(std::move(path), std::move(notes), &value);
}

void KeyTable::integer(std::string path, std::int64_t& value, KeyNotes notes) {
    add(std::move(path), std::move(notes), &value);
}

void KeyTable::real(std::string path, double& value, KeyNotes notes) {
    add(std::move(path), std::move(notes), &value);
}

void KeyTable::text(std::string path, std::string& value, KeyNotes notes) {
    add(std::move(path), std::move(notes), &value);
}

void KeyTable::word_or_real(std::string path, WordOrReal& value, std::vector<KeyWord> words,
                            KeyNotes notes, std::vector<WordForm> forms) {
    add(std::move(path), std::move(notes),
        WordOrRealTarget{&value, std::move(words), std::move(forms)});
}

void KeyTable::real_list(std::string path, std::vector<double>& values, std::size_t smallest,
                         std::size_t largest, KeyNotes notes) {
    add(std::move(path), std::move(notes), RealListTarget{&values, smallest, largest});
}

void KeyTable::word_or_list(std::string path, std::string& word, std::vector<double>& values,
                            std::size_t smallest, std::size_t largest, std::vector<KeyWord> words,
                            KeyNotes notes) {
    add(std::move(path), std::move(notes),
        RealListTarget{&values, smallest, largest, &word, std::move(words)});
}

void KeyTable::integer_list(std::string path, std::vector<std::int64_t>& values, KeyNotes notes) {
    add(std::move(path), std::move(notes), IntegerListTarget{&values});
}

void KeyTable::text_list(std::string path, std::vector<std::string>& values, KeyNotes notes) {
    add(std::move(path), std::move(notes), TextListTarget{&values});
}

const Key* KeyTable::find(std::string_view path) const {
    const auto place = places_.find(path);
    return place == places_.end() ? nullptr : &keys_[place->second];
}

const TableList* KeyTable::find_list(std::string_view path) const {
    return find_by(lists_, &TableList::path, path);
}

void KeyTable::add(std::string path, KeyNotes notes, KeyTarget target) {
    places_.emplace(path, keys_.size());
    keys_.push_back({std::move(path), std::move(notes), std::move(target), role_});
}

}  // namespace fumon
