#include "film/cache/frame_cache.h"

#include <fmt/format.h>

#include <system_error>

#include "base/error.h"
#include "files/atomic_file.h"
#include "files/hash.h"
#include "files/input_file.h"
#include "picture/png.h"

namespace fumon {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view mark = "Frames of a film that fumon is making: ";

}  // namespace

FrameCache::FrameCache(const fs::path& file, const std::string& identity)
    : file_(file), folder_(file.string() + ".frames") {
    const fs::path identity_file = folder_ / "film.txt";
    const std::string line = fmt::format("{}{}\n", mark, hex(text_hash(identity)));
    std::error_code fault;
    if (fs::exists(folder_, fault)) {
        const std::string there =
            fs::is_regular_file(identity_file, fault) ? read_input_file(identity_file) : "";
        if (there == line) return;
        if (!there.starts_with(mark)) {
            throw InputError(
                fmt::format("{}: already exists and holds no frames of a film; move it away",
                            folder_.string()));
        }
        clear();
    }
    fs::create_directories(folder_, fault);
    if (fault) throw Error(fmt::format("cannot write {}: {}", folder_.string(), fault.message()));
    write_file(identity_file, line);
}

fs::path FrameCache::frame(std::int64_t number) const {
    return folder_ / fmt::format("frame_{:06}.png", number);
}

fs::path FrameCache::so_far() const {
    return folder_ / ("so-far" + file_.extension().string());
}

fs::path FrameCache::whole() const {
    return folder_ / ("film" + file_.extension().string());
}

std::optional<Image> FrameCache::find(std::int64_t number) const {
    std::error_code fault;
    if (!fs::is_regular_file(frame(number), fault)) return std::nullopt;
    return read_png(frame(number));
}

void FrameCache::add(std::int64_t number, const Image& image) const {
    write_file(frame(number), encode_png(image, screen_dots_per_inch, own_text()));
}

void FrameCache::finish() const {
    std::error_code fault;
    fs::rename(whole(), resolved_link(file_), fault);
    if (fault) throw Error(fmt::format("cannot write {}: {}", file_.string(), fault.message()));
    clear();
}

void FrameCache::clear() const {
    std::error_code fault;
    for (const auto& entry : fs::directory_iterator(folder_, fault)) {
        const std::string name = entry.path().filename().string();
        const bool own =
            name.starts_with("frame_") || name.starts_with("so-far.") || name.starts_with("film.");
        if (own) fs::remove(entry.path(), fault);
    }
    fs::remove(folder_, fault);
}

}  // namespace fumon
