#include "outputs/own_file.h"

#include <algorithm>
#include <string>

#include "base/error.h"
#include "figure/canvas/figure_metadata.h"
#include "files/input_file.h"
#include "files/png_reader.h"
#include "picture/exr.h"
#include "picture/junit.h"
#include "picture/movie.h"
#include "picture/stills/picture_file.h"

namespace fumon {

namespace {

constexpr std::size_t head_bytes = 2000;          // of a text, in which it names itself
constexpr std::size_t longest_caption = 1 << 20;  // bytes

bool by_fumon(const PictureText& texts) {
    return std::ranges::any_of(texts, [](const auto& text) {
        return text.first == "Software" && text.second.starts_with("fumon");
    });
}

/// fumon writes its texts before the picture; a program that has changed the file may have moved
/// them.
bool is_own_png(const std::filesystem::path& file) {
    const std::string bytes = read_input_file(file);
    PngReader reader(bytes, file.string());
    return by_fumon(reader.texts_before_picture()) || by_fumon(reader.texts());
}

/// The comments with which a scene begins.
bool is_own_scene(std::string_view head) {
    while (head.starts_with('#')) {
        if (head.starts_with(own_scene_mark)) return true;
        head.remove_prefix(std::min(head.find('\n'), head.size() - 1) + 1);
    }
    return false;
}

bool is_own_caption(std::string_view text) {
    while (text.ends_with('\n')) text.remove_suffix(1);
    const std::string_view last = text.substr(text.rfind('\n') + 1);
    return last.starts_with(own_caption_mark) &&
           last.find(own_caption_maker) != std::string_view::npos;
}

bool is_own_text(const std::filesystem::path& file, std::string_view head) {
    const auto has = [head](std::string_view mark) {
        return head.find(mark) != std::string_view::npos;
    };
    if (head.starts_with("<?xml") && has(own_junit_mark)) return true;
    if (head.starts_with("<!DOCTYPE html>") && (has(own_page_mark) || has(own_run_page_mark)))
        return true;
    if (head.starts_with(own_result_mark)) return true;
    return is_own_scene(head) || is_own_caption(start_of_input_file(file, longest_caption));
}

bool is_figure_file(std::string_view head) {
    return head.starts_with("%PDF-") || head.starts_with("%!PS-Adobe") ||
           head.find("<svg") != std::string_view::npos;
}

}  // namespace

bool is_made_by_fumon(const std::filesystem::path& file) {
    try {
        const std::string head = start_of_input_file(file, head_bytes);
        if (is_png(head)) return is_own_png(file);
        if (is_picture(head)) return by_fumon(read_picture_texts(file));
        if (is_exr(head)) return by_fumon(read_exr_texts(file));
        if (is_movie(file)) return by_fumon(read_movie_texts(file));
        if (is_figure_file(head))
            return by_fumon(read_figure_metadata(read_input_file(file), file.string()));
        return is_own_text(file, head);
    } catch (const InputError&) {
        return false;
    }
}

}  // namespace fumon
