#pragma once

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "support/preload/call_log.h"
#include "support/program.h"

namespace fumon::test {

/// What a disk may hold after the power failed, from a log of what was done to it.
///
/// What was synced is there. Of what was not, the changes of each file are there or not, all
/// together or each by itself, a write perhaps by half; and of each folder's names those up to some
/// change, whatever is there of the files and of other folders.
class CrashedDisk {
  public:
    /// `before`: a folder as it was, all on disk, before the calls.
    explicit CrashedDisk(const std::filesystem::path& before) : root_(read_folder(before)) {}

    /// Goes on by one call.
    void take(const LoggedCall& call) {
        switch (call.call) {
            case Call::create:
                create(call);
                break;
            case Call::write:
            case Call::truncate:
                if (const FilePointer file = file_of(call)) file->changes.push_back(call);
                break;
            case Call::sync:
                sync(call);
                break;
            case Call::folder:
                link(call.path, {std::make_shared<Folder>(), nullptr});
                break;
            case Call::rename:
                rename(call);
                break;
            case Call::remove:
                link(call.path, {});
                break;
            default:
                break;
        }
    }

    /// Makes the folder as the power failure leaves it. `kept` is the chance of each change that
    /// was not synced to be there: with 0 nothing is, with 1 all.
    void write_to(const std::filesystem::path& target, double kept, std::mt19937& random) const {
        write_folder(*root_, target, kept, random);
    }

  private:
    struct Folder;
    struct File {
        std::string before;
        std::vector<LoggedCall> changes;
        std::size_t synced = 0;
    };
    using FilePointer = std::shared_ptr<File>;
    using FolderPointer = std::shared_ptr<Folder>;
    struct Entry {
        FolderPointer folder;
        FilePointer file;
    };
    struct Change {
        std::vector<std::pair<std::string, Entry>> names;  ///< an empty entry: the name goes
    };
    struct Folder {
        std::vector<Change> changes;
        std::size_t synced = 0;

        [[nodiscard]] std::map<std::string, Entry> names(std::size_t count) const {
            std::map<std::string, Entry> all;
            for (std::size_t i = 0; i < count; ++i) {
                for (const auto& [name, entry] : changes[i].names) {
                    all.erase(name);
                    if (entry.folder || entry.file) all[name] = entry;
                }
            }
            return all;
        }
    };

    static FolderPointer read_folder(const std::filesystem::path& from) {
        auto folder = std::make_shared<Folder>();
        for (const auto& entry : std::filesystem::directory_iterator(from)) {
            Entry made;
            if (entry.is_directory()) {
                made.folder = read_folder(entry.path());
            } else {
                made.file = std::make_shared<File>();
                made.file->before = read_text(entry.path());
            }
            folder->changes.push_back({{{entry.path().filename().string(), made}}});
        }
        folder->synced = folder->changes.size();
        return folder;
    }

    [[nodiscard]] Entry find(const std::string& path) const {
        Entry at{root_, nullptr};
        for (const auto& part : std::filesystem::path(path)) {
            if (!at.folder) return {};
            const auto names = at.folder->names(at.folder->changes.size());
            const auto found = names.find(part.string());
            if (found == names.end()) return {};
            at = found->second;
        }
        return at;
    }

    [[nodiscard]] FolderPointer folder_of(const std::string& path) const {
        return find(std::filesystem::path(path).parent_path().string()).folder;
    }
    static std::string name_in(const std::string& path) {
        return std::filesystem::path(path).filename().string();
    }

    void link(const std::string& path, const Entry& entry) {
        const FolderPointer folder = folder_of(path);
        if (folder) folder->changes.push_back({{{name_in(path), entry}}});
    }

    void create(const LoggedCall& call) {
        Entry entry = find(call.path);
        if (!entry.file) {
            entry.file = std::make_shared<File>();
            link(call.path, entry);
        }
        open_[call.file] = entry.file;
    }

    [[nodiscard]] FilePointer file_of(const LoggedCall& call) const {
        const auto found = open_.find(call.file);
        return found != open_.end() ? found->second : find(call.path).file;
    }

    void sync(const LoggedCall& call) {
        if (const FilePointer file = file_of(call)) {
            file->synced = file->changes.size();
        } else if (const FolderPointer folder = find(call.path).folder) {
            folder->synced = folder->changes.size();
        }
    }

    void rename(const LoggedCall& call) {
        const Entry entry = find(call.path);
        const FolderPointer from = folder_of(call.path);
        const FolderPointer to = folder_of(call.other);
        if (from == nullptr || to == nullptr) return;
        if (from == to) {
            from->changes.push_back({{{name_in(call.path), {}}, {name_in(call.other), entry}}});
        } else {
            to->changes.push_back({{{name_in(call.other), entry}}});
            from->changes.push_back({{{name_in(call.path), {}}}});
        }
    }

    static std::string bytes_of(const File& file, double kept, std::mt19937& random) {
        std::uniform_real_distribution<double> chance(0.0, 1.0);
        std::string bytes = file.before;
        if (kept < 1.0 && chance(random) < 0.5) kept = chance(random) < kept ? 1.0 : 0.0;
        for (std::size_t i = 0; i < file.changes.size(); ++i) {
            const LoggedCall& change = file.changes[i];
            const bool synced = i < file.synced;
            if (!synced && chance(random) >= kept) continue;
            const auto offset = static_cast<std::size_t>(change.offset);
            if (change.call == Call::truncate) {
                bytes.resize(offset);
                continue;
            }
            const bool torn = !synced && kept < 1.0 && chance(random) < 0.2;
            const std::size_t count = torn ? change.data.size() / 2 : change.data.size();
            if (bytes.size() < offset + count) bytes.resize(offset + count);
            std::copy_n(change.data.begin(), count,
                        bytes.begin() + static_cast<std::ptrdiff_t>(offset));
        }
        return bytes;
    }

    static void write_folder(const Folder& folder, const std::filesystem::path& target, double kept,
                             std::mt19937& random) {
        std::filesystem::create_directories(target);
        const std::size_t unsynced = folder.changes.size() - folder.synced;
        std::size_t count = folder.synced;
        if (kept >= 1.0) {
            count += unsynced;
        } else if (kept > 0.0) {
            count += std::uniform_int_distribution<std::size_t>(0, unsynced)(random);
        }
        for (const auto& [name, entry] : folder.names(count)) {
            if (entry.folder) {
                write_folder(*entry.folder, target / name, kept, random);
            } else {
                write_text(target / name, bytes_of(*entry.file, kept, random));
            }
        }
    }

    FolderPointer root_;
    std::map<std::int64_t, FilePointer> open_;
};

}  // namespace fumon::test
