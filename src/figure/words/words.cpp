#include "figure/words/words.h"

#include <fmt/ranges.h>
#include <toml++/toml.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <utility>

#include "base/data_files.h"
#include "base/error.h"
#include "base/nearest_name.h"
#include "base/quantity_text.h"
#include "figure/words/word_check.h"
#include "keys/toml_text.h"

namespace fumon {

namespace {

constexpr const char* folder = "assets/words";

std::shared_ptr<const WordTable>& spoken() {
    thread_local std::shared_ptr<const WordTable> table;
    return table;
}

std::string place_of(const std::string& source, const toml::source_region& region) {
    return fmt::format("{}:{}:{}: ", source, region.begin.line, region.begin.column);
}

/// "{}" and "{time}" of a phrase, in order.
std::vector<std::string> places_in(std::string_view phrase) {
    std::vector<std::string> places;
    for (std::size_t at = phrase.find('{'); at != std::string_view::npos;
         at = phrase.find('{', at + 1))
        places.emplace_back(phrase.substr(at, phrase.find('}', at) + 1 - at));
    return places;
}

/// Whether a phrase has the places of the English one, as often, named ones in any order.
bool same_places(std::string_view own, std::string_view english) {
    std::vector<std::string> a = places_in(own);
    std::vector<std::string> b = places_in(english);
    std::ranges::sort(a);
    std::ranges::sort(b);
    const auto braces = [](std::string_view text) {
        return std::ranges::count(text, '{') == std::ranges::count(text, '}');
    };
    return a == b && braces(own);
}

const std::string* found(const WordTable::Words& words, std::string_view english) {
    const auto entry = words.find(english);
    return entry == words.end() || entry->second.empty() ? nullptr : &entry->second;
}

}  // namespace

void check_word(const std::string& english, std::string_view own, const std::string& place) {
    if (std::ranges::find(english_words, english) == english_words.end()) {
        const std::vector<std::string> known(english_words.begin(), english_words.end());
        const std::string nearest = nearest_name(english, known);
        throw InputError(fmt::format("{}fumon does not write \"{}\"{}", place, english,
                                     nearest.empty() ? "" : "; did you mean \"" + nearest + "\"?"));
    }
    if (!same_places(own, english)) {
        throw InputError(fmt::format("{}\"{}\" must have the placeholders of \"{}\": {}", place,
                                     own, english, fmt::join(places_in(english), " ")));
    }
}

WordTable parse_word_table(std::string_view text, const std::string& source) {
    const toml::table parsed =
        parse_toml(text, source, "a table of words has [words], [units] and [names]");
    WordTable table;
    const std::map<std::string_view, WordTable::Words*> sections{
        {"words", &table.words}, {"units", &table.units}, {"names", &table.names}};
    for (const auto& [section, node] : parsed) {
        const auto place = sections.find(section.str());
        const toml::table* entries = node.as_table();
        if (place == sections.end() || entries == nullptr) {
            throw InputError(fmt::format("{}a table of words has [words], [units] and [names]",
                                         place_of(source, node.source())));
        }
        for (const auto& [english, value] : *entries) {
            const auto own = value.value<std::string>();
            if (!own)
                throw InputError(place_of(source, value.source()) + "a word is a text in quotes");
            if (place->first == "words")
                check_word(std::string(english.str()), *own, place_of(source, value.source()));
            place->second->insert_or_assign(std::string(english.str()), *own);
        }
    }
    return table;
}

std::vector<std::string> word_languages() {
    std::vector<std::string> languages{"en"};
    for (const auto& file : std::filesystem::directory_iterator(data_file(folder))) {
        if (file.path().extension() == ".toml") languages.push_back(file.path().stem().string());
    }
    std::ranges::sort(languages);
    return languages;
}

WordTable words_of_language(const std::string& language) {
    if (language == "en") return {};
    const std::vector<std::string> known = word_languages();
    if (std::ranges::find(known, language) == known.end()) {
        throw InputError(fmt::format("fumon has no translation \"{}\"; it has {}", language,
                                     fmt::join(known, ", ")));
    }
    const std::filesystem::path file = data_file(fmt::format("{}/{}.toml", folder, language));
    std::ifstream stream(file);
    const std::string text((std::istreambuf_iterator<char>(stream)), {});
    return parse_word_table(text, file.string());
}

WordTable with_words(WordTable table, const WordTable& others) {
    for (const auto part : {&WordTable::words, &WordTable::units, &WordTable::names}) {
        for (const auto& [english, own] : others.*part)
            (table.*part).insert_or_assign(english, own);
    }
    return table;
}

LanguageScope::LanguageScope(std::shared_ptr<const WordTable> table)
    : before_(std::exchange(spoken(), std::move(table))) {}

LanguageScope::~LanguageScope() {
    spoken() = std::move(before_);
}

std::string word(Word english) {
    const auto& table = spoken();
    const std::string* own = table ? found(table->words, english.english()) : nullptr;
    return own != nullptr ? *own : std::string(english.english());
}

std::string unit_word(const std::string& unit) {
    const auto& table = spoken();
    const std::string* own = table ? found(table->units, unit) : nullptr;
    return own != nullptr ? *own : unit;
}

std::string name_in_words(const std::string& name) {
    std::string plain = in_words(name);
    const auto& table = spoken();
    const std::string* own = table ? found(table->names, plain) : nullptr;
    return own != nullptr ? *own : plain;
}

std::string quantity_in_words(const std::string& name, const std::string& unit) {
    std::string english = quantity_text(name, unit);
    if (!spoken()) return english;
    const std::string plain = unit.empty() ? english : english.substr(0, english.rfind(" ("));
    const std::string own = name_in_words(plain);
    return unit.empty() ? own : fmt::format("{} ({})", own, unit_word(unit));
}

std::string labelled(Word quantity, const std::string& unit) {
    return unit.empty() ? word(quantity) : fmt::format("{} ({})", word(quantity), unit_word(unit));
}

}  // namespace fumon
