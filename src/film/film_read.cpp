#include "film/film_read.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <system_error>
#include <utility>

#include "base/data_files.h"
#include "base/error.h"
#include "base/nearest_name.h"
#include "base/utf8.h"
#include "film/film_texts.h"
#include "film/script/film_check.h"
#include "film/script/film_keys.h"
#include "film/script/film_looks.h"
#include "film/title_times.h"
#include "keys/assign.h"
#include "keys/override.h"
#include "keys/toml_text.h"
#include "outputs/output_claims.h"
#include "picture/movie_format.h"
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
                    throw InputError(fmt::format("{}: [[{}]] occurs more than {} times",
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
            } else if (!look_path(path).empty()) {
                read_looks(
                    film_, path, value, place,
                    [this](const auto& region) { return locate(region); }, faults_);
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
            throw InputError(fmt::format("{}: {} is not a section; it takes {}", place, key.path,
                                         accepted_values(key)));
        }
        assign(key, value, [this](const auto& region) { return locate(region); });
    }

    void apply(const Override& setting) {
        std::string place = fmt::format("{}:1", setting.place);
        const Key* key = table_.find(setting.path);
        if (key == nullptr && !look_path(setting.path).empty()) {
            set_look(film_, setting);
            return;
        }
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
            throw InputError(fmt::format(
                "{}: {} is a list of sections; write [[{}]] and its keys below, once for each",
                place, path, without_numbers(path)));
        }
        std::vector<std::string> known;
        for (const Key& key : table_.keys()) known.push_back(key.path);
        const bool is_rate = path == "film.fps" || path == "film.frame_rate";
        const std::string nearest = is_rate ? "film.rate" : nearest_name(path, known);
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

/// Reads the film that a piece is cut from, and puts its text in the place of its name.
void read_excerpt(Film& film, std::size_t number, bool reads_files) {
    Excerpt& excerpt = film.excerpts[number];
    const std::string key = fmt::format("excerpt.{}.film", number);
    const bool is_text = excerpt.film.find('\n') != std::string::npos;
    if (!is_text && (!reads_files || excerpt.film.empty())) {
        throw InputError(fmt::format("{}{}: it takes {}", film.at(key), key,
                                     reads_files ? "a film file, or the name of one"
                                                 : "the text of a film here, not a file"));
    }
    std::string text = excerpt.film;
    std::string name = fmt::format("{}, {}", film.source, key);
    if (!is_text) {
        const auto beside = std::filesystem::path(film.source).parent_path() / excerpt.film;
        std::error_code fault;
        const auto file =
            std::filesystem::is_regular_file(beside, fault) ? beside : film_file(excerpt.film);
        if (!std::filesystem::is_regular_file(file, fault)) {
            throw InputError(
                fmt::format("{}{}: there is no film \"{}\"", film.at(key), key, excerpt.film));
        }
        name = file.string();
        text = film_text(file).text;
    }
    Film read = parse_film(text, name, {}, false);
    if (!read.excerpts.empty())
        throw InputError(fmt::format("{}{}: this film is itself cut from other films; name those",
                                     film.at(key), key));
    read.cards.clear();
    read.captions.clear();
    excerpt.film = film_toml(read);
    excerpt.read = std::make_shared<const Film>(std::move(read));
}

/// Throws InputError, with the nearest film that fumon ships, where a name is no file.
void check_is_there(const std::filesystem::path& file) {
    std::error_code fault;
    if (file.has_parent_path() || std::filesystem::exists(file, fault)) return;
    std::vector<std::string> shipped;
    if (const auto folder = find_data_file("scenes/films")) {
        for (const auto& entry : std::filesystem::directory_iterator(*folder))
            shipped.push_back(entry.path().stem().string());
    }
    std::ranges::sort(shipped);
    for (const char* folder : {"scenes/", "scenes/figures/"}) {
        if (!find_data_file(folder + file.stem().string() + ".toml")) continue;
        throw InputError(fmt::format(
            "{}: is a scene, not a film; run it first (fumon run {} -o RUN --set "
            "output.fields_every=20), then cut a film from the run (fumon film RUN FILM)",
            file.string(), file.string()));
    }
    throw InputError(fmt::format("{}: there is no such file, and no such film ships with fumon; {}",
                                 file.string(), suggestion(file.stem().string(), shipped)));
}

