#include "film/cache/picture_cache.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <exception>
#include <system_error>
#include <vector>

#include "base/error.h"
#include "base/thread_clock.h"
#include "files/atomic_file.h"
#include "files/hash.h"
#include "files/input_file.h"
#include "film/cache/byte_size.h"

namespace fumon {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view picture_ending = ".picture";
constexpr std::int64_t usual_cache_bytes = 4'000'000'000;
constexpr std::uintmax_t most_left_free = 1'000'000'000;  // bytes of the disk, for what films write
constexpr std::uintmax_t part_left_free = 20;             // of it, at most
constexpr std::int64_t pictures_between_clearings = 64;   // for what other programs add

struct KeptFile {
    fs::file_time_type used;
    fs::path file;
    std::int64_t bytes = 0;
};

/// All files of a folder; those that another program deletes meanwhile left out.
std::vector<KeptFile> kept_files(const fs::path& folder) {
    std::vector<KeptFile> files;
    std::error_code fault;
    for (auto entry = fs::directory_iterator(folder, fault);
         !fault && entry != fs::directory_iterator(); entry.increment(fault)) {
        std::error_code gone;
        if (entry->path().filename().string().find(picture_ending) == std::string::npos) continue;
        const auto bytes = entry->file_size(gone);
        const auto used = gone ? fs::file_time_type() : entry->last_write_time(gone);
        if (!gone) files.push_back({used, entry->path(), static_cast<std::int64_t>(bytes)});
    }
    return files;
}

/// A variable's value; empty where it is not set.
std::string variable(const char* name) {
    const char* value = std::getenv(name);
    return value == nullptr ? "" : value;
}

}  // namespace

PictureCache::PictureCache(fs::path folder, std::int64_t most_bytes)
    : folder_(std::move(folder)),
      most_bytes_(most_bytes),
      waiting_(2),
      thread_([this] { work(); }) {}

PictureCache::~PictureCache() {
    end();
}

fs::path PictureCache::file_of(const Sha256& key) const {
    return folder_ / (hex(key) + std::string(picture_ending));
}

bool PictureCache::holds(const Sha256& key) const {
    std::error_code fault;
    return fs::is_regular_file(file_of(key), fault);
}

void PictureCache::take_as_own(const fs::path& file) {
    const std::lock_guard lock(mutex_);
    own_.insert(file.filename().string());
}

bool PictureCache::is_own(const std::string& name) const {
    const std::lock_guard lock(mutex_);
    return own_.contains(name);
}

std::optional<CachedPicture> PictureCache::find(const Sha256& key) {
    if (!holds(key)) return std::nullopt;
    const fs::path file = file_of(key);
    try {
        const std::string bytes = read_input_file(file);
        std::optional<CachedPicture> picture = decode_cached_picture(
            {reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()}, key);
        if (!picture) return std::nullopt;
        std::error_code fault;
        fs::last_write_time(file, fs::file_time_type::clock::now(), fault);
        take_as_own(file);
        const std::lock_guard lock(mutex_);
        ++use_.found;
        return picture;
    } catch (const std::exception&) {
        return std::nullopt;  // deleted meanwhile, or too large for the memory that there is
    }
}

void PictureCache::add(const Sha256& key, CachedPicture picture) {
    {
        const std::lock_guard lock(mutex_);
        ++use_.drawn;
        if (use_.full || !picture.image.rgb16.empty()) return;
    }
    waiting_.push({key, std::move(picture)});
}

std::int64_t PictureCache::drawn() const {
    const std::lock_guard lock(mutex_);
    return use_.drawn;
}

void PictureCache::work() {
    name_this_thread("fumon-cache");
    while (const std::optional<Waiting> waiting = waiting_.pop()) {
        try {
            write(*waiting);
        } catch (const std::exception&) {
            const std::lock_guard lock(mutex_);
            use_.full = true;
        }
    }
}

void PictureCache::write(const Waiting& waiting) {
    {
        const std::lock_guard lock(mutex_);
        if (use_.full) return;
    }
    const std::vector<std::uint8_t> bytes = encode_cached_picture(waiting.second, waiting.first);
    if (!make_room(static_cast<std::int64_t>(bytes.size()))) {
        const std::lock_guard lock(mutex_);
        use_.full = true;
        return;
    }
    if (!fs::exists(folder_)) {
        fs::create_directories(folder_);
        fs::permissions(folder_, fs::perms::owner_all);
        write_file(folder_ / "CACHEDIR.TAG",
                   "Signature: 8a477f597d28d172789f06886806bc55\n"
                   "# Pictures that fumon keeps for films; they can be deleted at any time.\n");
    }
    const fs::path file = file_of(waiting.first);
    take_as_own(file);
    // Two programs may be writing the same one.
    const fs::path unfinished = fmt::format("{}-{}", file.string(), ::getpid());
    write_file(unfinished, bytes);
    fs::rename(unfinished, file);
    known_bytes_ += static_cast<std::int64_t>(bytes.size());
}

/// Whether there is room for a file, once some that this film has not used are deleted.
bool PictureCache::make_room(std::int64_t bytes) {
    std::error_code fault;
    const fs::space_info space = fs::space(fs::exists(folder_, fault) ? folder_ : "/", fault);
    const std::uintmax_t left_free = std::min(most_left_free, space.capacity / part_left_free);
    if (!fault && space.available < left_free + static_cast<std::uintmax_t>(bytes)) return false;
    if (--until_next_look_ > 0 && known_bytes_ + bytes <= most_bytes_) return true;
    until_next_look_ = pictures_between_clearings;
    std::vector<KeptFile> files = kept_files(folder_);
    known_bytes_ = 0;
    for (const KeptFile& file : files) known_bytes_ += file.bytes;
    std::ranges::sort(files, {}, &KeptFile::used);
    for (const KeptFile& file : files) {
        if (known_bytes_ + bytes <= most_bytes_) break;
        if (is_own(file.file.filename().string())) continue;
        fs::remove(file.file, fault);
        known_bytes_ -= file.bytes;
    }
    return known_bytes_ + bytes <= most_bytes_;
}

void PictureCache::end() {
    waiting_.close();
    if (thread_.joinable()) thread_.join();
}

CacheUse PictureCache::finish() {
    end();
    return use_;
}

std::optional<fs::path> picture_cache_folder() {
    const fs::path cache = variable("XDG_CACHE_HOME");
    if (cache.is_absolute()) return cache / "fumon" / "pictures";
    const fs::path home = variable("HOME");
    if (home.is_absolute()) return home / ".cache" / "fumon" / "pictures";
    return std::nullopt;
}

std::int64_t picture_cache_bytes() {
    const std::string text = variable("FUMON_CACHE_SIZE");
    if (text.empty()) return usual_cache_bytes;
    if (text == "0") return 0;
    return bytes_of_size(text, "FUMON_CACHE_SIZE");
}

std::int64_t clear_picture_cache(const fs::path& folder) {
    std::int64_t bytes = 0;
    for (const KeptFile& file : kept_files(folder)) {
        std::error_code fault;
        fs::remove(file.file, fault);
        if (fault) {
            throw Error(
                fmt::format("{} cannot be deleted: {}", file.file.string(), fault.message()));
        }
        bytes += file.bytes;
    }
    return bytes;
}

}  // namespace fumon
