#include "picture/baseline.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <limits>
#include <map>
#include <string_view>
#include <tuple>

#include "base/error.h"
#include "base/find_named.h"
#include "base/limits.h"
#include "files/input_file.h"
#include "keys/toml_text.h"

namespace fumon {

namespace {

/// What stood above the records while they stood in the same file.
constexpr std::string_view head_mark =
    "# Recorded by `fumon verify --update`, which writes anew all that follows.";

/// Without the mark that it ends with, and with one line end.
std::string people_part(std::string head) {
    const auto trim = [&] {
        while (head.ends_with('\n') || head.ends_with('\r')) head.pop_back();
    };
    trim();
    if (head.ends_with(head_mark)) head.resize(head.size() - head_mark.size());
    trim();
    return head + "\n";
}

class Reader {
  public:
    Reader(const std::filesystem::path& file, WrongCases wrong)
        : name_(file.string()), text_(read_input_file(file)), wrong_(wrong) {
        baseline_.file = file;
        const std::string stem = file.stem().string();
        if (stem == "." || stem == "..") {
            throw InputError(
                fmt::format("{}: expected pictures are stored in a folder of the same name without "
                            "its ending, here \"{}\"; rename the baseline",
                            name_, stem));
        }
        if (file == baseline_.lock()) {
            throw InputError(fmt::format("{}: is a lock file; name its baseline", name_));
        }
    }

    Baseline read() {
        const toml::table root = parse_toml(text_, name_, "a baseline is TOML");
        const toml::table* cases = section(root, "cases");
        const toml::table* recorded = section(root, "recorded");
        const toml::table* environments = section(root, "environment");
        BaselineCase common;
        KeyTable table;
        common.list_keys("", table);
        read_known_keys(root, "", table, locate_, {"cases", "recorded", "ignore", "environment"});
        if (const toml::node* ignore = root.get("ignore"))
            read_ignore(*ignore, "ignore", locate_, common.ignore);
        if (environments != nullptr) read_environments(*environments);
        check_environments(common, root, "");
        if (cases == nullptr || cases->empty()) {
            throw InputError(fmt::format(
                "{}:1:1: names no case; write [cases] and below NAME = {{scene = \"FILE.toml\"}}",
                name_));
        }
        for (const auto& [name, value] : *cases) {
            order_.push_back(
                {name.source().begin.line, name.source().begin.column, std::string(name.str())});
            BaselineCase one = common;
            one.name = name.str();
            one.place = locate(name.source());
            read_or_keep(one, value);
            cases_[one.name] = std::move(one);
        }
        std::sort(order_.begin(), order_.end());
        for (const CaseLocation& place : order_) baseline_.cases.push_back(cases_.at(place.name));
        baseline_.head = text_;
        try {
            if (recorded != nullptr && !recorded->empty()) {
                read_records(*recorded);
            } else {
                take(read_lock(baseline_.lock(), LockOwner::verify));
            }
        } catch (const InputError& fault) {
            if (wrong_ == WrongCases::refused) throw;
            for (BaselineCase& one : baseline_.cases) {
                if (one.fault.empty()) one.fault = fault.what();
            }
        }
        return std::move(baseline_);
    }

  private:
    struct CaseLocation {
        toml::source_index line;
        toml::source_index column;
        std::string name;
        [[nodiscard]] bool operator<(const CaseLocation& other) const {
            return std::tie(line, column) < std::tie(other.line, other.column);
        }
    };

    [[nodiscard]] std::string locate(const toml::source_region& region) const {
        return fmt::format("{}:{}:{}", name_, region.begin.line, region.begin.column);
    }

    [[nodiscard]] const toml::table* section(const toml::table& root, std::string_view name) const {
        const toml::node* node = root.get(name);
        if (node == nullptr) return nullptr;
        if (!node->is_table()) {
            throw InputError(fmt::format("{}: {} is a section; write [{}] and its keys below",
                                         locate(node->source()), name, name));
        }
        return node->as_table();
    }

