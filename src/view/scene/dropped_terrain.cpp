#include "view/scene/dropped_terrain.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <iterator>
#include <nlohmann/json.hpp>
#include <string_view>
#include <system_error>
#include <utility>

#include "base/error.h"
#include "files/atomic_file.h"
#include "run/inputs/standard_input.h"
#include "run/prepared_run.h"
#include "scene/json.h"
#include "scene/terrain_scene.h"
#include "view/scene/scene_pages.h"

namespace fumon {

namespace {

constexpr int no_such_terrain = 404;
constexpr std::size_t most_opened = 4;

/// How the page calls a file: its name without folders, letters that no terminal obeys, not long.
std::string shown_name(const HttpRequest& request) {
    constexpr std::size_t longest = 100;
    const auto given = request.query.find("name");
    std::string name = given == request.query.end() ? "" : given->second;
    name.erase(0, name.find_last_of("/\\") + 1);
    std::erase_if(name, [](char letter) {
        const auto code = static_cast<unsigned char>(letter);
        return code < 0x20 || code >= 0x7F;
    });
    if (name.size() > longest) name.resize(longest);
    return name.empty() ? "terrain" : name;
}

/// Deletes a file unless it is kept.
class NewFile {
  public:
    explicit NewFile(std::filesystem::path path) : path_(std::move(path)) {}
    ~NewFile() {
        std::error_code ignored;
        if (!kept_) std::filesystem::remove(path_, ignored);
    }
    NewFile(const NewFile&) = delete;
    NewFile& operator=(const NewFile&) = delete;

    [[nodiscard]] const std::filesystem::path& path() const { return path_; }
    void keep() { kept_ = true; }

  private:
    std::filesystem::path path_;
    bool kept_ = false;
};

std::string heights_in(const HttpRequest& request) {
    const auto given = request.query.find("heights");
    return given == request.query.end() ? "" : given->second;
}

}  // namespace

DroppedTerrain::DroppedTerrain(std::unique_ptr<Pages> pages, ViewOptions options)
    : pages_(std::move(pages)), options_(std::move(options)) {
    options_.drops = true;
    options_.work.settings.clear();
}

HttpAnswer DroppedTerrain::answer(const HttpRequest& request) {
    constexpr std::string_view of_terrain = "terrain/";
    if (request.method == "POST" && request.path == "terrain") return open(request);
    if (!request.path.starts_with(of_terrain)) return pages_->answer(request);
    HttpRequest rest = request;
    rest.path.erase(0, of_terrain.size());
    return opened_answer(std::move(rest));
}

HttpAnswer DroppedTerrain::open(const HttpRequest& request) {
    const std::string_view ending = terrain_ending_of(request.body);
    const std::string name = shown_name(request);
    if (ending.empty()) {
        throw InputError(fmt::format(
            "{}: no terrain that fumon reads; drop a GeoTIFF, an ESRI ASCII grid, a NetCDF grid or "
            "a PNG of heights",
            name));
    }
    std::list<Opened> closed;  // which ends what it draws, after the lock
    const std::lock_guard lock(mutex_);
    if (!folder_) folder_.emplace();
    const std::int64_t number = ++count_;
    NewFile uploaded(folder_->path() / (std::to_string(number) + std::string(ending)));
    const std::filesystem::path& file = uploaded.path();
    write_file(file, request.body);
    const std::string heights = heights_in(request);
    std::unique_ptr<Pages> pages;
    try {
        const auto read = [file = file.string(),
                           heights](const std::vector<std::string>& settings) {
            Scene scene = terrain_scene(file, heights, settings);
            scene.trusted = false;
            return scene;
        };
        pages = std::make_unique<ScenePages>(name, prepare_run(read({}), options_.work.threads),
                                             std::vector{file}, read, options_);
    } catch (const InputError& fault) {
        std::string text = fault.what();  // by the name that the user knows
        for (std::size_t at = 0; (at = text.find(file.string(), at)) != std::string::npos;)
            text.replace(at, file.string().size(), name);
        throw InputError(text);
    }
    if (cancelled_) pages->cancel_all();
    opened_.push_front({number, file, std::move(pages)});
    uploaded.keep();
    if (opened_.size() > most_opened) {
        opened_.back().pages->cancel_all();
        std::error_code ignored;
        std::filesystem::remove(opened_.back().file, ignored);
        closed.splice(closed.begin(), opened_, std::prev(opened_.end()));
    }
    HttpAnswer answer;
    answer.type = "application/json";
    answer.body = json_text({{"open", fmt::format("terrain/{}/", number)}});
    return answer;
}

HttpAnswer DroppedTerrain::opened_answer(HttpRequest request) {
    const std::size_t end = request.path.find('/');
    std::int64_t number = 0;
    const char* const begin = request.path.data();
    const char* const stop = begin + std::min(end, request.path.size());
    const auto [last, fault] = std::from_chars(begin, stop, number);
    std::shared_ptr<Pages> pages;
    if (fault == std::errc{} && last == stop && end != std::string::npos) {
        const std::lock_guard lock(mutex_);
        const auto known = std::ranges::find(opened_, number, &Opened::number);
        if (known != opened_.end()) pages = known->pages;
    }
    if (!pages) return plain_answer(no_such_terrain, "this terrain is closed; drop its file again");
    request.path.erase(0, end + 1);
    return pages->answer(request);
}

void DroppedTerrain::cancel_all() {
    const std::lock_guard lock(mutex_);
    cancelled_ = true;
    pages_->cancel_all();
    for (const Opened& terrain : opened_) terrain.pages->cancel_all();
}

}  // namespace fumon
