#include "view/page_files.h"

#include <algorithm>
#include <array>

#include "base/data_files.h"
#include "files/input_file.h"

namespace fumon {

namespace {

struct PageFile {
    std::string_view name;
    std::string_view file;
    std::string_view type;
};

constexpr const char* of_modules = "text/javascript; charset=utf-8";
constexpr std::array<PageFile, 11> page_files{{{"", "view.html", "text/html; charset=utf-8"},
                                               {"icon.svg", "icon.svg", "image/svg+xml"},
                                               {"view.css", "view.css", "text/css; charset=utf-8"},
                                               {"view.js", "view.js", of_modules},
                                               {"server.js", "server.js", of_modules},
                                               {"state.js", "state.js", of_modules},
                                               {"stage.js", "stage.js", of_modules},
                                               {"camera.js", "camera.js", of_modules},
                                               {"settings.js", "settings.js", of_modules},
                                               {"take.js", "take.js", of_modules},
                                               {"plots.js", "plots.js", of_modules}}};

}  // namespace

std::optional<HttpAnswer> page_file(std::string_view name) {
    const auto found = std::ranges::find(page_files, name, &PageFile::name);
    if (found == page_files.end()) return std::nullopt;
    HttpAnswer answer;
    answer.type = found->type;
    answer.body = read_input_file(data_file("assets/view/" + std::string(found->file)));
    return answer;
}

}  // namespace fumon
