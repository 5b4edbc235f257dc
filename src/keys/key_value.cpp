#include "keys/key_value.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace fumon {

namespace {

/// Shortest digits that read back the same, always recognisable as a real number.
std::string real_text(double value) {
    std::string text = fmt::format("{}", value);
    if (text.find_first_of(".en") == std::string::npos) text += ".0";
    return text;
}

std::string string_text(const std::string& value) {
    std::string text = "\"";
    for (const char letter : value) {
        const auto code = static_cast<unsigned char>(letter);
        if (letter == '"' || letter == '\\') {
            text += '\\';
            text += letter;
        } else if (code < 0x20 || code == 0x7f) {
            text += fmt::format("\\u{:04X}", code);
        } else {
            text += letter;
        }
    }
    return text + '"';
}

struct ValueText {
    std::string operator()(const bool* value) const { return *value ? "true" : "false"; }
    std::string operator()(const std::int64_t* value) const { return fmt::format("{}", *value); }
    std::string operator()(const double* value) const { return real_text(*value); }
    std::string operator()(const std::string* value) const { return string_text(*value); }
    std::string operator()(const ChoiceTarget& target) const {
        return fmt::format("\"{}\"", target.word());
    }
    std::string operator()(const WordOrRealTarget& target) const {
        return target.value->is_word() ? string_text(target.value->word)
                                       : real_text(target.value->value);
    }
    std::string operator()(const RealListTarget& target) const {
        if (target.word != nullptr && !target.word->empty()) return string_text(*target.word);
        std::vector<std::string> items;
        for (const double value : *target.values) items.push_back(real_text(value));
        return fmt::format("[{}]", fmt::join(items, ", "));
    }
    std::string operator()(const IntegerListTarget& target) const {
        return fmt::format("[{}]", fmt::join(*target.values, ", "));
    }
    std::string operator()(const TextListTarget& target) const {
        std::vector<std::string> items;
        for (const std::string& value : *target.values) items.push_back(string_text(value));
        return fmt::format("[{}]", fmt::join(items, ", "));
    }
};

/// Each target's value from one of the same type.
struct CopyValue {
    const KeyTarget& from;

    template <class Value>
    void operator()(Value* value) const {
        *value = *std::get<Value*>(from);
    }
    void operator()(const ChoiceTarget& target) const {
        target.set(std::get<ChoiceTarget>(from).get());
    }
    void operator()(const WordOrRealTarget& target) const {
        *target.value = *std::get<WordOrRealTarget>(from).value;
    }
    void operator()(const RealListTarget& target) const {
        const auto& other = std::get<RealListTarget>(from);
        *target.values = *other.values;
        if (target.word != nullptr) *target.word = *other.word;
    }
    template <class ListTarget>
    void operator()(const ListTarget& target) const {
        *target.values = *std::get<ListTarget>(from).values;
    }
};

}  // namespace

std::string value_text(const Key& key) {
    return std::visit(ValueText{}, key.target);
}

void copy_value(const Key& from, const Key& to) {
    std::visit(CopyValue{from.target}, to.target);
}

}  // namespace fumon