    void read_environments(const toml::table& environments) {
        for (const auto& [key, value] : environments) {
            NamedEnvironment one;
            one.name = key.str();
            const std::string place = locate(key.source());
            if (!good_picture_name(one.name)) {
                throw InputError(fmt::format(
                    "{}: the name of an environment takes letters, digits, \"-\" and \"_\"",
                    place));
            }
            if (!value.is_table()) {
                throw InputError(
                    fmt::format("{}: environment.{} is a section; write [environment.{}] and its "
                                "keys below",
                                locate(value.source()), one.name, one.name));
            }
            KeyTable table;
            const std::string prefix = fmt::format("environment.{}.", one.name);
            one.list_keys(prefix, table);
            read_known_keys(*value.as_table(), prefix, table, locate_);
            if (one.is_anything()) {
                throw InputError(fmt::format(
                    "{}: environment.{} matches any machine; give its mesa, driver or drawer",
                    place, one.name));
            }
            baseline_.environments.push_back(std::move(one));
        }
    }

    /// All that are named are described.
    void check_environments(const BaselineCase& one, const toml::table& own,
                            const std::string& prefix) const {
        const toml::node* named = own.get("environments");
        if (named == nullptr) return;
        std::vector<std::string> known;
        for (const NamedEnvironment& environment : baseline_.environments)
            known.push_back(environment.name);
        for (const std::string& name : one.environments) {
            if (find_named(baseline_.environments, name) != nullptr) continue;
            throw InputError(fmt::format(
                "{}: {}environments names \"{}\", which has no description; write [environment.{}] "
                "with its mesa, driver or drawer{}",
                locate(named->source()), prefix, name, name,
                known.empty() ? "" : fmt::format(", or name one of {}", fmt::join(known, ", "))));
        }
    }

    void read_or_keep(BaselineCase& one, const toml::node& value) const {
        try {
            read_case(one, value);
        } catch (const InputError& fault) {
            if (wrong_ == WrongCases::refused) throw;
            one.fault = fault.what();
        }
    }

    void read_case(BaselineCase& one, const toml::node& value) const {
        const std::string& place = one.place;
        if (!good_picture_name(one.name)) {
            throw InputError(fmt::format(
                "{}: the name of a case takes letters, digits, \"-\" and \"_\"", place));
        }
        if (!value.is_table()) {
            throw InputError(
                fmt::format("{}: cases.{} is not a section; it takes {{scene = \"FILE.toml\", …}}",
                            locate(value.source()), one.name));
        }
        const std::vector<std::string> shared = std::move(one.settings);
        one.settings.clear();
        if (value.as_table()->contains("step")) one.time = -1.0;
        if (value.as_table()->contains("time")) one.step = -1;
        KeyTable table;
        const std::string prefix = fmt::format("cases.{}.", one.name);
        one.list_keys(prefix, table);
        read_known_keys(*value.as_table(), prefix, table, locate_, {"ignore"});
        if (const toml::node* ignore = value.as_table()->get("ignore")) {
            one.ignore.boxes.clear();
            one.ignore.overlays.clear();
            read_ignore(*ignore, prefix + "ignore", locate_, one.ignore);
        }
        one.settings.insert(one.settings.begin(), shared.begin(), shared.end());
        check_environments(one, *value.as_table(), prefix);
        if (one.step >= 0 && one.time >= 0.0) {
            throw InputError(
                fmt::format("{}: cases.{} has a step and a time; keep one", place, one.name));
        }
        if (one.figure) refuse_step_of_figure(one, *value.as_table());
        if (one.scene.empty()) {
            throw InputError(
                fmt::format("{}: {}scene is missing; name a scene file (TOML)", place, prefix));
        }
    }

    /// A step or time for all cases does not hold for figures; one of its own is wrong.
    static void refuse_step_of_figure(BaselineCase& one, const toml::table& own) {
        for (const char* key : {"step", "time"}) {
            if (!own.contains(key)) continue;
            throw InputError(fmt::format(
                "{}: cases.{} is a figure, whose panels have steps of their own; remove {}",
                one.place, one.name, key));
        }
        one.step = -1;
        one.time = -1.0;
    }

    void take(const BaselineRecords& records) {
        for (const auto& [name, record] : records)
            (has_case(name) ? baseline_.records : baseline_.orphans)[name] = record;
    }

