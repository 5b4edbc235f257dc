#include "run/still.h"

#include <fmt/format.h>

#include <cstdio>
#include <optional>
#include <utility>
#include <vector>

#include "base/error.h"
#include "files/atomic_file.h"
#include "outputs/output_claims.h"
#include "picture/exr.h"
#include "picture/stills/jpeg.h"
#include "picture/stills/picture_file.h"
#include "picture/stills/webp.h"
#include "render/view/framing.h"
#include "render/view/shown_snapshot.h"
#include "run/drawing.h"
#include "run/output_files.h"
#include "run/picture_text.h"
#include "run/step_observers.h"
#include "scene/overlay_keys.h"

namespace fumon {

namespace {

int advance(PreparedRun& prepared, const RunEnd& end, Progress& progress) {
    ProgressPrinter shown(progress);
    const int signal = advance(prepared, end, std::vector<StepObserver*>{&shown});
    if (signal == 0) progress.clear();
    return signal;
}

}  // namespace

int advance(PreparedRun& prepared, const RunEnd& end, std::vector<StepObserver*> others) {
    Model& model = *prepared.model;
    const bool gathers = prepared.plotted != nullptr;
    if (!gathers && !plotted_columns(prepared.scene).empty()) {
        Recording plots_alone;
        plots_alone.plots = true;
        prepared.plotted =
            std::make_unique<Recorder>(prepared.scene, model.snapshot(), std::move(plots_alone));
    }
    if (prepared.plotted) others.insert(others.begin(), prepared.plotted.get());
    return Stepper(model, std::move(others), gathers).advance(end);
}

int advance_to(PreparedRun& prepared, std::int64_t step, Progress& progress) {
    progress.expect(step, 0);
    return advance(prepared, at_step(step), progress);
}

int advance_to_time(PreparedRun& prepared, double time, const std::string& asked,
                    Progress& progress) {
    const std::int64_t last_step = prepared.scene.run.steps;
    progress.expect(last_step, 0);
    const RunEnd end = [&](const Model& model) {
        return model.time() >= time || model.steps_done() >= last_step;
    };
    const int signal = advance(prepared, end, progress);
    if (signal == 0 && prepared.model->time() < time) {
        throw InputError(fmt::format("{} is after the run's end at {} {}; lengthen run.steps",
                                     asked, prepared.model->time(), prepared.model->time_unit()));
    }
    return signal;
}

StillSubject still_subject(const PreparedRun& prepared) {
    return {prepared.scene, prepared.initial.inputs,
            prepared.plotted ? prepared.plotted->rows() : MeasuredRows{}};
}

Drawing draw_snapshot(const StillSubject& subject, const Snapshot& first, const Snapshot& snapshot,
                      const WorkOptions& work) {
    WorkerPool pool(work.threads, "fumon-render");
    const auto painter =
        make_frame_painter(subject.scene, first, work.backend, pool, PaintedContent::one_picture);
    return {painter->paint(snapshot, subject.rows), painter->record()};
}

namespace {

/// What says how a picture of that hash was made.
PictureText text_of(const Scene& scene, const std::vector<InputFile>& inputs, std::int64_t step,
                    const Sha256& hash, const DrawingRecord& record) {
    return picture_text(resolved_scene(scene, inputs), scene, step, inputs, hash,
                        record.environment);
}

std::vector<std::uint8_t> pixel_file(const Scene& scene, const Drawing& drawing,
                                     PictureFormat format, const PictureText& text) {
    const ImageSettings& image = scene.view.image;
    return encode_picture(drawing.image, format, {static_cast<int>(image.quality), image.lossless},
                          image.dots_per_inch, text);
}

std::vector<std::uint8_t> exr_file(const Scene& scene, const LayersDrawing& drawing,
                                   const PictureText& text) {
    return encode_exr(drawing.layers, scene.view.image.dots_per_inch, text);
}

}  // namespace

std::vector<std::uint8_t> still_file(const Scene& scene, const std::vector<InputFile>& inputs,
                                     std::int64_t step, const Drawing& drawing,
                                     PictureFormat format, const std::string& results) {
    return pixel_file(
        scene, drawing, format,
        of_results(text_of(scene, inputs, step, pixel_hash(drawing.image), drawing.record),
                   results));
}

std::vector<std::uint8_t> layers_file(const Scene& scene, const std::vector<InputFile>& inputs,
                                      std::int64_t step, const LayersDrawing& drawing,
                                      const std::string& results) {
    return exr_file(
        scene, drawing,
        of_results(text_of(scene, inputs, step, layers_hash(drawing.layers), drawing.record),
                   results));
}

namespace {

void write_bytes(const std::string& file, const std::vector<std::uint8_t>& bytes) {
    if (file == standard_output) {
        std::fwrite(bytes.data(), 1, bytes.size(), stdout);  // looked at when the program ends
    } else {
        write_file(file, bytes);
    }
}

DrawnStill draw_exr(const StillSubject& subject, const Snapshot& first, const Snapshot& snapshot,
                    const std::string& file, const WorkOptions& work, Progress& progress) {
    WorkerPool pool(work.threads, "fumon-render");
    const Scene& scene = subject.scene;
    const auto painter =
        make_frame_painter(scene, first, work.backend, pool, PaintedContent::layers);
    LayeredImage layers = painter->paint_layers(snapshot);  // record() is of what is drawn by then
    const LayersDrawing drawing{std::move(layers), painter->record()};
    const DrawingRecord& record = drawing.record;
    report_drawing(record, progress);
    const Sha256 hash = layers_hash(drawing.layers);
    const PictureText text = text_of(scene, subject.inputs, snapshot.step, hash, record);
    write_bytes(file, exr_file(scene, drawing, of_results(text, subject.results)));
    if (has_overlays(scene)) progress.note("overlays are not part of an OpenEXR file");
    if (record.exaggeration != 1.0)
        progress.note(fmt::format("vertical exaggeration {:g}", record.exaggeration));
    return {hash, record.environment};
}

bool is_exr_name(const std::string& file) {
    return small_ending(file) == exr_ending.front();
}

/// Throws KeyError where a format cannot hold what a scene asks for.
void check_pixels(const ImageSettings& image, PictureFormat format) {
    if (format == PictureFormat::png) return;
    const std::string_view name = name_of(format);
    if (image.deep_colour) {
        throw KeyError("image.deep_colour",
                       fmt::format("{} holds 8 bits a channel, and image.deep_colour asks for 16; "
                                   "write a PNG, or set image.deep_colour = false",
                                   name));
    }
    if (format == PictureFormat::tiff) return;
    const bool jpeg = format == PictureFormat::jpeg;
    if (jpeg && image.lossless) {
        throw KeyError("image.lossless",
                       "JPEG is always lossy; write a WebP or PNG, or set image.lossless = "
                       "false");
    }
    const std::int64_t longest = jpeg ? longest_jpeg_side : longest_webp_side;
    if (image.width > longest || image.height > longest) {
        throw KeyError(image.width > longest ? "image.width" : "image.height",
                       fmt::format("{} holds at most {} pixels on a side, not {} × {}; write a PNG",
                                   name, longest, image.width, image.height));
    }
}

}  // namespace

void stand_on_drawn_ground(View& view, const Snapshot& first, const Snapshot& drawn) {
    const std::optional<Snapshot> shown = shown_snapshot(first, view);
    const std::optional<Snapshot> present = shown_snapshot(drawn, view);
    view = standing_on(view, shown ? *shown : first, present ? *present : drawn);
}

void check_still(const Scene& scene, const Snapshot& snapshot, const std::string& file) {
    try {
        if (is_exr_name(file)) {
            check_layers(scene, snapshot);
        } else {
            check_pixels(scene.view.image, picture_format(file));
        }
    } catch (const KeyError& refusal) {
        throw InputError(scene.at(refusal.key()) + refusal.what());
    }
}

DrawnStill draw_still(const StillSubject& subject, const Snapshot& first, const Snapshot& snapshot,
                      const std::string& file, const WorkOptions& work, Progress& progress) {
    if (is_exr_name(file)) return draw_exr(subject, first, snapshot, file, work, progress);
    const Drawing drawing = draw_snapshot(subject, first, snapshot, work);
    report_drawing(drawing.record, progress);
    const Scene& scene = subject.scene;
    const Sha256 pixels = pixel_hash(drawing.image);
    const PictureText text = of_results(
        text_of(scene, subject.inputs, snapshot.step, pixels, drawing.record), subject.results);
    const PictureFormat format = picture_format(file);
    write_bytes(file, pixel_file(scene, drawing, format, text));
    if (format == PictureFormat::jpeg && drawing.image.transparent())
        progress.note("JPEG has no alpha: transparent parts become white");
    if (file != standard_output) write_map_files(scene, snapshot, drawing.image, file);
    if (drawing.record.exaggeration != 1.0)
        progress.note(fmt::format("vertical exaggeration {:g}", drawing.record.exaggeration));
    return {pixels, drawing.record.environment};
}

}  // namespace fumon
