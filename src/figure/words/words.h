#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "figure/words/english_words.h"

namespace fumon {

/// A word or phrase of english_words; another one does not compile.
class Word {
  public:
    consteval Word(const char* english)  // NOLINT(google-explicit-constructor)
        : english_(english) {
        if (std::ranges::find(english_words, english_) == english_words.end())
            throw "english_words.h lacks this word";  // NOLINT(hicpp-exception-baseclass)
    }
    [[nodiscard]] std::string_view english() const { return english_; }

  private:
    std::string_view english_;
};

/// What stands for fumon's English in another language.
struct WordTable {
    using Words = std::map<std::string, std::string, std::less<>>;
    Words words;  ///< of english_words
    Words units;  ///< "yr"
    Words names;  ///< of columns and keys, in words: "standard deviation"
};

/// A table from the text of a file with sections [words], [units] and [names]; `source` names it in
/// messages. Throws InputError "file:line:column: …" for what is no TOML, another section, a word
/// that fumon does not write, or a phrase whose places for numbers differ.
WordTable parse_word_table(std::string_view text, const std::string& source);

/// The table of a language that fumon has, assets/words/LANGUAGE.toml; of "en", an empty one.
/// Throws InputError for another one.
WordTable words_of_language(const std::string& language);

/// The languages there are, sorted, with "en".
std::vector<std::string> word_languages();

/// That table with the entries of others in the place of its own.
WordTable with_words(WordTable table, const WordTable& others);

/// As long as this lives, what this thread writes is in the words of a table, and then in those of
/// before. Null: English.
class LanguageScope {
  public:
    explicit LanguageScope(std::shared_ptr<const WordTable> table);
    ~LanguageScope();
    LanguageScope(const LanguageScope&) = delete;
    LanguageScope& operator=(const LanguageScope&) = delete;

  private:
    std::shared_ptr<const WordTable> before_;
};

/// A word in the language of this thread; in English where its table lacks it.
std::string word(Word english);

/// A phrase with its places filled.
template <class... Parts>
std::string phrase(Word english, const Parts&... parts) {
    return fmt::format(fmt::runtime(word(english)), parts...);
}

/// The same of a unit ("yr"), which stands as it is where the table lacks it.
std::string unit_word(const std::string& unit);

/// The same of a column's or key's name ("standard_deviation", in words).
std::string name_in_words(const std::string& name);

/// As quantity_text(), of name and unit in these words.
std::string quantity_in_words(const std::string& name, const std::string& unit);

/// "height (m)"; the word alone without a unit.
std::string labelled(Word quantity, const std::string& unit);

}  // namespace fumon
