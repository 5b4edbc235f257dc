#include "verify/verify_page.h"

#include <fmt/format.h>
#include <sys/stat.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <system_error>
#include <utility>

#include "base/error.h"
#include "figure/canvas/packed_text.h"
#include "outputs/own_file.h"
#include "picture/markup.h"
#include "verify/got_records.h"

namespace fumon {

namespace {

constexpr const char* page_start = R"html(<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="generator" )html";

constexpr const char* page_head = R"html(>
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="color-scheme" content="light dark">
<title>fumon verify: what differs from its baseline</title>
<style>
:root { --ground: #fafafa; --letters: #222222; --line: #cccccc; --mark: #0b57a4; }
@media (prefers-color-scheme: dark) {
  :root { --ground: #17181a; --letters: #ececec; --line: #4a4c50; --mark: #8ab8f0; }
}
body { font: 15px/1.4 sans-serif; margin: clamp(1em, 4vw, 2em); background: var(--ground); color: var(--letters); }
section { margin-bottom: 3em; }
h1 { font-size: 1.5em; }
h2 { font-size: 1.2em; margin: 0; }
h1, h2, p { overflow-wrap: anywhere; }
code { user-select: all; }
.pictures { display: flex; flex-wrap: wrap; gap: 1em; }
figure { margin: 0; width: 30em; max-width: 100%; }
img { width: 100%; box-sizing: border-box; border: 1px solid var(--line); image-rendering: pixelated; }
button { display: block; width: 100%; padding: 0; border: 0; background: none; cursor: pointer; }
:focus-visible { outline: 3px solid var(--mark); outline-offset: 2px; }
</style>
</head>
<body>
<main>
<h1>What differs from its baseline</h1>
)html";

constexpr const char* tail = R"html(</main>
<script>
"use strict";
// A fourth picture of each pair shows what was expected and what was got in turns, until it is pressed.
const still = matchMedia("(prefers-reduced-motion: reduce)").matches;
for (const section of document.querySelectorAll("section.pair")) {
  const sides = ["expected", "got"].map(kind => section.querySelector("img." + kind));
  const figure = document.createElement("figure");
  const button = figure.appendChild(document.createElement("button"));
  const picture = button.appendChild(document.createElement("img"));
  const caption = figure.appendChild(document.createElement("figcaption"));
  section.querySelector("img.difference").closest("figure").after(figure);
  button.type = "button";
  picture.alt = section.querySelector("h2").textContent + ": expected and got in turns";
  let turn = 0, held = still;
  const show = () => {
    picture.src = sides[turn].src;
    caption.textContent = "in turns: " + sides[turn].className + (held ? ", held" : "");
    button.setAttribute("aria-pressed", held);
  };
  button.onclick = () => { held = !held; show(); };
  setInterval(() => { if (!held) { turn = 1 - turn; show(); } }, 700);
  show();
}
</script>
</body>
</html>
)html";

void remove_file(const std::filesystem::path& file) {
    std::error_code fault;
    std::filesystem::remove(file, fault);
    if (fault && fault != std::errc::not_a_directory)
        throw Error(fmt::format("cannot remove {}: {}", file.string(), fault.message()));
}

/// The folder of a file, made where it is not there.
void make_folder(const std::filesystem::path& folder) {
    std::error_code fault;
    std::filesystem::create_directories(folder, fault);
    if (fault) throw Error(fmt::format("cannot make {}: {}", folder.string(), fault.message()));
}

std::filesystem::path new_temporary_folder() {
    std::error_code fault;
    const auto parent = std::filesystem::temp_directory_path(fault);
    std::string folder = ((fault ? "/tmp" : parent) / "fumon-verify-XXXXXX").string();
    if (::mkdtemp(folder.data()) == nullptr) {
        throw Error(fmt::format("cannot make the folder {}: {}", folder,
                                std::generic_category().message(errno)));
    }
    return folder;
}

std::string head_of_page() {
    return fmt::format("{}{}{}", page_start, own_page_mark, page_head);
}

std::string section_text(const std::string& suite, const std::string& name, const Verdict& verdict,
                         const std::vector<PagePicture>& pictures, const std::string& command) {
    const bool pair = std::ranges::any_of(
        pictures, [](const PagePicture& one) { return one.kind == difference_kind; });
    std::string text =
        fmt::format("<section{}>\n<h2>{} {}</h2>\n<p>{}</p>\n", pair ? " class=\"pair\"" : "",
                    markup_text(suite), markup_text(name), markup_text(verdict.finding));
    if (!command.empty())
        text += fmt::format("<p>Accept it: <code>{}</code></p>\n", markup_text(command));
    if (pictures.empty()) return text + "</section>\n";
    text += "<div class=\"pictures\">\n";
    for (const PagePicture& one : pictures) {
        text += fmt::format(
            "<figure><img class=\"{}\" alt=\"{} {}: {}\" "
            "src=\"data:image/png;base64,{}\"><figcaption>{}</figcaption></figure>\n",
            one.shown_as, markup_text(suite), markup_text(name), one.caption,
            base64_text(one.hatched.empty() ? one.png : one.hatched), one.caption);
    }
    return text + "</div>\n</section>\n";
}

}  // namespace

VerifyPage::VerifyPage(std::filesystem::path folder, const OutputClaims& claims)
    : folder_(std::move(folder)) {
    if (folder_.empty() || !std::filesystem::exists(folder_)) return;
    lock_.emplace(folder_);
    claims.check(file(), false);
}

void VerifyPage::remove_old() {
    if (!folder_.empty()) remove_file(file());
}

std::filesystem::path VerifyPage::file_of(const std::string& suite, const std::string& name,
                                          std::string_view kind) const {
    return folder_ / suite / fmt::format("{}-{}.png", name, kind);
}

std::vector<std::filesystem::path> VerifyPage::files_of(const std::string& suite,
                                                        const std::string& name) const {
    std::vector<std::filesystem::path> files;
    files.reserve(picture_kinds.size() + 1);
    for (const std::string_view kind : picture_kinds) files.push_back(file_of(suite, name, kind));
    files.push_back(got_record_file(folder_ / suite, name));
    return files;
}

void VerifyPage::check(const std::string& suite, const std::string& name,
                       const OutputClaims& claims) const {
    if (folder_.empty()) return;
    for (const auto& file : files_of(suite, name)) claims.check(file, false);
}

void VerifyPage::remove_old(const std::string& suite, const std::string& name) {
    std::error_code fault;
    const std::filesystem::path folder = folder_ / suite;
    if (folder_.empty() || std::filesystem::is_symlink(folder, fault)) return;
    bool any = false;
    for (const auto& file : files_of(suite, name)) {
        if (!std::filesystem::exists(file, fault) || !is_made_by_fumon(file)) continue;
        remove_file(file);
        any = true;
    }
    if (any) std::filesystem::remove(folder, fault);  // unless something is left in it
}

void VerifyPage::add(const std::string& suite, const std::string& name, const Verdict& verdict,
                     const Image& got, const BaselineRecord* record, const Image* expected,
                     const IgnoredPixels& ignored) {
    add(suite, name, verdict, page_pictures(got, record, expected, ignored), "");
}

void VerifyPage::add(const std::string& suite, const std::string& name, const Verdict& verdict,
                     const std::vector<PagePicture>& pictures, const std::string& command) {
    const std::string alone = section_text(suite, name, verdict, {}, "");
    texts_ += alone;
    begin();
    try {
        if (!pictures.empty()) make_folder(folder_ / suite);
        for (const PagePicture& one : pictures)
            write_beside(file_of(suite, name, one.kind), one.png);
        write(section_text(suite, name, verdict, pictures, command));
    } catch (const Error&) {
        write(alone);
        throw;
    }
}

void VerifyPage::add_record(const std::string& suite, const std::string& name,
                            std::string_view text) {
    begin();
    make_folder(folder_ / suite);
    write_beside(got_record_file(folder_ / suite, name), text);
}

void VerifyPage::finish() {
    if (texts_.empty()) return;
    try {
        begin();
        if (!is_torn_) {
            write(tail);
            page_->commit();
            return;
        }
    } catch (const Error&) {
        if (!page_) throw;
    }
    drop_pictures();
    write_file(file(), head_of_page() + texts_ + tail);
}

void VerifyPage::drop_pictures() {
    page_.reset();
    is_torn_ = true;
    std::error_code ignored;
    for (const auto& file : beside_) std::filesystem::remove(file, ignored);
    for (const auto& file : beside_) std::filesystem::remove(file.parent_path(), ignored);
    beside_.clear();
}

bool VerifyPage::shares_disk_with(const std::filesystem::path& file) const {
    struct stat here {};
    struct stat there {};
    std::error_code fault;
    const auto folder = std::filesystem::absolute(file, fault).parent_path();
    return !folder_.empty() && ::stat(folder_.c_str(), &here) == 0 &&
           ::stat(folder.c_str(), &there) == 0 && here.st_dev == there.st_dev;
}

void VerifyPage::begin() {
    if (page_) return;
    if (folder_.empty()) folder_ = new_temporary_folder();
    make_folder(folder_);
    if (!lock_) lock_.emplace(folder_);
    page_ = std::make_unique<AtomicFile>(file());
    try {
        write(head_of_page());
    } catch (...) {
        is_torn_ = true;
        throw;
    }
}

void VerifyPage::write_beside(const std::filesystem::path& file, std::string_view bytes) {
    write_file(file, bytes);
    beside_.push_back(file);
}

void VerifyPage::write(std::string_view text) {
    if (is_torn_) return;
    const std::int64_t before = page_->length();
    try {
        page_->write(text);
    } catch (...) {
        is_torn_ = page_->length() != before;
        throw;
    }
}

}  // namespace fumon
