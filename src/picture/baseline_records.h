#pragma once

#include <toml++/toml.h>

#include <filesystem>
#include <map>
#include <string>
#include <string_view>

#include "keys/assign.h"
#include "keys/keys.h"
#include "picture/environment.h"
#include "picture/fingerprint.h"

namespace fumon {

/// What a picture under test looked like when it was accepted.
struct BaselineRecord {
    std::string fumon;  ///< the version that drew it
    RenderingEnvironment environment;
    std::string state;  ///< SHA-256 of the model's state, hexadecimal; empty where none made it
    Fingerprint fingerprint;  ///< with ignored pixels grey, as blanked()
    std::string ignored{};    ///< IgnoredPixels::hash(); empty where none is
    /// SHA-256 of the pixels without overlays, hexadecimal; empty where there are none.
    std::string under_overlays{};
};

/// By the pictures' names.
using BaselineRecords = std::map<std::string, BaselineRecord>;

/// Whether pictures under test may be called so: letters, digits, "-" and "_", at most 100.
bool good_picture_name(std::string_view name);

/// Whether a lock of `fumon verify` may call a record so: as a picture, or as that of an
/// environment (see record_name()).
bool good_record_name(std::string_view name);

/// The record in the section [recorded.NAME]. Throws InputError, located.
BaselineRecord read_record(const std::string& name, const toml::node& section,
                           const Locate& locate);

/// That section, ended.
std::string record_text(const std::string& name, const BaselineRecord& record);

/// Sets keys from a section of TOML, but for sections in it that others read. Throws InputError,
/// located, for keys that are not in the table.
void read_known_keys(const toml::table& from, const std::string& prefix, const KeyTable& table,
                     const Locate& locate, std::initializer_list<std::string_view> others = {});

/// Who keeps a lock: a file of records and nothing else, beside what it is about.
enum class LockOwner {
    verify,  ///< `fumon verify`: NAME.lock beside the baseline NAME.toml
    pytest,  ///< the plugin: pictures.lock beside the tests
};

/// The records of a lock; none where there is no such file. Throws InputError
/// "file:line:column: what is wrong; what would be right", also where the other owner wrote it.
BaselineRecords read_lock(const std::filesystem::path& file, LockOwner owner);

/// The same of the lock's text.
BaselineRecords parse_lock(const std::string& text, const std::filesystem::path& file,
                           LockOwner owner);

/// A lock with these records, by name. Read again it gives the same.
std::string lock_text(const BaselineRecords& records, LockOwner owner);

}  // namespace fumon