    /// A wrong case may have named any environment.
    [[nodiscard]] bool has_case(const std::string& record) const {
        const auto [picture, environment] = parts_of_record_name(record);
        const auto found = cases_.find(picture);
        if (found == cases_.end() || record != record_name(picture, environment)) return false;
        const auto& known = found->second.environments;
        return environment.empty() || !found->second.fault.empty() ||
               std::ranges::find(known, environment) != known.end();
    }

    /// Those of a file that was written before there were locks.
    void read_records(const toml::table& recorded) {
        auto first = std::numeric_limits<toml::source_index>::max();
        for (const auto& [name, value] : recorded)
            first = std::min(first, name.source().begin.line);
        for (const BaselineCase& one : baseline_.cases) {
            const CaseLocation* place = find_named(order_, one.name);
            if (place->line >= first) {
                throw InputError(
                    fmt::format("{}: cases.{} comes after the recorded values; move it up",
                                one.place, one.name));
            }
        }
        std::error_code fault;
        if (std::filesystem::exists(baseline_.lock(), fault)) {
            throw InputError(fmt::format("{}:{}:1: recorded values belong in {}; remove them here",
                                         name_, first, baseline_.lock().string()));
        }
        cut_head(first);
        BaselineRecords records;
        for (const auto& [name, value] : recorded) {
            const std::string picture(name.str());
            records[picture] = read_record(picture, value, locate_);
        }
        take(records);
        baseline_.unlocked = true;
    }

    /// The head ends before this line.
    void cut_head(toml::source_index line) {
        std::size_t end = 0;
        for (toml::source_index at = 1; at < line && end != std::string::npos; ++at) {
            const std::size_t next = text_.find('\n', end);
            end = next == std::string::npos ? next : next + 1;
        }
        baseline_.head = people_part(text_.substr(0, end));
    }

    std::string name_;
    std::string text_;
    WrongCases wrong_;
    Locate locate_ = [this](const toml::source_region& region) { return locate(region); };
    Baseline baseline_;
    std::vector<CaseLocation> order_;
    std::map<std::string, BaselineCase> cases_;
};

}  // namespace

void BaselineCase::list_keys(const std::string& prefix, KeyTable& table) {
    table.text(prefix + "scene", scene, {.help = "a scene file, relative to the baseline"});
    table.text_list(prefix + "settings", settings,
                    {.help = "key.path=VALUE each, after those that hold for all cases"});
    table.integer(
        prefix + "step", step,
        {.unit = "steps", .range = {0, largest_step}, .help = "of which step; else the last"});
    table.real(prefix + "time", time,
               {.range = {0, largest_step}, .help = "or of which time, in the model's unit"});
    table.boolean(prefix + "figure", figure, {.help = "the scene's figure, not a frame"});
    table.boolean(prefix + "picture", picture,
                  {.help = "keep the expected picture, for SSIM and to look at"});
    table.text_list(
        prefix + "environments", environments,
        {.help = "environments with pictures of their own, each an [environment.NAME]"});
    table.real(prefix + "thumbnail_difference", thumbnail_difference,
               {.unit = "grey levels", .range = {0, 255}, .help = "that passes elsewhere"});
    table.real(prefix + "tile_ssim", tile_ssim,
               {.range = {-1, 1}, .help = "of every tile that passes elsewhere"});
    table.text(prefix + "ignore_mask", ignore.mask,
               {.help = "a PNG whose white pixels are ignored, relative to the baseline"});
}

std::filesystem::path Baseline::lock() const {
    return std::filesystem::path(file).replace_extension(".lock");
}

std::filesystem::path Baseline::picture_of(const std::string& record) const {
    return file.parent_path() / file.stem() / (record + ".png");
}

std::filesystem::path Baseline::picture_of(const BaselineCase& one) const {
    return picture_of(one.name);
}

const NamedEnvironment* Baseline::environment_of(const BaselineCase& one,
                                                 const RenderingEnvironment& here) const {
    for (const std::string& name : one.environments) {
        const NamedEnvironment* found = find_named(environments, name);
        if (found != nullptr && found->is(here)) return found;
    }
    return nullptr;
}

Baseline read_baseline(const std::filesystem::path& file, WrongCases wrong) {
    return Reader(file, wrong).read();
}

}  // namespace fumon
