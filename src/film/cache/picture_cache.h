#pragma once

#include <cstdint>
#include <filesystem>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <thread>
#include <utility>

#include "base/sha256.h"
#include "film/cache/cached_picture.h"
#include "run/bounded_queue.h"

namespace fumon {

/// What a cache has done for a film.
struct CacheUse {
    std::int64_t found = 0;  ///< pictures that were there
    std::int64_t drawn = 0;  ///< pictures that were not
    bool full = false;       ///< whether it had no room for some of these
};

/// Pictures that films have drawn, in a folder of bounded size, each under a key of all that
/// decides it. Several programs may use it at once. What cannot be read is drawn anew, and what
/// cannot be written is not kept: a cache never stops a film.
class PictureCache {
  public:
    /// Where more than `most_bytes` would lie in the folder, those go that were used least recently
    /// and not by this film.
    PictureCache(std::filesystem::path folder, std::int64_t most_bytes);
    ~PictureCache();  ///< writes what waits first
    PictureCache(const PictureCache&) = delete;
    PictureCache& operator=(const PictureCache&) = delete;

    [[nodiscard]] bool holds(const Sha256& key) const;
    /// The picture of a key, which counts as used now; nothing where there is none.
    std::optional<CachedPicture> find(const Sha256& key);
    /// Keeps a picture, on a thread of its own; where that has too much to do, it waits.
    void add(const Sha256& key, CachedPicture picture);
    /// How many pictures were added so far.
    [[nodiscard]] std::int64_t drawn() const;
    /// Once all that was added is written.
    CacheUse finish();

  private:
    using Waiting = std::pair<Sha256, CachedPicture>;

    [[nodiscard]] std::filesystem::path file_of(const Sha256& key) const;
    void work();
    void end();
    void write(const Waiting& waiting);
    [[nodiscard]] bool make_room(std::int64_t bytes);
    [[nodiscard]] bool is_own(const std::string& name) const;
    void take_as_own(const std::filesystem::path& file);

    std::filesystem::path folder_;
    std::int64_t most_bytes_;
    std::int64_t known_bytes_ = 0;      ///< in the folder, when it was last looked at, and since
    std::int64_t until_next_look_ = 0;  ///< pictures that are written before that
    mutable std::mutex mutex_;          ///< of what follows
    std::set<std::string> own_;         ///< names of files that this film has used
    CacheUse use_;
    BoundedQueue<Waiting> waiting_;
    std::jthread thread_;  // last: it uses the others
};

/// Where pictures are kept: $XDG_CACHE_HOME/fumon/pictures, else ~/.cache/fumon/pictures. None
/// where neither is known.
std::optional<std::filesystem::path> picture_cache_folder();

/// How many bytes they may take: $FUMON_CACHE_SIZE, "8GB" or 0 for none, else 4 GB. Throws
/// InputError for another text.
std::int64_t picture_cache_bytes();

/// Deletes all of them. Returns how many bytes they took. Throws Error where that fails.
std::int64_t clear_picture_cache(const std::filesystem::path& folder);

}  // namespace fumon
