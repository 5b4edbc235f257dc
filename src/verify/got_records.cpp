#include "verify/got_records.h"

#include <fmt/format.h>

#include <optional>
#include <string_view>

#include "base/error.h"
#include "files/hash.h"
#include "files/input_file.h"
#include "outputs/own_file.h"
#include "picture/png.h"
#include "verify/page_pictures.h"

namespace fumon {

namespace {

namespace fs = std::filesystem;

/// The line that says of which baseline it is.
std::string first_line(const fs::path& baseline) {
    return one_line(fmt::format("{} of {}", own_result_mark,
                                baseline.lexically_normal().generic_string())) +
           "\n";
}

std::optional<GotPicture> read_got(const fs::path& file, const fs::path& baseline,
                                   const std::string& name) {
    const std::string text = read_input_file(file);
    if (!text.starts_with(first_line(baseline))) return std::nullopt;
    const BaselineRecords records = parse_lock(text, file, LockOwner::verify);
    const auto found = records.find(name);
    if (found == records.end()) return std::nullopt;
    return GotPicture{found->second, file.parent_path() / fmt::format("{}-{}.png", name, got_kind)};
}

}  // namespace

fs::path got_record_file(const fs::path& suite_folder, const std::string& name) {
    return suite_folder / (name + "-got.lock");
}

std::string got_record_text(const fs::path& baseline, const std::string& name,
                            const BaselineRecord& record) {
    return first_line(baseline) + lock_text({{name, record}}, LockOwner::verify);
}

GotPicture find_got_picture(const fs::path& folder, const fs::path& baseline,
                            const std::string& name) {
    std::optional<GotPicture> newest;
    fs::file_time_type when{};
    std::error_code fault;
    for (const auto& entry : fs::directory_iterator(folder, fault)) {
        const fs::path file = got_record_file(entry.path(), name);
        const auto written = fs::last_write_time(file, fault);
        if (fault || (newest && written < when)) continue;
        if (auto got = read_got(file, baseline, name)) {
            newest = std::move(got);
            when = written;
        }
    }
    if (!newest) {
        throw InputError(fmt::format(
            "the last results, {}, have no new picture of {} of {}; compare again, or name their "
            "folder with -o",
            folder.string(), name, baseline.string()));
    }
    if (pixel_hash(read_png(newest->file)) != newest->record.fingerprint.pixels) {
        throw InputError(fmt::format("{}: is not the picture that was compared; compare again",
                                     newest->file.string()));
    }
    return *newest;
}

}  // namespace fumon
