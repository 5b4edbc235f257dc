#include "scene/figure/journals.h"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <fstream>
#include <iterator>

#include "base/data_files.h"
#include "base/error.h"
#include "keys/toml_text.h"

namespace fumon {

namespace {

std::vector<std::string> texts_of(const toml::table& table, std::string_view key) {
    std::vector<std::string> texts;
    if (const toml::array* list = table[key].as_array()) {
        for (const toml::node& node : *list) texts.push_back(node.value_or(std::string()));
    }
    return texts;
}

Journal journal_of(const toml::table& table) {
    const auto number = [&](std::string_view key) { return table[key].value<double>(); };
    Journal journal;
    journal.name = table["name"].value_or(std::string());
    journal.title = table["title"].value_or(journal.name);
    journal.single = number("single");
    journal.both = number("double");
    journal.highest = number("highest");
    journal.least_letters = number("least_letters");
    journal.least_raised = number("least_raised");
    journal.most_letters = number("most_letters");
    journal.least_lines = number("least_lines");
    journal.most_lines = number("most_lines");
    journal.formats = texts_of(table, "formats");
    journal.line_art = number("line_art");
    journal.halftone = number("halftone");
    journal.combination = number("combination");
    journal.units_in_brackets = table["units_in_brackets"].value_or(false);
    journal.rgb = table["colours"].value_or(std::string()) == "rgb";
    journal.pages = texts_of(table, "pages");
    journal.read = table["read"].value_or(0);
    return journal;
}

std::vector<Journal> read_journals() {
    const auto file = data_file("assets/journals/journals.toml");
    std::vector<Journal> all;
    std::ifstream stream(file);
    const std::string text((std::istreambuf_iterator<char>(stream)), {});
    const toml::table root = parse_toml(text, file.string(), "a table of journals has [[journal]]");
    if (const toml::array* list = root["journal"].as_array()) {
        for (const toml::node& node : *list) {
            if (const toml::table* table = node.as_table()) all.push_back(journal_of(*table));
        }
    }
    if (all.empty() || !all.front().name.empty())
        throw Error(fmt::format("{}: its first journal has no empty name", file.string()));
    return all;
}

}  // namespace

const std::vector<Journal>& journals() {
    static const std::vector<Journal> all = read_journals();
    return all;
}

const Journal* find_journal(std::string_view name) {
    const auto found = std::ranges::find(journals(), name, &Journal::name);
    return found == journals().end() ? nullptr : &*found;
}

void use_journal(FigureSettings& figure, const std::set<std::string>& given) {
    const Journal* const journal = figure.journal.empty() ? nullptr : find_journal(figure.journal);
    if (journal == nullptr) return;
    if (figure.width.word == "single" && journal->single) figure.width = *journal->single;
    if (figure.width.word == "double" && journal->both) figure.width = *journal->both;
    if (!given.contains("figure.font_size")) {
        const double labels = std::max(journal->least_letters.value_or(0.0) / tick_share,
                                       journal->least_raised.value_or(0.0) / raised_share);
        figure.font_size = std::max(figure.font_size, std::ceil(10.0 * labels) / 10.0);
        figure.font_size = std::min(figure.font_size, journal->most_letters.value_or(1e3));
    }
    if (!given.contains("figure.line_width")) {
        const double least = journal->least_lines.value_or(0.0) / frame_share;
        figure.line_width = std::clamp(figure.line_width, least, std::max(least, 20.0));
        figure.line_width = std::min(figure.line_width, journal->most_lines.value_or(20.0));
    }
    if (!given.contains("figure.dots_per_inch")) {
        const double least = journal->combination.value_or(journal->halftone.value_or(0.0));
        figure.dots_per_inch = std::max(figure.dots_per_inch, least);
    }
}

std::vector<std::string> journal_names() {
    std::vector<std::string> names;
    for (const Journal& journal : journals()) {
        if (!journal.name.empty()) names.push_back(journal.name);
    }
    return names;
}

}  // namespace fumon
