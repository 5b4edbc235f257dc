#include "gallery/gallery_page.h"

#include <fmt/format.h>

#include "base/data_files.h"
#include "files/input_file.h"
#include "outputs/output_claims.h"
#include "picture/markup.h"
#include "scene/placeholders.h"

namespace fumon {

namespace {

std::string file_link(const std::string& name) {
    return "files/" + markup_text(name);
}

bool is_movie_file(const std::string& name) {
    const std::string ending = small_ending(name);
    return ending == ".mp4" || ending == ".webm" || ending == ".mov" || ending == ".mkv";
}

bool is_shown(const std::string& name) {
    const std::string ending = small_ending(name);
    return is_movie_file(name) || ending == ".png" || ending == ".jpg" || ending == ".jpeg" ||
           ending == ".svg" || ending == ".webp" || ending == ".gif" || ending == ".apng";
}

std::string picture(const std::string& file, const std::string& description) {
    return fmt::format("<img src=\"{}\" alt=\"{}\" loading=\"lazy\">", file_link(file),
                       markup_text(description));
}

/// The first file as a picture or film; `small`: in the list of all.
std::string shown_file(const GalleryItem& item, bool small) {
    if (!item.files.empty() && is_shown(item.files.front().name)) {
        const std::string& name = item.files.front().name;
        if (!is_movie_file(name)) return picture(name, item.description);
        // A film's picture in the list is that of its middle: its start is often a title. It says
        // nothing that the card's letters do not.
        return small ? fmt::format(
                           "<video src=\"{}\" muted playsinline preload=\"metadata\" "
                           "aria-hidden=\"true\"></video>",
                           file_link(name))
                     : fmt::format(
                           "<video src=\"{}\" aria-label=\"{}\" controls muted playsinline loop "
                           "preload=\"metadata\"></video>",
                           file_link(name), markup_text(item.description));
    }
    if (!item.plots.empty())
        return picture(item.plots.front().name, item.plots.front().description);
    return "<span class=\"empty\"></span>";
}

std::string card(const GalleryItem& item) {
    return fmt::format(
        "<a class=\"card\" href=\"#{0}\" data-kind=\"{1}\">{2}<span class=\"name\">{3}</span>"
        "<span class=\"kind\">{1}</span></a>\n",
        markup_text(item.name), item.kind, shown_file(item, true), markup_text(item.title));
}

std::string parameters(const GalleryItem& item) {
    if (item.parameters.empty()) return "";
    std::string text =
        "<details><summary>Parameters</summary><div class=\"table\" role=\"group\" "
        "aria-label=\"Parameters\" tabindex=\"0\"><table>\n"
        "<tr><th scope=\"col\">key</th><th scope=\"col\">value</th>"
        "<th scope=\"col\">meaning</th></tr>\n";
    for (const GalleryParameter& one : item.parameters)
        text += fmt::format(
            "<tr><th scope=\"row\">{}</th><td class=\"value\">{} {}</td><td>{}</td></tr>\n",
            markup_text(one.key), markup_text(one.value), markup_text(one.unit),
            markup_text(one.help));
    return text + "</table></div></details>\n";
}

std::string again(const GalleryItem& item) {
    if (item.again.empty()) return "";
    std::string commands;
    for (const std::string& command : item.again)
        commands += (commands.empty() ? "" : "\n") + markup_text(command);
    return fmt::format(
        "<h3>How to make it again</h3>\n<div class=\"again\"><pre tabindex=\"0\">{}</pre>"
        "<button type=\"button\" class=\"copy\">Copy</button></div>\n",
        commands);
}

/// A page that turns the run, loaded once it is seen.
std::string turned(const GalleryItem& item) {
    if (item.page.empty()) return "";
    return fmt::format(
        "<h3>Turn it</h3>\n<iframe src=\"{0}\" loading=\"lazy\" title=\"{1}, to be "
        "turned\"></iframe>\n"
        "<p class=\"turn\"><a href=\"{0}\">{1} on a page of its own</a></p>\n",
        file_link(item.page), markup_text(item.title));
}

std::string sheet(const GalleryItem& item) {
    std::string plots;
    for (const GalleryFile& plot : item.plots) plots += picture(plot.name, plot.description);
    std::string caption;
    for (const std::string& paragraph : item.caption)
        caption += "<p>" + markup_text(paragraph) + "</p>\n";
    std::string files;
    for (const GalleryFile& file : item.files)
        files += fmt::format("<li><a href=\"{}\" download>{}</a></li>", file_link(file.name),
                             markup_text(file.name));
    return fmt::format(
        "<dialog id=\"{}\" data-kind=\"{}\" aria-label=\"{}\">\n<div "
        "class=\"shown\">{}</div>\n<div "
        "class=\"told\">\n"
        "<h2>{}</h2>\n{}{}{}{}{}<ul class=\"files\">{}</ul>\n</div>\n</dialog>\n",
        markup_text(item.name), item.kind, markup_text(item.title), shown_file(item, false),
        markup_text(item.title), caption, turned(item), again(item),
        plots.empty() ? "" : "<div class=\"plots\">" + plots + "</div>\n", parameters(item), files);
}

}  // namespace

std::string gallery_page(const std::string& title, const std::vector<GalleryItem>& items) {
    std::string cards;
    std::string sheets;
    for (const GalleryItem& item : items) {
        cards += card(item);
        sheets += sheet(item);
    }
    const std::string page = read_input_file(data_file("assets/gallery/page.html"));
    return fill_placeholders(page, [&](const std::string& name) -> std::optional<std::string> {
        if (name == "title") return markup_text(title);
        if (name == "count") return fmt::format("{}", items.size());
        if (name == "version") return FUMON_VERSION;
        if (name == "cards") return cards;
        if (name == "sheets") return sheets;
        return std::nullopt;
    });
}

std::vector<GalleryFile> gallery_furniture() {
    std::vector<GalleryFile> files;
    for (const char* name : {"gallery.css", "gallery.js"})
        files.push_back({name, data_file(std::string("assets/gallery/") + name)});
    return files;
}

}  // namespace fumon
