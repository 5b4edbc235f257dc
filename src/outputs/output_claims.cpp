#include "outputs/output_claims.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <optional>
#include <string>
#include <system_error>
#include <utility>

#include "base/error.h"
#include "files/atomic_file.h"
#include "outputs/own_file.h"

namespace fumon {

namespace {

namespace fs = std::filesystem;

bool is_there(const fs::path& file) {
    std::error_code fault;
    return fs::exists(file, fault);
}

/// Also a link to nothing.
bool has_name(const fs::path& file) {
    std::error_code fault;
    return is_there(file) || fs::is_symlink(file, fault);
}

/// Whether something other than a file or folder lies there: a pipe or a device.
bool is_special(const fs::path& file) {
    std::error_code fault;
    return fs::is_other(file, fault);
}

/// Device and number of a file on it, however it is called; nothing where there is none.
std::optional<std::pair<std::uint64_t, std::uint64_t>> identity(const fs::path& file) {
    struct stat status {};
    if (::stat(file.c_str(), &status) != 0) return std::nullopt;
    return std::pair<std::uint64_t, std::uint64_t>{status.st_dev, status.st_ino};
}

/// Whether two paths lead, or will lead, to one file.
bool same_file(const fs::path& one, const fs::path& other) {
    std::error_code fault;
    if (identity(one) || identity(other)) return identity(one) == identity(other);
    const auto whole = [&fault](const fs::path& file) {
        return fs::weakly_canonical(fs::absolute(file, fault), fault);
    };
    return whole(one) == whole(other);
}

/// Makes an empty file in a folder and takes it away again; returns 0 or an errno value. The file
/// has no name where the file system can do that, so that a kill in between leaves nothing.
int try_to_write_in(const fs::path& folder) {
#ifdef O_TMPFILE
    const int nameless = ::open(folder.c_str(), O_TMPFILE | O_WRONLY | O_CLOEXEC, 0600);
    if (nameless >= 0) {
        ::close(nameless);
        return 0;
    }
    if (errno != EOPNOTSUPP && errno != EISDIR && errno != EINVAL) return errno;
#endif
    std::string name = (folder / ".fumon-XXXXXX").string();
    const int descriptor = ::mkstemp(name.data());
    if (descriptor < 0) return errno;
    ::close(descriptor);
    ::unlink(name.c_str());
    return 0;
}

void check_writable(const fs::path& file) {
    if (!is_special(file)) {
        const AtomicFile made_and_taken_away(file);
    } else if (::access(file.c_str(), W_OK) != 0) {
        refuse_to_write(file, errno);
    }
}

}  // namespace

void refuse_to_replace(const fs::path& file) {
    throw InputError(
        fmt::format("{}: already exists and was not made by fumon; name another output, or replace "
                    "it with --force",
                    file.string()));
}

void refuse_to_replace_input(const fs::path& file) {
    throw InputError(
        fmt::format("{} is an input and would be replaced; write to another file", file.string()));
}

void OutputClaims::reads(const fs::path& file) {
    if (const auto found = identity(file)) inputs_.push_back(*found);
}

void OutputClaims::reads(const std::vector<fs::path>& files) {
    for (const fs::path& file : files) reads(file);
}

bool OutputClaims::is_read(const fs::path& file) const {
    const auto found = identity(file);
    return found && std::ranges::find(inputs_, *found) != inputs_.end();
}

void OutputClaims::check(const fs::path& file, bool listed) const {
    std::error_code fault;
    if (fs::is_directory(file, fault))
        throw InputError(fmt::format("{}: is a folder; name a file", file.string()));
    if (is_special(file)) return;
    if (is_read(file)) refuse_to_replace_input(file);
    const fs::path temporary = temporary_name(resolved_link(file));
    if (is_read(temporary)) refuse_to_replace_input(temporary);
    if (force_ || listed) return;
    for (const fs::path& present : {file, temporary}) {
        if (has_name(present) && !is_made_by_fumon(present)) refuse_to_replace(present);
    }
}

void OutputClaims::writes(const fs::path& file, bool listed) {
    check(file, listed);
    for (const fs::path& other : outputs_) {
        if (!is_special(file) && same_file(file, other)) {
            throw InputError(fmt::format("two outputs are both called {}; give each its own file",
                                         file.string()));
        }
    }
    check_writable(file);
    outputs_.push_back(file);
}

std::string small_ending(const fs::path& file) {
    std::string ending = file.extension().string();
    for (char& letter : ending) {
        if (letter >= 'A' && letter <= 'Z') letter = static_cast<char>(letter - 'A' + 'a');
    }
    return ending;
}

void check_ending(const fs::path& file, std::string_view what,
                  std::span<const std::string_view> endings) {
    if (is_special(file) || std::ranges::find(endings, small_ending(file)) != endings.end()) return;
    throw InputError(fmt::format("{}: the name of {} must end in {}", file.string(), what,
                                 fmt::join(endings, ", ")));
}

void check_output_folder(const fs::path& folder, std::string_view what) {
    std::error_code fault;
    if (folder.empty()) throw InputError(fmt::format("name a folder for {} with -o", what));
    if (same_file(folder, "/")) {
        throw InputError(
            fmt::format("{} is the root of the file system; name a folder for {} with -o",
                        folder.string(), what));
    }
    if (is_there(folder) && !fs::is_directory(folder, fault)) {
        throw InputError(
            fmt::format("{} is a file; name a folder for {} with -o", folder.string(), what));
    }
    fs::path above = fs::absolute(folder, fault);
    while (!is_there(above) && above.has_relative_path()) {
        if (fs::is_symlink(above, fault)) {
            throw Error(fmt::format("cannot make the folder {}: {} is a link to nothing",
                                    folder.string(), above.string()));
        }
        above = above.parent_path();
    }
    if (!fs::is_directory(above, fault)) {
        throw Error(
            fmt::format("cannot make the folder {}: a file of this name exists", folder.string()));
    }
    const int reason = try_to_write_in(above);
    if (reason == 0) return;
    throw Error(fmt::format("{} {}: {}",
                            is_there(folder) ? "cannot write in" : "cannot make the folder",
                            folder.string(), std::generic_category().message(reason)));
}

}  // namespace fumon
