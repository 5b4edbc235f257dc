// assets/copyright says whose each file is; files of others that are told to be our own break
// licences.

#include <fnmatch.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace fs = std::filesystem;

namespace {

const fs::path source_folder = fs::path(FUMON_SOURCES_FOLDER).parent_path();

struct Statement {
    std::vector<std::string> patterns;
    std::string holder;
    std::string licence;
};

struct Copyright {
    std::vector<Statement> statements;
    std::map<std::string, std::string> texts;  ///< of licences, by their SPDX names
};

std::string text_of(const fs::path& path) {
    std::ifstream file(path);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

/// The fields of a paragraph; a line that begins with a blank goes on with the field before.
std::map<std::string, std::string> fields_of(const std::string& paragraph) {
    std::map<std::string, std::string> fields;
    std::istringstream lines(paragraph);
    std::string last;
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with(' ')) {
            fields[last] += "\n" + line.substr(1);
            continue;
        }
        const std::size_t colon = line.find(':');
        last = line.substr(0, colon);
        fields[last] = colon + 2 < line.size() ? line.substr(colon + 2) : "";
    }
    return fields;
}

Copyright read_copyright() {
    Copyright read;
    std::string text = text_of(source_folder / "assets/copyright");
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find("\n\n", begin), text.size());
        auto fields = fields_of(text.substr(begin, end - begin));
        begin = end + 2;
        if (fields.contains("Files")) {
            std::istringstream patterns(fields["Files"]);
            Statement statement{{}, fields["Copyright"], fields["License"]};
            for (std::string pattern; patterns >> pattern;) statement.patterns.push_back(pattern);
            read.statements.push_back(statement);
        } else if (fields.contains("License")) {
            const std::string& licence = fields["License"];
            const std::size_t line = licence.find('\n');
            read.texts[licence.substr(0, line)] = licence.substr(std::min(line, licence.size()));
        }
    }
    return read;
}

/// The statements that name a file, those for all files apart.
std::vector<Statement> statements_of(const Copyright& copyright, const std::string& file) {
    std::vector<Statement> found;
    for (const Statement& statement : copyright.statements)
        for (const std::string& pattern : statement.patterns)
            if (pattern != "*" && fnmatch(pattern.c_str(), file.c_str(), 0) == 0)
                found.push_back(statement);
    return found;
}

/// Folders of assets with files of others.
const std::vector<std::string> folders_with_others{"palettes", "fonts", "terrain"};

TEST(LicencesTest, EachFileOfFoldersWithThoseOfOthersIsNamedOnce) {
    const Copyright copyright = read_copyright();
    ASSERT_FALSE(copyright.statements.empty());
    EXPECT_EQ(copyright.statements.front().patterns, std::vector<std::string>{"*"});
    std::size_t files = 0;
    for (const std::string& folder : folders_with_others) {
        for (const auto& entry : fs::directory_iterator(source_folder / "assets" / folder)) {
            if (entry.path().extension() == ".md") continue;
            const std::string file = fs::relative(entry.path(), source_folder).generic_string();
            EXPECT_EQ(statements_of(copyright, file).size(), 1U) << file;
            ++files;
        }
    }
    EXPECT_GE(files, 17U);
}

TEST(LicencesTest, EachStatementNamesFilesThatThereAreAndALicenceWhoseTextStandsThere) {
    const Copyright copyright = read_copyright();
    std::set<std::string> used;
    for (const Statement& statement : copyright.statements) {
        EXPECT_FALSE(statement.holder.empty());
        EXPECT_TRUE(copyright.texts.contains(statement.licence)) << statement.licence;
        used.insert(statement.licence);
        for (const std::string& pattern : statement.patterns) {
            EXPECT_TRUE(pattern == "*" || fs::exists(source_folder / pattern)) << pattern;
        }
    }
    for (const auto& [licence, text] : copyright.texts) {
        EXPECT_TRUE(used.contains(licence)) << licence;
        EXPECT_GT(text.size(), 900U) << licence;
    }
    EXPECT_TRUE(text_of(source_folder / "LICENSE").find("Permission is hereby granted") !=
                std::string::npos);
}

TEST(LicencesTest, APaletteOfOthersNamesWhoseItIs) {
    const Copyright copyright = read_copyright();
    const std::map<std::string, std::string> first_lines{
        {"batlow", "Fabio Crameri"}, {"lapaz", "Fabio Crameri"},       {"oslo", "Fabio Crameri"},
        {"vik", "Fabio Crameri"},    {"cividis", "Battelle Memorial"}, {"viridis", "CC0"}};
    for (const auto& [palette, word] : first_lines) {
        const std::string file = "assets/palettes/" + palette + ".txt";
        const std::string text = text_of(source_folder / file);
        EXPECT_NE(text.substr(0, text.find('\n')).find(word), std::string::npos) << palette;
        const auto statements = statements_of(copyright, file);
        ASSERT_EQ(statements.size(), 1U) << palette;
        const std::string told = statements[0].holder + " " + statements[0].licence;
        EXPECT_NE(told.find(word), std::string::npos) << palette << ": " << told;
    }
}

}  // namespace
