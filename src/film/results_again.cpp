#include "film/results_again.h"

#include <fmt/format.h>

#include <algorithm>
#include <system_error>
#include <vector>

#include "base/error.h"
#include "foreign/file_numbers.h"

namespace fumon {

namespace {

namespace fs = std::filesystem;

bool lies_at(const fs::path& file) {
    std::error_code fault;
    return fs::exists(file, fault);
}

bool has_files(const std::string& pattern) {
    try {
        return is_pattern(pattern) && !files_of_pattern(pattern).empty();
    } catch (const InputError&) {
        return false;
    }
}

/// A field's own file where it lies now: as it was named, else in the folder of the run.
std::string field_in(const fs::path& folder, const std::string& field) {
    const std::size_t begin = field.find('=') + 1;
    const std::string source = field.substr(begin);
    const std::string file = source.substr(0, source.rfind(':'));
    if (lies_at(source) || lies_at(file) || has_files(source)) return field;
    for (const fs::path& there : {folder / source, folder / fs::path(source).filename()}) {
        const std::string name = there.string();
        if (lies_at(name) || lies_at(name.substr(0, name.rfind(':'))) || has_files(name))
            return field.substr(0, begin) + name;
    }
    return field;
}

fs::path name_of(const InputFile& file) {
    return fs::path(file.path).filename();
}

std::string not_as_it_was(const std::string& file, std::string_view what) {
    return fmt::format("{0}: is not the file that the {1} was made of: its content has changed",
                       file, what);
}

/// The first file that is not as it was, in a sentence; empty where all are, and there are no
/// others.
std::string difference_of(const std::vector<InputFile>& then, const std::vector<InputFile>& now,
                          std::string_view what) {
    const auto is_named = [](const std::vector<InputFile>& files, const InputFile& one) {
        return std::ranges::count(files, name_of(one), name_of) > 0;
    };
    const auto is_in = [](const std::vector<InputFile>& files, const InputFile& one) {
        return std::ranges::any_of(files, [&](const InputFile& other) {
            return other.hash == one.hash && name_of(other) == name_of(one);
        });
    };
    for (const InputFile& file : now) {
        if (is_in(then, file)) continue;
        if (is_named(then, file)) return not_as_it_was(file.path, what);
        return fmt::format("{}: is none of the files that the {} was made of", file.path, what);
    }
    for (const InputFile& file : then)
        if (!is_in(now, file))
            return fmt::format("{}: is one of the files that the {} was made of, and is missing",
                               name_of(file).string(), what);
    return {};
}

/// What keeps files from being opened that are in part in a folder.
std::string fault_in(const fs::path& folder, const RecordedResults& results,
                     std::string_view what) {
    for (const InputFile& file : results.files)
        if (!lies_at(file.path) && !lies_at(folder / name_of(file)))
            return fmt::format(
                "{}: is one of the files that the {} was made of, and is missing; copy it there",
                (folder / name_of(file)).string(), what);
    return not_as_it_was((folder / results.name).string(), what);
}

std::vector<fs::path> folders_of(const RecordedResults& results, const fs::path& picture) {
    const fs::path then = fs::path(results.files.front().path).parent_path();
    const fs::path beside = picture.parent_path();
    std::vector<fs::path> folders;
    for (const fs::path& folder : {then, beside, beside / then, fs::path()})
        if (std::ranges::find(folders, folder) == folders.end()) folders.push_back(folder);
    return folders;
}

StoredBeds opened_in(const fs::path& folder, const std::string& argument,
                     const RecordedResults& results, int threads) {
    ForeignQuery query = results.query;
    for (std::string& field : query.fields) field = field_in(folder, field);
    return StoredBeds::of_files(argument, threads, {}, query);
}

}  // namespace

StoredBeds results_again(const RecordedResults& results, const ResultsAsked& asked,
                         StatusLine& status) {
    if (!asked.from.empty()) {
        StoredBeds beds =
            opened_in(fs::path(asked.from).parent_path(), asked.from, results, asked.threads);
        const std::string differs = difference_of(results.files, beds.inputs(), asked.what);
        // Of those that a picture does not list nothing is known.
        if (!differs.empty() && !results.files.empty()) status.note(differs);
        return beds;
    }
    if (results.files.empty())
        throw InputError(fmt::format(
            "{}: was made of {}, whose files it does not name; give them by --from FILE",
            asked.picture.string(), results.name));
    std::string fault;
    for (const fs::path& folder : folders_of(results, asked.picture)) {
        const bool is_here = std::ranges::any_of(results.files, [&](const InputFile& file) {
            return lies_at(folder / fs::path(file.path).filename());
        });
        if (!is_here) continue;
        const std::string argument = (folder / results.name).string();
        std::string differs;
        try {
            StoredBeds beds = opened_in(folder, argument, results, asked.threads);
            differs = difference_of(results.files, beds.inputs(), asked.what);
            if (differs.empty()) return beds;
            differs += fmt::format("; --from {} takes {}", argument,
                                   beds.inputs().size() == 1 ? "it" : "those that are there");
        } catch (const InputError&) {
            // What a changed file holds is not told to a picture of unknown origin.
            differs = fault_in(folder, results, asked.what);
        }
        if (fault.empty()) fault = differs;
    }
    if (!fault.empty()) throw InputError(fault);
    throw InputError(
        fmt::format("{}: {}, of which the {} was made, is missing; copy it beside the {}, or name "
                    "it by --from FILE",
                    asked.picture.string(), results.name, asked.what, asked.what));
}

}  // namespace fumon
