#include "figure/words/chosen_words.h"

#include <filesystem>
#include <utility>

#include "base/error.h"
#include "figure/words/word_check.h"
#include "files/input_file.h"

namespace fumon {

namespace {

bool names_file(const std::string& item) {
    return item.ends_with(".toml");
}

/// "units: yr = 年", an entry as a scene holds it.
void add_entry(const std::string& item, WordTable& table) {
    const auto fail = [&]() -> KeyError {
        return KeyError("image.words", "image.words has \"" + item +
                                           "\"; write the name of a .toml file, or an entry such "
                                           "as \"words: wind = 風\" (units: and names: likewise)");
    };
    const std::size_t colon = item.find(": ");
    const std::size_t equal = item.find(" = ", colon == std::string::npos ? 0 : colon);
    if (colon == std::string::npos || equal == std::string::npos) throw fail();
    const std::string section = item.substr(0, colon);
    WordTable::Words* words = section == "words"   ? &table.words
                              : section == "units" ? &table.units
                              : section == "names" ? &table.names
                                                   : nullptr;
    if (words == nullptr) throw fail();
    const std::string english = item.substr(colon + 2, equal - colon - 2);
    const std::string own = item.substr(equal + 3);
    try {
        if (words == &table.words) check_word(english, own, "image.words: ");
    } catch (const InputError& fault) {
        throw KeyError("image.words", fault.what());
    }
    words->insert_or_assign(english, own);
}

WordTable of_language(const std::string& language, const char* key) {
    try {
        return words_of_language(language);
    } catch (const InputError& fault) {
        throw KeyError(key, std::string(key) + ": " + fault.what());
    }
}

}  // namespace

std::shared_ptr<const WordTable> picture_words(const ImageSettings& image) {
    if (image.language == "en" && image.words.empty()) return nullptr;
    WordTable own;
    for (const std::string& item : image.words) add_entry(item, own);
    return std::make_shared<const WordTable>(
        with_words(of_language(image.language, "image.language"), own));
}

std::shared_ptr<const WordTable> figure_words(const Scene& scene, const std::string& own) {
    const std::string& language = scene.figure.language;
    if (language.empty() && own.empty()) return picture_words(scene.view.image);
    const auto of_pictures = picture_words(scene.view.image);
    const WordTable table = !language.empty() ? of_language(language, "figure.language")
                            : of_pictures     ? *of_pictures
                                              : WordTable();
    return std::make_shared<const WordTable>(
        with_words(table, parse_word_table(own, scene.figure.words)));
}

void read_picture_words(Scene& scene) {
    std::vector<std::string> entries;
    for (const std::string& item : scene.view.image.words) {
        if (!names_file(item)) {
            entries.push_back(item);
            continue;
        }
        const std::string place = scene.at("image.words");
        if (!scene.trusted && !scene.set_on_command_line("image.words"))
            throw InputError(place + "a scene of unknown origin may not read a table of words");
        const std::filesystem::path named(item);
        const std::filesystem::path file =
            named.is_absolute() || scene.set_on_command_line("image.words")
                ? named
                : scene.directory / named;
        WordTable table;
        try {
            table = parse_word_table(read_input_file(file), file.string());
        } catch (const InputError& fault) {
            throw InputError(place + fault.what());
        }
        for (const auto& [section, words] :
             {std::pair{"words", &table.words}, {"units", &table.units}, {"names", &table.names}}) {
            for (const auto& [english, own] : *words)
                entries.push_back(fmt::format("{}: {} = {}", section, english, own));
        }
    }
    scene.view.image.words = std::move(entries);
}

}  // namespace fumon
