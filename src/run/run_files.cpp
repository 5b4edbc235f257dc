#include "run/run_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <nlohmann/json.hpp>
#include <string_view>
#include <system_error>

#include "base/error.h"
#include "files/input_file.h"
#include "files/json_text.h"
#include "files/netcdf/netcdf_fields.h"
#include "files/terrain/terrain_format.h"
#include "run/run_folder.h"
#include "scene/schedule.h"

namespace fumon {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr std::string_view temporary_end = ".part";
constexpr int frame_digits = 6;
constexpr int bed_digits = 8;

/// What may lie in a run's folder itself.
constexpr std::array<const char*, 7> single_files{"avalanches.csv", "checkpoint.fumon", "fields.nc",
                                                  "frames.fumon",   "measurements.csv", "movie.mp4",
                                                  "run.json"};
constexpr const char* fields_file = "fields.nc";

std::string_view without_temporary_end(std::string_view name) {
    if (name.ends_with(temporary_end)) name.remove_suffix(temporary_end.size());
    return name;
}

/// The number in a name like "frame_000012.png", of at least so many digits; −1 where a run does
/// not write that name.
std::int64_t number_in_name(std::string_view name, std::string_view begin, int digits,
                            std::string_view end) {
    if (!name.starts_with(begin) || !name.ends_with(end)) return -1;
    if (name.size() <= begin.size() + end.size()) return -1;
    name.remove_prefix(begin.size());
    name.remove_suffix(end.size());
    std::int64_t number = -1;
    std::from_chars(name.data(), name.data() + name.size(), number);
    return fmt::format("{:0{}}", number, digits) == name ? number : -1;
}

/// The number of a frame, or of what stands beside it for GIS (which these write there too); −1 of
/// another name.
std::int64_t frame_of(std::string_view name) {
    for (const char* ending : {".png", ".pgw", ".png.aux.xml", ".tif", ".exr"}) {
        const std::int64_t number = number_in_name(name, "frame_", frame_digits, ending);
        if (number >= 0) return number;
    }
    return -1;
}

bool is_numbered(std::string_view name, std::string_view folder, std::int64_t count) {
    if (!name.starts_with(folder) || name.size() <= folder.size()) return false;
    const std::int64_t number = frame_of(name.substr(folder.size() + 1));
    return number >= 0 && number < count;
}

/// The names of a bed's files in the format of one of them: it may have more than one.
void add_bed(const std::string& name, std::set<std::string>& files) {
    const std::size_t point = name.rfind('.');
    if (point == std::string::npos) return;
    const std::string_view ending = std::string_view(name).substr(point);
    for (const TerrainFormat& format : terrain_formats()) {
        if (std::ranges::find(format.endings, ending) == format.endings.end()) continue;
        for (const std::string_view one : format.endings)
            files.insert(name.substr(0, point) + std::string(one));
    }
}

bool is_due(std::string_view name, const PlannedBeds& beds) {
    const Schedule schedule(beds.every, beds.at, beds.last_step);
    return std::ranges::any_of(beds.endings, [&](const std::string& ending) {
        return schedule.due(number_in_name(name, "beds/bed_", bed_digits, ending));
    });
}

/// What a manifest lists of what was made.
RunFiles made_files(const Json& manifest) {
    RunFiles made;
    for (const char* key : {"measurements", "avalanches", "fields"}) {
        if (manifest.contains(key)) made.files.insert(manifest[key].get<std::string>());
    }
    if (manifest.contains("movie"))
        made.files.insert(manifest["movie"].at("file").get<std::string>());
    for (const auto& bed : manifest.value("beds", Json::array()))
        add_bed(bed.at("file"), made.files);
    for (const auto& frame : manifest.value("frames", Json::array()))
        made.frames += frame.contains("file") ? 1 : 0;
    return made;
}

template <class IsOne>
void add_names(const fs::path& folder, const std::string& part, const IsOne& is_one,
               std::vector<std::string>& names) {
    std::error_code fault;
    for (const auto& entry : fs::directory_iterator(folder / part, fault)) {
        const std::string name = entry.path().filename().string();
        if (is_one(without_temporary_end(name))) names.push_back((fs::path(part) / name).string());
    }
}

}  // namespace

