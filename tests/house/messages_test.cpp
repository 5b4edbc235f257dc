// A message is read by somebody in trouble: words that were this project's alone, or that English
// no longer has, are listed with what to write instead.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace fs = std::filesystem;

namespace {

struct Phrase {
    std::string_view pattern;
    std::string_view plain;
};

constexpr std::array phrases{
    Phrase{R"(\b(told|tells?|telling)\b)", "names, gives, lists"},
    Phrase{R"(\bdoubts?\b)", "implausible"},
    Phrase{R"(\bknows? no(thing)?\b)", "has no"},
    Phrase{R"(\b(go|goes|going) on (with|from)\b)", "continue, resume"},
    Phrase{R"(\blies? nowhere\b)", "has no map coordinates"},
    Phrase{R"(\b(is|was|are) (there already|not there)\b)",
           "already exists, does not exist, is missing"},
    Phrase{R"(\bnothing says\b)", "the thing that is missing"},
    Phrase{R"(\b(can|could) be had\b)", "is available"},
    Phrase{R"(\bgive(s|n)? up\b)", "clear, cancel"},
    Phrase{R"(\blives? in\b)", "works in, is in"},
    Phrase{R"(\b(a|the|this|that) stretch\b)", "segment"},
    Phrase{R"(\bbring it back\b)", "restore it"},
    Phrase{R"(\bno ground has\b)", "impossible, implausible"},
    Phrase{R"(\bsaid to be\b)", "is given as"},
    Phrase{R"(\bbear(s|ing)? a\b)", "has a"},
    Phrase{R"(\bno middle of\b)", "no centre of"},
    Phrase{R"(^(.*[^e] |: |)(is|are) no [a-z])", "is not a"},  // "there is no" is English
};

struct Message {
    std::string text;
    int line = 0;
};

/// The texts of a C++ source's statements that throw, refuse, fail or warn: of each statement the
/// literals, those that stand side by side as one.
std::vector<Message> messages_of(const std::string& source) {
    static const std::regex raises(
        R"(\b(throw|fail|refuse\w*|\w*Error|\w*warnings?|report|note|fault|faults)\b)");
    std::vector<Message> found;
    std::vector<Message> literals;
    std::string code;  // of the statement, without literals and comments
    int line = 1;
    bool beside = false;  // no code since the last literal
    const auto end_statement = [&] {
        if (!literals.empty() && std::regex_search(code, raises))
            found.insert(found.end(), literals.begin(), literals.end());
        literals.clear();
        code.clear();
        beside = false;
    };
    for (std::size_t i = 0; i < source.size(); ++i) {
        const char c = source[i];
        if (source.compare(i, 2, "//") == 0) {
            i = std::min(source.find('\n', i), source.size()) - 1;
        } else if (source.compare(i, 2, "R\"") == 0) {
            const std::size_t open = source.find('(', i);
            const std::string close = ")" + source.substr(i + 2, open - i - 2) + "\"";
            const std::size_t end = std::min(source.find(close, open), source.size());
            line += static_cast<int>(std::count(source.begin() + static_cast<std::ptrdiff_t>(i),
                                                source.begin() + static_cast<std::ptrdiff_t>(end),
                                                '\n'));
            i = end + close.size() - 1;
        } else if (c == '\'' &&
                   (i == 0 || std::isalnum(static_cast<unsigned char>(source[i - 1])) == 0)) {
            i += source[i + 1] == '\\' ? std::size_t{3} : std::size_t{2};
        } else if (c == '"') {
            if (!beside) literals.push_back({{}, line});
            for (++i; i < source.size() && source[i] != '"'; ++i) {
                if (source[i] == '\\') literals.back().text += source[i++];
                literals.back().text += source[i];
            }
            beside = true;
        } else if (c == ';' || c == '{' || c == '}') {
            end_statement();
        } else {
            if (c == '\n') ++line;
            if (c != ' ' && c != '\n') beside = false;
            code += c;
        }
    }
    end_statement();
    return found;
}

std::string first_phrase_of(const std::string& text) {
    static const std::vector<std::pair<std::regex, std::string>> patterns = [] {
        std::vector<std::pair<std::regex, std::string>> made;
        for (const Phrase& phrase : phrases)
            made.emplace_back(std::regex(std::string(phrase.pattern)), std::string(phrase.plain));
        return made;
    }();
    std::smatch match;
    for (const auto& [pattern, plain] : patterns) {
        if (std::regex_search(text, match, pattern))
            return "\"" + match.str() + "\"; write: " + plain;
    }
    return {};
}

TEST(MessagesTest, AreFoundInStatementsThatRaiseThem) {
    const std::vector<Message> found = messages_of(
        "int f() { g(\"no message\"); }\n// throw \"no\"\nif (x)\n throw Error(\"a \" "
        "\"b\"\n\"c\",\n"
        "'\"', \"d\");\nrefuse(key, \"e;{}\");\n");
    std::string texts;
    for (const Message& message : found)
        texts += message.text + ":" + std::to_string(message.line) + " ";
    EXPECT_EQ(texts, "a bc:4 d:6 e;{}:7 ");
}

TEST(MessagesTest, HaveWhatIsWrittenInsteadOfOldPhrases) {
    EXPECT_EQ(first_phrase_of("{}: is no folder"), "\"{}: is no f\"; write: is not a");
    EXPECT_EQ(first_phrase_of("is no section"), "\"is no s\"; write: is not a");
    EXPECT_EQ(first_phrase_of("there is no film \\\"{}\\\""), "");
    EXPECT_EQ(first_phrase_of("it is there already"),
              "\"is there already\"; write: already exists, does not exist, is missing");
}

TEST(MessagesTest, ArePlainEnglish) {
    std::size_t messages = 0;
    for (const auto& entry : fs::recursive_directory_iterator(FUMON_SOURCES_FOLDER)) {
        const std::string name = entry.path().filename().string();
        if (!name.ends_with(".h") && !name.ends_with(".cpp")) continue;
        std::ifstream file(entry.path());
        std::stringstream text;
        text << file.rdbuf();
        for (const Message& message : messages_of(text.str())) {
            ++messages;
            EXPECT_EQ(first_phrase_of(message.text), "")
                << entry.path().string() << ':' << message.line << ": " << message.text;
        }
    }
    EXPECT_GT(messages, 800U);
}

}  // namespace