/// Whether a movie's or picture's file ends so.
bool find_ending(const std::string& ending) {
    return ending == ".png" || std::ranges::any_of(movie_formats(), [&](const MovieFormat& format) {
               return format.ending == ending;
           });
}

}  // namespace

std::string Film::at(const std::string& key) const {
    const auto place = locations.find(key);
    return (place == locations.end() ? source : place->second) + ": ";
}

bool is_film(std::string_view text, const std::string& source) {
    const toml::table root =
        parse_toml(text, source, "a scene is TOML: [section] lines and key = value lines");
    return (root.contains("shot") || root.contains("excerpt")) && !root.contains("model");
}

std::filesystem::path film_file(const std::string& name) {
    std::error_code fault;
    const bool is_file =
        std::filesystem::exists(name, fault) && !std::filesystem::is_directory(name, fault);
    if (is_file || std::filesystem::path(name).has_parent_path()) return name;
    const std::string file = std::filesystem::path(name).has_extension() ? name : name + ".toml";
    if (const auto shipped = find_data_file("scenes/films/" + file)) return *shipped;
    return name;
}

Film parse_film(std::string_view text, const std::string& source,
                const std::vector<std::string>& settings, bool reads_files) {
    Film film;
    film.source = source;
    Faults faults(source);
    const toml::table root =
        parse_toml(text, source, "a film is TOML: [section] lines and key = value lines");
    constexpr std::array of_scenes{"model", "bed", "grid", "run"};
    const bool is_scene =
        std::ranges::any_of(of_scenes, [&](const char* section) { return root.contains(section); });
    if (is_scene && !root.contains("shot") && !root.contains("excerpt")) {
        throw InputError(fmt::format(
            "{}: is a scene, not a film; run it first (fumon run {} -o RUN --set "
            "output.fields_every=20), then cut a film from the run (fumon film RUN FILM)",
            source, source));
    }
    FilmReader(film, faults).read(root, read_settings(settings));
    if (faults.none()) check_film(film, faults);
    for (std::size_t i = 0; i < film.excerpts.size(); ++i)
        faults.attempt([&] { read_excerpt(film, i, reads_files); });
    if (faults.none()) check_excerpts(film, faults);
    // A film that was made may have them, and is made again as it is.
    if (faults.none() && reads_files) check_title_times(film, faults);
    faults.report();
    return film;
}

FilmText film_text(const std::filesystem::path& file) {
    check_is_there(file);
    const std::string ending = small_ending(file);
    const FilmTexts texts = read_film_texts(file);
    const bool made = ending != ".toml" && find_ending(ending);
    if (texts.empty() && !made) {
        return {read_scene_text(file).text,
                fmt::format("fumon film RUN {}", file.filename().string())};
    }
    if (ending == ".toml") {  // whose files would be trusted
        throw InputError(
            fmt::format("{}: is a movie or picture; name it by its own ending, such as "
                        ".mp4",
                        file.string()));
    }
    const auto text = texts.find(film_keyword);
    if (text == texts.end()) {
        throw InputError(
            fmt::format("{}: has no film in its metadata; `fumon film` takes a film file, an MP4 "
                        "or PNG that it made, or another of its films with the .json beside it",
                        file.string()));
    }
    const auto remake = texts.find(remake_keyword);
    return {text->second, remake == texts.end() ? "" : remake->second};
}

std::string film_toml(const Film& film) {
    Film copy = film;  // the table binds to writable values
    return with_looks(to_toml(film_keys(copy), film.settings.draft ? "" : "film.draft"), film);
}

}  // namespace fumon
