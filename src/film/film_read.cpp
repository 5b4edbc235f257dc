#include "film/film_read.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <optional>

#include "base/error.h"
#include "base/nearest_name.h"
#include "base/utf8.h"
#include "files/input_file.h"
#include "film/film_check.h"
#include "film/film_keys.h"
#include "keys/assign.h"
#include "keys/override.h"
#include "keys/toml_text.h"
#include "picture/movie.h"
#include "picture/png.h"
#include "scene/faults.h"
#include "scene/read.h"
#include "scene/write.h"

namespace fumon {

namespace {

class FilmReader {
  public:
    FilmReader(Film& film, Faults& faults)
        : film_(film), table_(film_keys(film)), faults_(faults) {}

    void read(const toml::table& root, const std::vector<Override>& settings) {
        if (!faults_.attempt([&] { size_lists(root); })) return;
        read_section(root, "");
        for (const Override& setting : settings) faults_.attempt([&] { apply(setting); });
    }

  private:
    [[nodiscard]] std::string locate(const toml::source_region& region) const {
        return fmt::format("{}:{}:{}", film_.source, region.begin.line, region.begin.column);
    }

    /// Gives the lists of tables as many items as the file has; those within items come next.
    void size_lists(const toml::table& root) {
        for (bool changed = true; changed;) {
            changed = false;
            for (const TableList& list : table_.lists()) {
                const toml::array* items = array_at(root, list.path);
                const std::size_t size = items == nullptr ? 0 : items->size();
                if (size == list.size()) continue;
                if (size > most_tables)
                    throw InputError(fmt::format("{}: [[{}]] stands more than {} times",
                                                 locate(items->source()),
                                                 without_numbers(list.path), most_tables));
                list.resize(size);
                table_ = film_keys(film_);
                changed = true;
                break;
            }
        }
    }

    /// The array of a list such as "shot" or "shot.0.key".
    static const toml::array* array_at(const toml::table& root, const std::string& path) {
        const toml::node* node = &root;
        for (std::size_t start = 0; start <= path.size() && node != nullptr;) {
            const std::size_t end = std::min(path.find('.', start), path.size());
            const std::string part = path.substr(start, end - start);
            if (const toml::array* items = node->as_array(); items != nullptr) {
                node = items->get(std::stoul(part));
            } else {
                node = node->is_table() ? node->as_table()->get(part) : nullptr;
            }
            start = end + 1;
        }
        return node == nullptr ? nullptr : node->as_array();
    }

    void read_section(const toml::table& section, const std::string& prefix) {
        for (const auto& [name, value] : section) {
            const std::string path = prefix + std::string(name.str());
            const std::string place = locate(name.source());
            const TableList* list = table_.find_list(path);
            if (const Key* key = table_.find(path)) {
                faults_.attempt([&, &value = value] { read_value(*key, value, place); });
                film_.locations[path] = locate(value.source());
            } else if (list != nullptr && value.is_array()) {
                read_items(*value.as_array(), path);
            } else if (list == nullptr && value.is_table() && is_section(path)) {
                read_section(*value.as_table(), path + ".");
            } else {
                faults_.attempt([&] { refuse(path, place); });
            }
        }
    }

    void read_items(const toml::array& items, const std::string& path) {
        std::size_t index = 0;
        for (const toml::node& item : items) {
            const std::string prefix = fmt::format("{}.{}.", path, index++);
            if (item.is_table()) {
                film_.locations[prefix] = locate(item.source());
                read_section(*item.as_table(), prefix);
            } else {
                faults_.attempt([&] { refuse(path, locate(item.source())); });
            }
        }
    }

    void read_value(const Key& key, const toml::node& value, const std::string& place) {
        if (value.is_table()) {
            throw InputError(fmt::format("{}: {} is no section; it takes {}", place, key.path,
                                         what_it_takes(key)));
        }
        assign(key, value, [this](const auto& region) { return locate(region); });
    }

    void apply(const Override& setting) {
        std::string place = fmt::format("{}:1", setting.place);
        const Key* key = table_.find(setting.path);
        if (key == nullptr) refuse(setting.path, place);
        if (!is_utf8(setting.value))
            throw InputError(fmt::format("{}: the value of {} is not UTF-8", place, setting.path));
        toml::table holder;
        if (auto read = parse_toml_value(setting.value)) {
            holder = std::move(*read);
        } else {
            holder.insert_or_assign("value", setting.value);
        }
        assign(*key, *holder.get("value"), [&](const auto&) -> std::string { return place; });
        film_.locations[setting.path] = setting.place;
    }

    [[nodiscard]] bool is_section(const std::string& path) const {
        const std::string begin = path + ".";
        return std::ranges::any_of(table_.keys(),
                                   [&](const Key& key) { return key.path.starts_with(begin); });
    }

    [[noreturn]] void refuse(const std::string& path, const std::string& place) const {
        if (table_.find_list(path) != nullptr) {
            throw InputError(
                fmt::format("{}: {} is a list of sections; write [[{}]] and its keys below, as "
                            "often as there are",
                            place, path, without_numbers(path)));
        }
        std::vector<std::string> known;
        for (const Key& key : table_.keys()) known.push_back(key.path);
        const std::string nearest = nearest_name(path, known);
        throw InputError(
            nearest.empty()
                ? fmt::format("{}: unknown key {}; `fumon describe film` lists the known ones",
                              place, path)
                : fmt::format("{}: unknown key {}; did you mean \"{}\"?", place, path, nearest));
    }

    Film& film_;
    KeyTable table_;
    Faults& faults_;
};

}  // namespace

std::string Film::at(const std::string& key) const {
    const auto place = locations.find(key);
    return (place == locations.end() ? source : place->second) + ": ";
}

bool is_film(std::string_view text, const std::string& source) {
    const toml::table root =
        parse_toml(text, source, "a scene is TOML: [section] lines and key = value lines");
    return root.contains("shot") && !root.contains("model");
}

Film parse_film(std::string_view text, const std::string& source,
                const std::vector<std::string>& settings) {
    Film film;
    film.source = source;
    Faults faults(source);
    const toml::table root =
        parse_toml(text, source, "a film is TOML: [section] lines and key = value lines");
    FilmReader(film, faults).read(root, read_settings(settings));
    if (faults.none()) check_film(film, faults);
    faults.report();
    return film;
}

FilmText film_text(const std::filesystem::path& file) {
    constexpr std::size_t signature = 4;
    std::error_code fault;
    const bool regular = std::filesystem::is_regular_file(file, fault);
    const bool movie = regular && is_movie(file);
    const bool png = regular && start_of_input_file(file, signature) == "\x89PNG";
    if (!movie && !png) {
        return {read_scene_text(file).text,
                fmt::format("fumon film RUN {}", file.filename().string())};
    }
    FilmText film;
    for (const auto& [keyword, text] : movie ? read_movie_texts(file) : read_png_texts(file)) {
        if (keyword == film_keyword) film.text = text;
        if (keyword == remake_keyword) film.remake = text;
    }
    if (film.text.empty()) {
        throw InputError(
            fmt::format("{}: carries no film; `fumon film` takes a film file, or an MP4 or PNG "
                        "that it made",
                        file.string()));
    }
    return film;
}

std::string film_toml(const Film& film) {
    Film copy = film;  // the table binds to writable values
    return to_toml(film_keys(copy));
}

}  // namespace fumon
