// Exponentials, sines and the like are fumon's own (base/elementary.h): those of the system's
// library differ in the last bits from one processor to another.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <regex>
#include <string>

namespace fs = std::filesystem;

namespace {

/// Without comments and texts.
std::string code_of(const std::string& line) {
    static const std::regex texts("\"(?:[^\"\\\\]|\\\\.)*\"");
    static const std::regex comment("//.*");
    return std::regex_replace(std::regex_replace(line, texts, "\"\""), comment, "");
}

bool calls_the_system(const std::string& code) {
    static const std::regex calls(
        "(^|[^:_A-Za-z0-9.>])(std::|::)?"
        "(exp|exp2|expm1|log|log2|log10|log1p|pow|cbrt|hypot|sin|cos|tan|asin|acos|atan|atan2|sinh|"
        "cosh|tanh|erf|tgamma|lgamma)f?\\(");
    return std::regex_search(code, calls);
}

TEST(FunctionsTest, AreOurOwnWhereTheSystemsDifferBetweenProcessors) {
    EXPECT_TRUE(calls_the_system("const double left = std::exp(-age);"));
    EXPECT_TRUE(calls_the_system("return 2.0 * cos(angle);"));
    EXPECT_FALSE(calls_the_system(code_of("return elementary::exp(x);  // exp(x) of the grid")));
    EXPECT_FALSE(calls_the_system(code_of("fail(\"log(0) is none\");")));
    int files = 0;
    for (const auto& entry : fs::recursive_directory_iterator(FUMON_SOURCES_FOLDER)) {
        const std::string name = entry.path().filename().string();
        if (!name.ends_with(".h") && !name.ends_with(".cpp")) continue;
        if (name.starts_with("elementary") || name.ends_with("-inl.h"))
            continue;  // which define them
        ++files;
        std::ifstream file(entry.path());
        int number = 0;
        for (std::string line; std::getline(file, line);) {
            ++number;
            EXPECT_FALSE(calls_the_system(code_of(line)))
                << entry.path() << ':' << number << ": " << line;
        }
    }
    EXPECT_GT(files, 500);
}

}  // namespace
