#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace fumon::test {

/// What a program does to files and folders.
enum class Call : std::uint8_t {
    open,    ///< of a file that is there, or a folder
    create,  ///< an open that makes a file; in a log also one that writes to a file
    read,
    write,
    sync,
    truncate,
    allocate,
    close,
    rename,
    link,
    remove,
    folder,  ///< is made
};

inline const char* name_of(Call call) {
    constexpr std::array<const char*, 12> names{"open",   "create",   "read",     "write",
                                                "sync",   "truncate", "allocate", "close",
                                                "rename", "link",     "remove",   "mkdir"};
    return names.at(static_cast<std::size_t>(call));
}

/// What the preloaded library tells of a program's calls, while it runs and after.
struct CallReport {
    std::int64_t calls = 0;
    std::int64_t failed = 0;  ///< the number of the first that was made to fail; 0: none was
    char what[240] = {};      ///< that one: "write /out/run.json.part"
};

/// A call that changed something, paths relative to the folder that is watched.
struct LoggedCall {
    Call call = Call::open;
    std::string path;
    std::string other;        ///< to which it is renamed or linked
    std::int64_t file = 0;    ///< number of the open file, from 1; 0: of none
    std::int64_t offset = 0;  ///< of a write; a truncated length; 1 of a create that makes the file
    std::string data;
    std::int64_t count = 0;
};

/// As bytes: the length of what follows, then call, lengths of path, other and data, file, offset,
/// path, other, data; numbers as the machine has them.
inline std::string entry_of(const LoggedCall& logged) {
    std::string bytes;
    const auto put = [&](std::int64_t number) {
        bytes.append(reinterpret_cast<const char*>(&number), sizeof number);
    };
    put(static_cast<std::int64_t>(logged.call));
    put(static_cast<std::int64_t>(logged.path.size()));
    put(static_cast<std::int64_t>(logged.other.size()));
    put(static_cast<std::int64_t>(logged.data.size()));
    put(logged.file);
    put(logged.offset);
    return bytes + logged.path + logged.other + logged.data;
}

inline std::vector<LoggedCall> calls_of_log(std::string_view bytes) {
    std::vector<LoggedCall> calls;
    const auto take = [&](std::int64_t count) {
        if (count < 0 || static_cast<std::size_t>(count) > bytes.size())
            throw std::runtime_error("the log of calls is cut off");
        const auto taken = bytes.substr(0, static_cast<std::size_t>(count));
        bytes.remove_prefix(taken.size());
        return taken;
    };
    const auto number = [&] {
        std::int64_t value = 0;
        std::memcpy(&value, take(sizeof value).data(), sizeof value);
        return value;
    };
    while (!bytes.empty()) {
        LoggedCall logged;
        logged.call = static_cast<Call>(number());
        const std::int64_t path = number();
        const std::int64_t other = number();
        logged.count = number();
        logged.file = number();
        logged.offset = number();
        logged.path = take(path);
        logged.other = take(other);
        logged.data = take(logged.count);
        calls.push_back(std::move(logged));
    }
    return calls;
}

}  // namespace fumon::test
