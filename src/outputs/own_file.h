#pragma once

#include <filesystem>
#include <string_view>

namespace fumon {

/// By which a text that fumon wrote is known again: how a line of the comments at a scene's head
/// begins, what is in the head of a page of `fumon verify` and of `fumon export`, how a record
/// beside its pictures begins, and how the last line of a figure's caption begins and goes on.
inline constexpr std::string_view own_scene_mark = "# Written by fumon ";
inline constexpr std::string_view own_page_mark = "content=\"fumon verify\"";
inline constexpr std::string_view own_run_page_mark = "content=\"fumon export\"";
inline constexpr std::string_view own_result_mark = "# Got by `fumon verify`";
inline constexpr std::string_view own_caption_mark = "Made from ";
inline constexpr std::string_view own_caption_maker = " by fumon ";

/// Whether a file says of itself that fumon made it: by the "Software" among the metadata of a PNG,
/// JPEG, WebP, MP4, SVG or PDF file, by the marks above, or as JUnit XML of `fumon verify`. What
/// cannot be read or is something else is not fumon's.
bool is_made_by_fumon(const std::filesystem::path& file);

}  // namespace fumon
