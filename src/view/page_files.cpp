#include "view/page_files.h"

#include <algorithm>
#include <array>

#include "base/data_files.h"
#include "files/input_file.h"

namespace fumon {

namespace {

struct PageFile {
    std::string_view name;
    std::string_view type;
};

constexpr const char* of_modules = "text/javascript; charset=utf-8";
constexpr std::array<PageFile, 14> page_files{{{"icon.svg", "image/svg+xml"},
                                               {"view.css", "text/css; charset=utf-8"},
                                               {"view.js", of_modules},
                                               {"server.js", of_modules},
                                               {"state.js", of_modules},
                                               {"stage.js", of_modules},
                                               {"camera.js", of_modules},
                                               {"settings.js", of_modules},
                                               {"presets.js", of_modules},
                                               {"take.js", of_modules},
                                               {"plots.js", of_modules},
                                               {"job.js", of_modules},
                                               {"terrain.js", of_modules},
                                               {"watch.js", of_modules}}};

HttpAnswer file_answer(std::string_view name, std::string_view type) {
    HttpAnswer answer;
    answer.type = type;
    answer.body = read_input_file(data_file("assets/view/" + std::string(name)));
    return answer;
}

}  // namespace

std::optional<HttpAnswer> page_file(std::string_view name, std::string_view page) {
    if (name.empty()) return file_answer(page, "text/html; charset=utf-8");
    const auto found = std::ranges::find(page_files, name, &PageFile::name);
    if (found == page_files.end()) return std::nullopt;
    return file_answer(found->name, found->type);
}

}  // namespace fumon
