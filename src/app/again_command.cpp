#include <fmt/format.h>

#include "app/commands.h"
#include "app/interrupt.h"
#include "app/picture_text.h"
#include "app/workshop.h"
#include "scene/read.h"
#include "support/error.h"

namespace fumon {

namespace {

namespace fs = std::filesystem;

/// Where an input of the picture lies now: from the working folder as recorded, else below the
/// picture's own folder or one of its parents. Its content must be what the picture was made from.
fs::path find_input(const InputFile& input, const fs::path& picture) {
    std::vector<fs::path> candidates{input.path};
    if (fs::path(input.path).is_relative()) {
        for (fs::path folder = fs::absolute(picture).parent_path();;
             folder = folder.parent_path()) {
            candidates.push_back(folder / input.path);
            if (folder == folder.parent_path()) break;
        }
    }
    fs::path changed;
    for (const fs::path& candidate : candidates) {
        std::error_code fault;
        if (!fs::is_regular_file(candidate, fault)) continue;
        if (hex(file_hash(candidate)) == input.hash) return candidate;
        if (changed.empty()) changed = candidate;
    }
    if (!changed.empty()) {
        throw InputError(fmt::format(
            "{}: {} has changed since the picture was made (SHA-256 then {}…); bring the old "
            "file back",
            picture.string(), changed.string(), input.hash.substr(0, 12)));
    }
    throw InputError(fmt::format(
        "{}: {} (SHA-256 {}…), which the picture was made from, is not there; run fumon again "
        "in the folder from which the path leads to it",
        picture.string(), input.path, input.hash.substr(0, 12)));
}

/// What may have changed the pixels, as far as the picture tells.
std::string why_different(const PictureOrigin& origin, const RenderingEnvironment& here) {
    const std::string versions =
        origin.version == FUMON_VERSION
            ? fmt::format("both by fumon {}", FUMON_VERSION)
            : fmt::format("made by fumon {}, this is {}", origin.version, FUMON_VERSION);
    if (!origin.environment)
        return versions + "; another OpenGL driver or processor also changes pixels";
    const std::string reason = why_pixels_may_differ(*origin.environment, here);
    if (reason.empty()) return versions + "; what drew them is the same";
    return versions + "; " + reason;
}

fs::path output_of(const AgainOptions& options) {
    if (!options.output.empty()) return options.output;
    return fs::path(options.picture).stem().string() + "-again.png";
}

}  // namespace

int again_command(const AgainOptions& options) {
    const InterruptGuard guard;
    const PictureOrigin origin = read_origin(options.picture);
    WorkOptions work = options.work;
    work.pinned = work.pinned || (origin.environment && origin.environment->pinned);
    prepare_drawing(work);
    Scene scene = parse_scene(origin.scene, options.picture, "", options.work.settings);
    if (!origin.inputs.empty())
        scene.bed.file = find_input(origin.inputs.front(), options.picture).string();
    Workshop workshop = set_up(std::move(scene), options.work.threads);
    Progress progress(options.work.verbosity,
                      static_cast<std::int64_t>(workshop.initial.bed.size()));
    const Snapshot first = workshop.model->snapshot();
    constexpr int status_of_signal = 128;
    if (const int signal = advance_to(workshop, origin.step, progress); signal != 0)
        return status_of_signal + signal;

    const fs::path output = output_of(options);
    const DrawnStill still = draw_still(workshop, first, output.string(), work, progress);
    const std::string pixels = hex(still.pixels);
    if (origin.pixels_hash.empty() || !options.work.settings.empty()) {
        progress.note(fmt::format("{}: made", output.string()));
    } else if (pixels == origin.pixels_hash) {
        progress.note(fmt::format("{}: the same pixels as {}", output.string(), options.picture));
    } else {
        progress.note(fmt::format("{}: made, but its pixels differ from {} ({})", output.string(),
                                  options.picture, why_different(origin, still.environment)));
    }
    return 0;
}

}  // namespace fumon