std::int64_t step_of_bed(const std::string& name) {
    const std::string_view whole = without_temporary_end(name);
    for (const TerrainFormat& format : terrain_formats()) {
        for (const std::string_view ending : format.endings) {
            const std::int64_t step = number_in_name(whole, "beds/bed_", bed_digits, ending);
            if (step >= 0) return step;
        }
    }
    return -1;
}

bool RunFiles::contains(const std::string& name) const {
    const std::string_view whole = without_temporary_end(name);
    const bool is_piece = number_of_fields_piece(whole, fields_file) > 0;
    return files.contains(is_piece ? fields_file : std::string(whole)) ||
           is_numbered(whole, "frames", frames) ||
           is_numbered(whole, "movie_frames", movie_frames) || is_due(whole, beds);
}

RunFiles planned_files(const Scene& scene, double checkpoint_minutes) {
    const OutputSettings& output = scene.output;
    const RunParts parts = run_parts(scene, checkpoint_minutes);
    const std::int64_t frames = frame_schedule(scene).count();
    RunFiles planned;
    planned.files = {"run.json", "checkpoint.fumon", "frames.fumon"};
    if (parts.frames) planned.frames = frames;
    if (parts.movie_frames) planned.movie_frames = frames;
    if (output.movie) planned.files.insert("movie.mp4");
    if (output.measurements) planned.files.insert("measurements.csv");
    if (output.avalanches) planned.files.insert("avalanches.csv");
    if (fields_schedule(scene).count() > 0) planned.files.insert(fields_file);
    if (!parts.beds) return planned;
    planned.beds = {output.bed_every, output.bed_at, scene.run.steps, {}};
    for (const std::string& format : output.bed_format) {
        for (const std::string_view ending : find_written_format(format)->endings)
            planned.beds.endings.insert(std::string(ending));
    }
    return planned;
}

Json files_json(const RunFiles& files) {
    const PlannedBeds& beds = files.beds;
    return {{"files", files.files},
            {"frames", files.frames},
            {"movie_frames", files.movie_frames},
            {"beds",
             {{"every", beds.every},
              {"at", beds.at},
              {"last_step", beds.last_step},
              {"endings", beds.endings}}}};
}

RunFiles listed_files(const fs::path& manifest) {
    try {
        const auto json = parse_json(read_input_file(manifest));
        if (!json.contains("fumon") || !json.contains("status")) return {};
        RunFiles listed = made_files(json);
        listed.files.insert({"run.json", "checkpoint.fumon", "frames.fumon"});
        if (!json.contains("may_write")) return listed;
        const auto& more = json["may_write"];
        listed.files.merge(more.at("files").get<std::set<std::string>>());
        listed.frames = std::max(listed.frames, whole_number(more.at("frames")));
        listed.movie_frames = whole_number(more.at("movie_frames"));
        const auto& beds = more.at("beds");
        listed.beds = {whole_number(beds.at("every")), whole_numbers(beds.at("at")),
                       whole_number(beds.at("last_step")), beds.at("endings")};
        return listed;
    } catch (const nlohmann::json::exception&) {
        return {};
    } catch (const InputError&) {
        return {};
    }
}

std::vector<std::string> files_named_as_outputs(const fs::path& folder) {
    std::vector<std::string> names;
    add_names(
        folder, "",
        [](std::string_view name) {
            return std::ranges::find(single_files, name) != single_files.end() ||
                   number_of_fields_piece(name, fields_file) > 0;
        },
        names);
    const auto is_frame = [](std::string_view name) { return frame_of(name) >= 0; };
    for (const char* part : {"frames", "movie_frames"}) add_names(folder, part, is_frame, names);
    const auto is_bed = [](std::string_view name) {
        return step_of_bed("beds/" + std::string(name)) >= 0;
    };
    add_names(folder, "beds", is_bed, names);
    std::ranges::sort(names);
    return names;
}

}  // namespace fumon
