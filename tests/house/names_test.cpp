// A name stands for one type: two of a name in one namespace are undefined behaviour that no
// compiler reports, since each file sees only one of them and the linker keeps either's functions.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <string>
#include <vector>

namespace fs = std::filesystem;

namespace {

/// namespace::Name of the types that a file's text defines outside functions, classes and nameless
/// namespaces.
std::vector<std::string> types_of(std::istream& file) {
    static const std::regex opens("^(inline )?namespace ?([A-Za-z0-9_:]*) ?\\{$");
    static const std::regex closes("^\\}  // namespace");
    static const std::regex defines(
        "^(?:class|struct|union|enum class|enum) ([A-Z][A-Za-z0-9]*)(?: final)?(?: : [^;]*)?"
        "(?: \\{.*|,?)$");
    std::vector<std::string> within;
    std::vector<std::string> types;
    std::smatch match;
    for (std::string line; std::getline(file, line);) {
        if (std::regex_match(line, match, opens)) {
            within.push_back(match[2]);
        } else if (std::regex_search(line, closes)) {
            if (!within.empty()) within.pop_back();
        } else if (std::regex_match(line, match, defines)) {
            std::string name;
            bool everywhere = true;
            for (const std::string& space : within) {
                everywhere = everywhere && !space.empty();
                name += space + "::";
            }
            if (everywhere) types.push_back(name + match[1].str());
        }
    }
    return types;
}

TEST(NamesTest, NoTwoTypesOfANamespaceHaveTheSame) {
    std::map<std::string, fs::path> defined;
    for (const auto& entry : fs::recursive_directory_iterator(FUMON_SOURCES_FOLDER)) {
        const std::string name = entry.path().filename().string();
        if (!name.ends_with(".h") && !name.ends_with(".cpp")) continue;
        if (name.ends_with("-inl.h")) continue;  // in a namespace of each vector target
        std::ifstream file(entry.path());
        for (const std::string& type : types_of(file)) {
            const auto [before, is_new] = defined.emplace(type, entry.path());
            EXPECT_TRUE(is_new) << type << " stands in " << entry.path() << " and in "
                                << before->second;
        }
    }
    EXPECT_GT(defined.size(), 400U);
}

}  // namespace
