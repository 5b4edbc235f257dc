#include "verify/verify_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "base/error.h"
#include "outputs/own_file.h"
#include "picture/compare.h"
#include "picture/markup.h"
#include "picture/png.h"

namespace fumon {

namespace {

// What the pictures of a case are called.
constexpr const char* expected_kind = "expected";
constexpr const char* got_kind = "got";
constexpr const char* thumbnail_kind = "got-thumbnail";
constexpr const char* difference_kind = "difference";
constexpr std::array<const char*, 4> kinds{expected_kind, got_kind, thumbnail_kind,
                                           difference_kind};

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

/// RFC 4648.
std::string base64(std::span<const std::uint8_t> bytes) {
    constexpr std::string_view digits =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
        std::uint32_t three = 0;
        for (std::size_t j = 0; j < 3; ++j)
            three = (three << 8U) | (j < count ? bytes[i + j] : std::uint32_t{0});
        for (std::size_t j = 0; j < 4; ++j)
            text += j <= count ? digits[(three >> (18 - 6 * j)) & 63U] : '=';
    }
    return text;
}

/// A thumbnail as a picture of its own size.
Image picture_of(const Thumbnail& thumbnail) {
    Image image(Thumbnail::width, Thumbnail::height);
    for (std::size_t i = 0; i < Thumbnail::count; ++i)
        image.rgb[i] = static_cast<std::uint8_t>(std::lround(thumbnail.levels[i]));
    return image;
}

void remove_file(const std::filesystem::path& file) {
    std::error_code fault;
    std::filesystem::remove(file, fault);
    if (fault && fault != std::errc::not_a_directory)
        throw Error(fmt::format("cannot remove {}: {}", file.string(), fault.message()));
}

bool same_size(const Image& first, const Image& second) {
    return first.width == second.width && first.height == second.height;
}

}  // namespace

VerifyPage::VerifyPage(std::filesystem::path folder, const OutputClaims& claims)
    : folder_(std::move(folder)) {
    if (!std::filesystem::exists(folder_)) return;
    lock_.emplace(folder_);
    claims.check(file(), false);
}

void VerifyPage::forget() {
    remove_file(file());
}

void VerifyPage::check(const std::string& suite, const std::string& name,
                       const OutputClaims& claims) const {
    for (const char* kind : kinds) claims.check(picture(suite, name, kind), false);
}

void VerifyPage::forget(const std::string& suite, const std::string& name) {
    std::error_code fault;
    const std::filesystem::path folder = folder_ / suite;
    if (std::filesystem::is_symlink(folder, fault)) return;
    bool any = false;
    for (const char* kind : kinds) {
        const std::filesystem::path file = picture(suite, name, kind);
        if (!std::filesystem::exists(file, fault) || !says_that_fumon_made_it(file)) continue;
        remove_file(file);
        any = true;
    }
    if (any) std::filesystem::remove(folder, fault);  // unless something is left in it
}

std::filesystem::path VerifyPage::picture(const std::string& suite, const std::string& name,
                                          std::string_view kind) const {
    return folder_ / suite / fmt::format("{}-{}.png", name, kind);
}

void VerifyPage::add(const std::string& suite, const std::string& name, const Verdict& verdict,
                     const Image& got, const BaselineRecord* record, const Image* expected,
                     const IgnoredPixels& ignored) {
    begin();
    const auto file = [&](const char* kind) { return picture(suite, name, kind); };
    write_section_head(suite, name, verdict, record != nullptr);
    write("<div class=\"pictures\">\n");
    const auto show = [&](const Image& image, const std::filesystem::path& to, const char* kind,
                          const std::string& caption) {
        write_picture(image, to, kind, suite + " " + name, caption, ignored);
    };
    if (record == nullptr) {
        show(got, file(got_kind), "got", "got");
    } else {
        const bool whole = expected != nullptr && same_size(*expected, got);
        const Image before = whole ? *expected : picture_of(record->fingerprint.thumbnail);
        const Image after = whole ? got : picture_of(thumbnail_of(blanked(got, ignored)));
        const std::string of_what = whole ? "" : " (thumbnail)";
        show(before, file(expected_kind), "expected", "expected" + of_what);
        show(after, file(whole ? got_kind : thumbnail_kind), "got", "got" + of_what);
        show(difference_picture(before, after, whole ? ignored : IgnoredPixels{}),
             file(difference_kind), "difference", "difference" + of_what);
        if (!whole) show(got, file(got_kind), "whole", "got, whole");
    }
    write("</div>\n</section>\n");
}

void VerifyPage::add(const std::string& suite, const std::string& name, const Verdict& verdict) {
    begin();
    write_section_head(suite, name, verdict, false);
    write("</section>\n");
}

void VerifyPage::finish() {
    if (!page_) return;
    if (is_torn_) {
        page_.reset();
        throw Error(fmt::format("cannot write {}: an earlier part of it failed", file().string()));
    }
    write(tail);
    page_->commit();
}

void VerifyPage::begin() {
    if (page_) return;
    std::error_code fault;
    std::filesystem::create_directories(folder_, fault);
    if (fault) throw Error(fmt::format("cannot make {}: {}", folder_.string(), fault.message()));
    if (!lock_) lock_.emplace(folder_);
    page_ = std::make_unique<AtomicFile>(file());
    write(page_start);
    write(own_page_mark);
    write(page_head);
}

void VerifyPage::write(std::string_view text) {
    try {
        page_->write(text);
    } catch (...) {
        is_torn_ = true;
        throw;
    }
}

void VerifyPage::write_section_head(const std::string& suite, const std::string& name,
                                    const Verdict& verdict, bool pair) {
    write(fmt::format("<section{}>\n<h2>{} {}</h2>\n<p>{}</p>\n", pair ? " class=\"pair\"" : "",
                      markup_text(suite), markup_text(name), markup_text(verdict.finding)));
}

void VerifyPage::write_picture(const Image& image, const std::filesystem::path& file,
                               const char* kind, const std::string& of, const std::string& caption,
                               const IgnoredPixels& ignored) {
    std::error_code fault;
    std::filesystem::create_directories(file.parent_path(), fault);
    if (fault) refuse_to_write(file.parent_path(), fault.value());
    const auto bytes = encode_png(image, screen_dots_per_inch, own_text());
    write_file(file, bytes);
    const bool hatches = ignored.any() && kind != std::string_view("difference") &&
                         ignored.width == image.width && ignored.height == image.height;
    const auto shown =
        hatches ? encode_png(hatched(image, ignored), screen_dots_per_inch, own_text()) : bytes;
    write(
        fmt::format("<figure><img class=\"{}\" alt=\"{}: {}\" src=\"data:image/png;base64,{}\">"
                    "<figcaption>{}</figcaption></figure>\n",
                    kind, markup_text(of), caption, base64(shown), caption));
}

}  // namespace fumon
