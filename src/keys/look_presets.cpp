#include "keys/look_presets.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "base/data_files.h"
#include "base/error.h"
#include "base/nearest_name.h"
#include "keys/assign.h"
#include "keys/toml_text.h"

namespace fumon {

namespace {

constexpr const char* folder = "assets/looks";

/// Sets the keys of a section of a look.
class LookFile {
  public:
    LookFile(const KeyTable& table, std::string file) : table_(table), file_(std::move(file)) {}

    void take(const toml::table& section, const std::string& prefix) const {
        for (const auto& [name, value] : section) {
            const std::string path = prefix + std::string(name.str());
            if (prefix.empty() && value.is_table()) {
                take(*value.as_table(), path + ".");
                continue;
            }
            const Key* key = table_.find(path);
            if (key == nullptr || key->role != KeyRole::look || path == "look.preset")
                throw InputError(
                    fmt::format("{}: {} is not a key of a look; a look has the keys of role look "
                                "in `fumon describe scene`, except look.preset",
                                locate(name.source()), path));
            assign(*key, value, [this](const auto& region) { return locate(region); });
        }
    }

  private:
    [[nodiscard]] std::string locate(const toml::source_region& region) const {
        return fmt::format("{}:{}:{}", file_, region.begin.line, region.begin.column);
    }

    const KeyTable& table_;
    std::string file_;
};

}  // namespace

std::vector<std::string> look_preset_names() {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(data_file(folder))) {
        if (entry.path().extension() == ".toml") names.push_back(entry.path().stem().string());
    }
    std::sort(names.begin(), names.end());
    return names;
}

void apply_look_preset(const KeyTable& table, const std::string& name, std::string_view place) {
    const std::vector<std::string> names = look_preset_names();
    if (std::find(names.begin(), names.end(), name) == names.end())
        throw InputError(
            fmt::format("{}: unknown look \"{}\"; {}", place, name, suggestion(name, names)));
    const std::filesystem::path file = data_file(fmt::format("{}/{}.toml", folder, name));
    std::ifstream stream(file, std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(stream), {}};
    if (!stream) throw Error(fmt::format("cannot read {}", file.string()));
    LookFile(table, file.string())
        .take(parse_toml(text, file.string(), "a look is TOML: [section] lines and key = value"),
              "");
}

}  // namespace fumon
