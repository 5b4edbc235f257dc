#include "film/results_again.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <exception>
#include <optional>
#include <system_error>
#include <utility>
#include <vector>

#include "base/error.h"
#include "files/terrain/raster_trust.h"
#include "foreign/file_numbers.h"
#include "foreign/open_run.h"
#include "run/inputs/find_input.h"

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

/// The first file that is missing in a folder, in a sentence; empty where none is.
std::string missing_in(const fs::path& folder, const RecordedResults& results,
                       std::string_view what) {
    for (const InputFile& file : results.files)
        if (!lies_at(file.path) && !lies_at(folder / name_of(file)))
            return fmt::format("{}: is one of the files that the {} was made of, and is missing",
                               (folder / name_of(file)).string(), what);
    return {};
}

/// A file with its hash as it would be recorded; without one where it cannot be read.
InputFile as_it_is(const fs::path& file) {
    std::error_code fault;
    if (!fs::is_regular_file(file, fault)) return {file.string(), ""};
    try {
        return {file.string(), results_hash(file)};
    } catch (const std::exception&) {
        return {file.string(), ""};
    }
}

std::vector<fs::path> folders_of(const RecordedResults& results, const fs::path& picture) {
    const fs::path then = fs::path(results.files.front().path).parent_path();
    const fs::path beside = picture.parent_path();
    std::vector<fs::path> folders;
    for (const fs::path& folder : {then, beside, beside / then, fs::path()})
        if (std::ranges::find(folders, folder) == folders.end()) folders.push_back(folder);
    return folders;
}

ForeignQuery query_in(const fs::path& folder, const RecordedResults& results) {
    ForeignQuery query = results.query;
    for (std::string& field : query.fields) field = field_in(folder, field);
    return query;
}

/// Refuses files that may name others, unless their user trusts the picture.
void check_formats(const std::vector<InputFile>& files, const ResultsAsked& asked) {
    if (asked.trust) return;
    for (const InputFile& file : files) {
        const std::string why = why_trust_is_needed(file.path);
        if (!why.empty())
            throw InputError(
                fmt::format("{}: is read only with --trust, since {}: fumon again --trust {}",
                            file.path, why, asked.picture.string()));
    }
}

/// The files that a user gives; those that the picture names for its fields lie beside them, or are
/// as the picture lists them.
StoredBeds given_results(const RecordedResults& results, const ResultsAsked& asked) {
    const fs::path folder = fs::path(asked.from).parent_path();
    const ForeignQuery query = query_in(folder, results);
    const std::size_t given = files_of_foreign_run(asked.from, {}).size();
    const std::vector<fs::path> files = files_of_foreign_run(asked.from, query);
    std::vector<InputFile> named;
    for (std::size_t i = given; i < files.size(); ++i) {
        named.push_back(as_it_is(files[i]));
        const bool is_beside =
            files[i].lexically_normal().parent_path() == folder.lexically_normal();
        const bool is_listed =
            std::ranges::count(results.files, named.back().hash, &InputFile::hash) > 0;
        if (asked.trust || is_beside || is_listed) continue;
        throw InputError(fmt::format(
            "{}: takes a field from {}, which is not one of the files that it lists; copy a file "
            "of this name beside {}, or trust the {}: --trust",
            asked.picture.string(), files[i].string(), asked.from, asked.what));
    }
    check_formats(named, asked);
    return StoredBeds::of_files(asked.from, asked.threads, {}, query);
}

/// What is found in a folder: the run, or why it is not opened.
struct FoundResults {
    std::optional<StoredBeds> beds;
    std::string fault;
};

FoundResults results_in(const fs::path& folder, const RecordedResults& results,
                        const ResultsAsked& asked) {
    const std::string argument = (folder / results.name).string();
    std::vector<InputFile> now;
    ForeignQuery query;
    try {
        query = query_in(folder, results);
        for (const fs::path& file : files_of_foreign_run(argument, query))
            now.push_back(as_it_is(file));
    } catch (const InputError&) {
        const std::string missing = missing_in(folder, results, asked.what);
        if (missing.empty()) return {{}, not_as_it_was(argument, asked.what)};
        return {{}, missing + "; copy it there"};
    }
    const std::string differs = difference_of(results.files, now, asked.what);
    const std::string missing = differs.empty() ? "" : missing_in(folder, results, asked.what);
    if (!missing.empty()) return {{}, missing + "; copy it there"};
    if (!differs.empty())
        return {{},
                fmt::format("{}; --from {} takes {}", differs, argument,
                            now.size() == 1 ? "it" : "those that are there")};
    check_formats(now, asked);
    try {
        return {StoredBeds::of_foreign_files(argument, query), ""};
    } catch (const InputError&) {
        if (asked.trust) throw;
        // What a file holds is not told to a picture of unknown origin.
        throw InputError(
            fmt::format("{}: is the file that the {} was made of, but cannot be read as the {} "
                        "says; --trust gives details",
                        argument, asked.what, asked.what));
    }
}

void keep_limits(StoredBeds& beds, const RecordedResults& results, const ResultsAsked& asked) {
    if (asked.trust) return;
    std::vector<InputFile> listed = results.files;
    listed.insert(listed.end(), asked.others.begin(), asked.others.end());
    beds.distrust(hashes_of(listed));
}

}  // namespace

StoredBeds results_again(const RecordedResults& results, const ResultsAsked& asked,
                         StatusLine& status) {
    if (!asked.from.empty()) {
        StoredBeds beds = given_results(results, asked);
        const std::string differs = difference_of(results.files, beds.inputs(), asked.what);
        // Of those that a picture does not list nothing is known.
        if (!differs.empty() && !results.files.empty()) status.note(differs);
        keep_limits(beds, results, asked);
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
        FoundResults found = results_in(folder, results, asked);
        if (found.beds) {
            keep_limits(*found.beds, results, asked);
            return std::move(*found.beds);
        }
        if (fault.empty()) fault = found.fault;
    }
    if (!fault.empty()) throw InputError(fault);
    throw InputError(
        fmt::format("{}: {}, of which the {} was made, is missing; copy it beside the {}, or name "
                    "it by --from FILE",
                    asked.picture.string(), results.name, asked.what, asked.what));
}

}  // namespace fumon
