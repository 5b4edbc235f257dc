#include "picture/baseline_records.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "base/error.h"
#include "base/nearest_name.h"
#include "files/input_file.h"
#include "keys/key_value.h"
#include "keys/toml_text.h"
#include "picture/fingerprint_text.h"
#include "picture/named_environment.h"

namespace fumon {

namespace {

/// A record as its keys are bound.
struct RecordText {
    std::string fumon;
    RenderingEnvironment environment;
    std::string state;
    std::string ignored{};
    std::string under_overlays{};
    FingerprintText fingerprint{};

    void list_head_keys(const std::string& prefix, KeyTable& table) {
        table.text(prefix + "fumon", fumon, {.help = "version that drew it"});
        table.text(prefix + "backend", environment.backend, {.help = "osmesa, egl or cairo"});
        table.text(prefix + "renderer", environment.renderer, {.help = "what drew"});
        table.text(prefix + "gl_version", environment.gl_version, {.help = "of OpenGL"});
        table.text(prefix + "mesa_version", environment.mesa_version, {.help = "of Mesa"});
        table.text(prefix + "llvm_version", environment.llvm_version, {.help = "of LLVM"});
        table.boolean(prefix + "pinned", environment.pinned, {.help = "drawn with --pinned"});
        table.text(prefix + "state", state, {.help = "SHA-256 of the model's state"});
        table.text(prefix + "ignored", ignored, {.help = "SHA-256 of which pixels are ignored"});
        table.text(prefix + "under_overlays", under_overlays,
                   {.help = "SHA-256 of the pixels without overlays"});
    }
};

[[noreturn]] void refuse_unknown(const std::string& place, const std::string& path,
                                 const KeyTable& table) {
    std::vector<std::string> known;
    for (const Key& key : table.keys()) known.push_back(key.path);
    throw InputError(fmt::format("{}: unknown key {}; {}", place, path, suggestion(path, known)));
}

std::string first_line(LockOwner owner) {
    return fmt::format(
        "# Recorded by `{}`, which writes it anew. Commit it.\n",
        owner == LockOwner::verify ? "fumon verify --update" : "pytest --fumon-update");
}

/// Each would take the other's records for ones that nothing is about.
void refuse_lock_of_other(const std::string& text, const std::filesystem::path& file,
                          LockOwner owner) {
    const bool verifies = owner == LockOwner::verify;
    if (!text.starts_with(first_line(verifies ? LockOwner::pytest : LockOwner::verify))) return;
    throw InputError(fmt::format(
        "{}:1:1: {}", file.string(),
        verifies ? "was recorded by pytest; rename the baseline, whose lock bears its name"
                 : "was recorded by `fumon verify`; rename its baseline and this file, since "
                   "pytest records in pictures.lock"));
}

}  // namespace

bool good_picture_name(std::string_view name) {
    const auto good = [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
               c == '-' || c == '_';
    };
    constexpr std::size_t longest = 100;
    return !name.empty() && name.size() <= longest && std::all_of(name.begin(), name.end(), good);
}

bool good_record_name(std::string_view name) {
    const auto [picture, environment] = parts_of_record_name(name);
    return good_picture_name(picture) && name == record_name(picture, environment) &&
           (environment.empty() || good_picture_name(environment));
}

void read_known_keys(const toml::table& from, const std::string& prefix, const KeyTable& table,
                     const Locate& locate, std::initializer_list<std::string_view> others) {
    for (const auto& [name, value] : from) {
        if (std::find(others.begin(), others.end(), name.str()) != others.end()) continue;
        const std::string path = prefix + std::string(name.str());
        const Key* key = table.find(path);
        if (key == nullptr) refuse_unknown(locate(name.source()), path, table);
        assign(*key, value, locate);
    }
}

BaselineRecord read_record(const std::string& name, const toml::node& section,
                           const Locate& locate) {
    const std::string prefix = fmt::format("recorded.{}.", name);
    if (!section.is_table()) {
        throw InputError(
            fmt::format("{}: recorded.{} is not a section; remove it and run `fumon "
                        "verify --update`",
                        locate(section.source()), name));
    }
    RecordText record;
    KeyTable table;
    record.list_head_keys(prefix, table);
    record.fingerprint.list_keys(prefix, table);
    read_known_keys(*section.as_table(), prefix, table, locate);
    try {
        return {record.fumon,   record.environment,
                record.state,   record.fingerprint.fingerprint(),
                record.ignored, record.under_overlays};
    } catch (const KeyError& fault) {
        const toml::node* at = section.as_table()->get(fault.key());
        throw InputError(fmt::format("{}: {}{}",
                                     locate(at != nullptr ? at->source() : section.source()),
                                     prefix, fault.what()));
    }
}

std::string record_text(const std::string& name, const BaselineRecord& record) {
    RecordText head{record.fumon, record.environment, record.state, record.ignored,
                    record.under_overlays};
    KeyTable table;
    head.list_head_keys("", table);
    const char* quote = good_picture_name(name) ? "" : "\"";
    std::string text = fmt::format("[recorded.{1}{0}{1}]\n", name, quote);
    for (const Key& key : table.keys()) {
        if (key.path == "ignored" && record.ignored.empty()) continue;
        if (key.path == "under_overlays" && record.under_overlays.empty()) continue;
        text += fmt::format("{} = {}\n", key.path, value_text(key));
    }
    return text + fingerprint_text(record.fingerprint);
}

BaselineRecords read_lock(const std::filesystem::path& file, LockOwner owner) {
    std::error_code fault;
    if (!std::filesystem::exists(file, fault)) return {};
    return parse_lock(read_input_file(file), file, owner);
}

BaselineRecords parse_lock(const std::string& text, const std::filesystem::path& file,
                           LockOwner owner) {
    BaselineRecords records;
    refuse_lock_of_other(text, file, owner);
    const toml::table root = parse_toml(text, file.string(), "what is recorded is TOML");
    const Locate locate = [&](const toml::source_region& region) {
        return fmt::format("{}:{}:{}", file.string(), region.begin.line, region.begin.column);
    };
    read_known_keys(root, "", {}, locate, {"recorded"});
    const toml::node* recorded = root.get("recorded");
    if (recorded == nullptr) return records;
    if (!recorded->is_table())
        throw InputError(locate(recorded->source()) + ": recorded is a section");
    for (const auto& [key, value] : *recorded->as_table()) {
        const std::string name(key.str());
        if (!(owner == LockOwner::verify ? good_record_name(name) : good_picture_name(name))) {
            throw InputError(
                fmt::format("{}: the name of a picture takes letters, digits, \"-\" and \"_\"",
                            locate(key.source())));
        }
        records[name] = read_record(name, value, locate);
    }
    return records;
}

std::string lock_text(const BaselineRecords& records, LockOwner owner) {
    std::string text = first_line(owner);
    for (const auto& [name, record] : records)
        text += fmt::format("\n{}", record_text(name, record));
    return text;
}

}  // namespace fumon
