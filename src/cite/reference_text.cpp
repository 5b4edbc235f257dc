#include "cite/reference_text.h"

#include <fmt/format.h>

namespace fumon {

namespace {

constexpr std::string_view program_title =
    "fumon: sand and water landforms, simulated and rendered without a display";
constexpr std::string_view program_authors = "The fumon developers";

std::string joined(const std::vector<std::string_view>& parts, std::string_view between,
                   std::string_view last) {
    std::string text;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        if (i > 0) text += i + 1 == parts.size() ? last : between;
        text += parts[i];
    }
    return text;
}

/// With "--" for the dash of "1107–1110".
std::string replaced(std::string_view text, std::string_view from, std::string_view to) {
    std::string made(text);
    for (std::size_t at = made.find(from); at != std::string::npos;
         at = made.find(from, at + to.size()))
        made.replace(at, from.size(), to);
    return made;
}

std::string tex_text(std::string_view text) {
    return replaced(text, "&", "\\&");
}

std::string_view kind_word(WorkKind kind) {
    switch (kind) {
        case WorkKind::proceedings:
            return "Conference paper";
        case WorkKind::thesis:
            return "Thesis";
        case WorkKind::report:
            return "Report";
        default:
            return "";
    }
}

std::string text_of(const Work& work) {
    std::string text =
        fmt::format("{} ({}). {}", joined(work.authors, ", ", ", & "), work.year, work.title);
    if (!work.translation.empty()) text += fmt::format(" [{}]", work.translation);
    text += ". ";
    if (work.kind == WorkKind::thesis || work.kind == WorkKind::report)
        text += fmt::format("{}, ", kind_word(work.kind));
    text += work.in;
    if (!work.volume.empty()) text += fmt::format(", {}", work.volume);
    if (!work.pages.empty()) text += fmt::format(", {}", work.pages);
    if (!work.doi.empty()) return text + fmt::format(". https://doi.org/{}\n", work.doi);
    return text + ".\n";
}

std::string_view bibtex_type(WorkKind kind) {
    switch (kind) {
        case WorkKind::article:
            return "article";
        case WorkKind::proceedings:
            return "inproceedings";
        case WorkKind::report:
            return "techreport";
        case WorkKind::book:
            return "book";
        default:
            return "misc";  // a thesis of a degree that BibTeX lacks, data
    }
}

std::string_view bibtex_place(WorkKind kind) {
    switch (kind) {
        case WorkKind::article:
            return "journal";
        case WorkKind::proceedings:
            return "booktitle";
        case WorkKind::report:
            return "institution";
        case WorkKind::book:
            return "publisher";
        default:
            return "howpublished";
    }
}

std::string bibtex_of(const Work& work) {
    std::string text = fmt::format("@{}{{{},\n", bibtex_type(work.kind), work.id);
    const auto add = [&](std::string_view field, const std::string& value) {
        if (!value.empty()) text += fmt::format("  {} = {{{}}},\n", field, value);
    };
    add("author", tex_text(joined(work.authors, " and ", " and ")));
    // Most styles and LaTeX's own fonts have no Japanese letters: the title as published stands in
    // a field that they pass over.
    const bool translated = !work.translation.empty();
    add("title", fmt::format("{{{}}}", tex_text(translated ? work.translation : work.title)));
    if (translated) {
        add("origtitle", fmt::format("{{{}}}", tex_text(work.title)));
        add("note", "In Japanese");
    }
    add(bibtex_place(work.kind),
        (work.kind == WorkKind::thesis ? "Thesis, " : "") + tex_text(work.in));
    add("year", std::to_string(work.year));
    add("volume", std::string(work.volume));
    add("pages", replaced(work.pages, "–", "--"));
    add("doi", std::string(work.doi));
    return text + "}\n";
}

std::string_view ris_type(WorkKind kind) {
    switch (kind) {
        case WorkKind::article:
            return "JOUR";
        case WorkKind::proceedings:
            return "CPAPER";
        case WorkKind::thesis:
            return "THES";
        case WorkKind::report:
            return "RPRT";
        case WorkKind::book:
            return "BOOK";
        case WorkKind::data:
            return "DATA";
    }
    return "GEN";
}

std::string ris_of(const Work& work) {
    std::string text = fmt::format("TY  - {}\n", ris_type(work.kind));
    const auto add = [&](const char* tag, std::string_view value) {
        if (!value.empty()) text += fmt::format("{}  - {}\n", tag, value);
    };
    for (const std::string_view author : work.authors) add("AU", author);
    add("PY", std::to_string(work.year));
    add("TI", work.title);
    add("TT", work.translation);
    add(work.kind == WorkKind::article || work.kind == WorkKind::proceedings ? "T2" : "PB",
        work.in);
    add("VL", work.volume);
    const std::size_t dash = work.pages.find("–");
    add("SP", work.pages.substr(0, dash));
    if (dash != std::string_view::npos)
        add("EP", work.pages.substr(dash + std::string_view("–").size()));
    add("DO", work.doi);
    return text + "ER  - \n";
}

std::string program_entry(ReferenceFormat format) {
    switch (format) {
        case ReferenceFormat::bibtex:
            return fmt::format(
                "@misc{{fumon,\n  author = {{{{{}}}}},\n  title = {{{{{}}}}},\n  note = {{Version "
                "{}}},\n}}\n",
                program_authors, program_title, FUMON_VERSION);
        case ReferenceFormat::ris:
            return fmt::format("TY  - COMP\nAU  - {},\nTI  - {}\nET  - {}\nER  - \n",
                               program_authors, program_title, FUMON_VERSION);
        case ReferenceFormat::text:
            break;
    }
    return fmt::format("{}. {}, version {}.\n", program_authors, program_title, FUMON_VERSION);
}

}  // namespace

std::string reference_list(const std::vector<const Work*>& works, ReferenceFormat format) {
    std::string text = program_entry(format);
    for (const Work* work : works) {
        if (format != ReferenceFormat::text) text += '\n';
        text += format == ReferenceFormat::bibtex ? bibtex_of(*work)
                : format == ReferenceFormat::ris  ? ris_of(*work)
                                                  : text_of(*work);
    }
    return text;
}

std::string short_citation(const Work& work) {
    const auto family = [](std::string_view author) { return author.substr(0, author.find(',')); };
    const std::vector<std::string_view>& authors = work.authors;
    const std::string_view first = family(authors.front());
    if (authors.size() > 2) return fmt::format("{} et al. {}", first, work.year);
    if (authors.size() == 2) return fmt::format("{} & {} {}", first, family(authors[1]), work.year);
    return fmt::format("{} {}", first, work.year);
}

}  // namespace fumon
