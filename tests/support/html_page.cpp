#include "support/html_page.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace fumon::test {
namespace {

struct Tag {
    std::string name;
    std::string text;  ///< with its attributes
    bool closes = false;
};

/// The tags of a page without its comments, scripts and style sheets.
std::vector<Tag> tags_of(const std::string& html) {
    std::vector<Tag> tags;
    for (std::size_t at = html.find('<'); at != std::string::npos; at = html.find('<', at)) {
        const std::size_t end = html.find('>', at);
        if (end == std::string::npos) break;
        Tag tag;
        tag.text = html.substr(at, end - at + 1);
        tag.closes = tag.text[1] == '/';
        const std::size_t begin = tag.closes ? 2 : 1;
        tag.name = tag.text.substr(begin, tag.text.find_first_of(" \n>", begin) - begin);
        at = end;
        const bool is_raw = !tag.closes && (tag.name == "script" || tag.name == "style");
        if (is_raw) at = html.find("</" + tag.name, end);
        tags.push_back(std::move(tag));
    }
    return tags;
}

/// The value of an attribute; empty where it is missing or empty.
std::string attribute(const Tag& tag, const std::string& name) {
    const std::size_t at = tag.text.find(" " + name + "=\"");
    if (at == std::string::npos) return "";
    const std::size_t begin = at + name.size() + 3;
    return tag.text.substr(begin, tag.text.find('"', begin) - begin);
}

bool is_void(const std::string& name) {
    return name == "meta" || name == "link" || name == "img" || name == "br" ||
           name == "!DOCTYPE" || name == "input" || name == "track" || name == "path";
}

/// Levels from 0 to 1 of a colour "#rrggbb", made linear by WCAG's formula.
double linear(const std::string& colour, std::size_t at) {
    const double level = std::stoi(colour.substr(at, 2), nullptr, 16) / 255.0;
    return level <= 0.04045 ? level / 12.92 : std::pow((level + 0.055) / 1.055, 2.4);
}

double luminance(const std::string& colour) {
    return 0.2126 * linear(colour, 1) + 0.7152 * linear(colour, 3) + 0.0722 * linear(colour, 5);
}

}  // namespace

std::vector<std::string> faults_of_page(const std::string& html) {
    std::vector<std::string> faults;
    std::vector<std::string> open;
    std::multiset<std::string> ids;
    std::vector<std::string> links;
    int mains = 0;
    int level = 0;
    for (const Tag& tag : tags_of(html)) {
        if (tag.closes) {
            if (open.empty() || open.back() != tag.name)
                faults.push_back("not nested: " + tag.text);
            else
                open.pop_back();
            continue;
        }
        if (tag.name == "main") ++mains;
        if (tag.name == "html" && attribute(tag, "lang").empty())
            faults.emplace_back("no language");
        if (tag.name == "img" && attribute(tag, "alt").empty())
            faults.push_back("no alt: " + tag.text.substr(0, 80));
        if (tag.name == "img" && attribute(tag, "src").empty())
            faults.push_back("no src: " + tag.text.substr(0, 80));
        if (!open.empty() && open.back() == "body" && tag.name != "main" && tag.name != "header" &&
            tag.name != "footer" && tag.name != "nav" && tag.name != "script")
            faults.push_back("beside landmarks: " + tag.text);
        if (tag.name.size() == 2 && tag.name[0] == 'h' && tag.name[1] >= '1' &&
            tag.name[1] <= '6') {
            const int now = tag.name[1] - '0';
            if (now > level + 1) faults.push_back("skips a level: " + tag.text);
            level = now;
        }
        if (const std::string id = attribute(tag, "id"); !id.empty() && ids.contains(id))
            faults.push_back("twice: " + id);
        ids.insert(attribute(tag, "id"));
        if (const std::string link = attribute(tag, "href"); link.starts_with('#'))
            links.push_back(link.substr(1));
        if (!is_void(tag.name)) open.push_back(tag.name);
    }
    for (const std::string& name : open) faults.push_back("left open: " + name);
    if (mains != 1) faults.push_back("main landmarks: " + std::to_string(mains));
    for (const std::string& link : links)
        if (!ids.contains(link)) faults.push_back("leads nowhere: #" + link);
    for (const char* wanted : {"<!DOCTYPE html>", "<meta charset=\"utf-8\">", "<title>",
                               "<meta name=\"viewport\" content=\"width=device-width",
                               "<meta name=\"color-scheme\" content=\""})
        if (html.find(wanted) == std::string::npos) faults.push_back(std::string("no ") + wanted);
    return faults;
}

double contrast(const std::string& one, const std::string& other) {
    const double first = luminance(one);
    const double second = luminance(other);
    return (std::max(first, second) + 0.05) / (std::min(first, second) + 0.05);
}

std::string colour_of(const std::string& style, const std::string& name, bool of_the_rule) {
    const std::size_t begin = of_the_rule ? style.find("prefers-color-scheme") : 0;
    if (begin == std::string::npos) return "";
    const std::size_t at = style.find("--" + name + ": #", begin);
    constexpr std::size_t length = 7;  // of #rrggbb
    return at == std::string::npos ? "" : style.substr(style.find('#', at), length);
}

}  // namespace fumon::test
