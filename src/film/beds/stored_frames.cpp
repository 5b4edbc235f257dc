#include "film/beds/stored_frames.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>

#include "base/error.h"
#include "base/number_text.h"
#include "base/stopwatch.h"
#include "files/file_lock.h"
#include "picture/movie.h"
#include "picture/png.h"
#include "render/colour/colouring.h"
#include "render/view/shown_snapshot.h"
#include "run/frame_list.h"
#include "run/frame_painter.h"
#include "run/output_files.h"
#include "run/picture_text.h"
#include "run/run_folder.h"
#include "run/terminal/interrupt.h"
#include "run/terminal/progress.h"
#include "scene/overlay_keys.h"
#include "scene/schedule.h"

namespace fumon {

namespace {

namespace fs = std::filesystem;

constexpr const char* pixels_text = "fumon:pixels-sha256";
constexpr const char* environment_keyword_of_frames = "fumon:environment";

std::string text_of(const PictureText& texts, const std::string& keyword) {
    const auto found =
        std::ranges::find(texts, keyword, &std::pair<std::string, std::string>::first);
    return found == texts.end() ? "" : found->second;
}

/// Whether the texts of a frame are those of another, but for its pixels and, with an empty
/// `environment`, for what drew it.
bool same_texts(const PictureText& there, const PictureText& wanted,
                const std::string& environment) {
    return there.size() == wanted.size() &&
           std::ranges::equal(there, wanted, [&](const auto& one, const auto& other) {
               if (one.first != other.first) return false;
               if (one.first == pixels_text) return true;
               if (one.first == environment_keyword_of_frames)
                   return environment.empty() || one.second == environment;
               return one.second == other.second;
           });
}

bool speaks_of(const std::vector<std::string>& settings, const std::string& key) {
    return std::ranges::any_of(
        settings, [&](const std::string& setting) { return setting.starts_with(key + "="); });
}

void show(StatusLine& status, const char* what, std::int64_t done, std::int64_t all,
          const Stopwatch& watch) {
    if (!status.due() || done == 0) return;
    const double seconds = watch.seconds();
    status.show(fmt::format(
        "{} {}/{} at {:.2g} frames/s, {} left", what, with_commas(done), with_commas(all),
        static_cast<double>(done) / seconds,
        clock_text(seconds * static_cast<double>(all - done) / static_cast<double>(done))));
}

}  // namespace

StoredFrames::StoredFrames(const StoredBeds& beds, fs::path folder,
                           const std::vector<std::string>& settings)
    : beds_(beds), folder_(std::move(folder)), scene_(beds.scene()) {
    OutputSettings& output = scene_.output;
    if (!output.frames) {
        if (!speaks_of(settings, "output.frames")) output.frames = true;
        if (!speaks_of(settings, "output.movie")) output.movie = true;
    }
    const Schedule schedule = frame_schedule(scene_);
    for (std::int64_t step = 0; step <= scene_.run.steps; ++step) {
        if (!schedule.due(step)) continue;
        const auto found = std::ranges::find(beds.beds(), step, &StoredBed::step);
        steps_.push_back(step);
        places_.push_back(found == beds.beds().end() ? -1 : found - beds.beds().begin());
    }
    fix_colours();
    resolved_ = resolved_scene(scene_, beds.inputs());
}

void StoredFrames::fix_colours() {
    LookSettings& look = scene_.view.look;
    if (!ranges_by_values(look) || look.range == ColourSpan::frame) return;
    const std::optional<Snapshot> changed = shown_snapshot(beds_.first(), scene_.view);
    const Snapshot& first = changed ? *changed : beds_.first();
    double low = INFINITY;
    double high = -INFINITY;
    for (const std::ptrdiff_t place : places_) {
        if (place < 0) continue;
        const SharedSnapshot bed = beds_.snapshot(static_cast<std::size_t>(place));
        const std::optional<Snapshot> reshaped = shown_snapshot(*bed, scene_.view);
        const Snapshot& shown = reshaped ? *reshaped : *bed;
        const FrameColourRange colours =
            frame_colour_range(look, shown, coloured_values(look, shown, first), {}, true);
        if (!colours.kept) continue;  // its values are one
        low = std::min(low, colours.low);
        high = std::max(high, colours.high);
    }
    if (!(low < high)) return;
    look.low = low;
    look.high = high;
}

fs::path StoredFrames::frame(std::int64_t number) const {
    return folder_ / RunFolder::frame_name(number);
}

void StoredFrames::check(const std::vector<std::int64_t>& numbers) const {
    for (const std::int64_t number : numbers) {
        const auto k = static_cast<std::size_t>(number);
        if (places_.at(k) >= 0) continue;
        throw InputError(
            fmt::format("frame {} shows step {}, but the run stored no bed of that step; run the "
                        "scene again with --set output.fields_every=N, where N divides {}",
                        number, steps_[k], steps_[k]));
    }
}

bool StoredFrames::is_there(std::int64_t number, const std::string& environment) const {
    std::error_code fault;
    const fs::path file = frame(number);
    if (!fs::is_regular_file(file, fault)) return false;
    try {
        const PictureText wanted =
            picture_text(resolved_, scene_, steps_[static_cast<std::size_t>(number)],
                         beds_.inputs(), Sha256{}, {});
        return same_texts(read_png_texts(file), wanted, environment);
    } catch (const InputError&) {
        return false;  // damaged, or no picture
    }
}

StoredFrames::Drawn StoredFrames::draw(const std::vector<std::int64_t>& numbers,
                                       const WorkOptions& work, StatusLine& status) const {
    if (numbers.empty()) return {};
    const std::vector<MeasuredRows> rows = beds_.measurements(plotted_columns(scene_));
    WorkerPool pool(work.threads, "fumon-render");
    const bool with_layers = scene_.output.exr_frames;
    const auto painter = make_frame_painter(
        scene_, beds_.first(), work.backend, pool,
        with_layers ? PaintedContent::pictures_and_layers : PaintedContent::pictures);
    const RenderingEnvironment environment = painter->record().environment;
    const std::string drawn_by = environment_text(environment);
    const PictureFacts facts{resolved_, scene_, beds_.inputs(), environment};
    const RunFolder folder(folder_, true);
    make_folder(folder_ / "frames");
    RunParts parts;
    parts.frames = true;
    Drawn counts;
    const Stopwatch watch;
    for (const std::int64_t number : numbers) {
        if (interrupting_signal() != 0) break;
        show(status, "frame", counts.drawn,
             static_cast<std::int64_t>(numbers.size()) - counts.kept - counts.elsewhere, watch);
        const FileLock lock(frame(number).string() + ".lock");
        if (!lock.held()) {
            ++counts.elsewhere;
            continue;
        }
        if (is_there(number, drawn_by)) {
            ++counts.kept;
            continue;
        }
        const auto place = static_cast<std::size_t>(places_.at(static_cast<std::size_t>(number)));
        const SharedSnapshot snapshot = beds_.snapshot(place);
        auto image = std::make_shared<const Image>(painter->paint(*snapshot, rows[place]));
        std::shared_ptr<const LayeredImage> layers;
        if (with_layers)
            layers = std::make_shared<const LayeredImage>(painter->paint_layers(*snapshot));
        write_frame(&folder, parts, {number, snapshot, std::move(image), std::move(layers)}, facts);
        ++counts.drawn;
    }
    status.clear();
    return counts;
}

std::vector<std::int64_t> StoredFrames::missing() const {
    std::vector<std::int64_t> numbers;
    for (std::int64_t number = 0; number < count(); ++number) {
        if (!is_there(number, "")) numbers.push_back(number);
    }
    return numbers;
}

void StoredFrames::write_movie(StatusLine& status) const {
    const ImageSettings& size = scene_.view.image;
    const OutputSettings& output = scene_.output;
    Movie whole(movie(), static_cast<int>(size.width), static_cast<int>(size.height),
                output.movie_rate, static_cast<int>(output.movie_quality));
    FrameList frames(std::nullopt);
    std::string environment;
    bool mixed = false;
    const Stopwatch watch;
    for (std::int64_t number = 0; number < count(); ++number) {
        const fs::path file = frame(number);
        const PictureText texts = read_png_texts(file);
        const Image image = read_png(file);
        const Sha256 pixels = pixel_hash(image);
        if (hex(pixels) != text_of(texts, pixels_text)) {
            throw Error(fmt::format(
                "{}: its pixels have changed since it was drawn; delete it and draw it again",
                file.string()));
        }
        const std::string drawn_by = text_of(texts, environment_keyword_of_frames);
        mixed = mixed || (number > 0 && drawn_by != environment);
        if (number == 0) environment = drawn_by;
        whole.add(image);
        const auto k = static_cast<std::size_t>(number);
        frames.add({number, steps_[k], 0.0, pixels, {}});
        show(status, "movie: frame", number + 1, count(), watch);
    }
    whole.finish(
        movie_text(resolved_, scene_, beds_.inputs(), frames, parse_environment(environment)));
    status.clear();
    if (mixed)
        status.note(
            "the frames were not all drawn by the same software: they may differ in single "
            "pixels");
}

std::string ranges_text(const std::vector<std::int64_t>& numbers) {
    std::string text;
    for (std::size_t i = 0; i < numbers.size();) {
        std::size_t end = i + 1;
        while (end < numbers.size() && numbers[end] == numbers[end - 1] + 1) ++end;
        text += (text.empty() ? "" : ", ") +
                (end - i == 1 ? fmt::format("{}", numbers[i])
                              : fmt::format("{} to {}", numbers[i], numbers[end - 1]));
        i = end;
    }
    return text;
}

}  // namespace fumon
