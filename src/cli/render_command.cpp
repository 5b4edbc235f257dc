#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/error.h"
#include "base/number_text.h"
#include "cli/command.h"
#include "cli/commands.h"
#include "cli/examples.h"
#include "cli/shared_options.h"
#include "files/file_lock.h"
#include "film/beds/stored_beds.h"
#include "film/beds/stored_frames.h"
#include "outputs/output_claims.h"
#include "outputs/own_file.h"
#include "run/drawing.h"
#include "run/terminal/interrupt.h"
#include "shards/shard.h"
#include "shards/slurm_script.h"

namespace fumon {

namespace {

namespace fs = std::filesystem;

struct RenderOptions {
    std::string run;     ///< the folder of a finished run that stored beds
    std::string folder;  ///< of the frames
    std::string frames;  ///< "12" or "0:99"; empty: all
    bool force = false;
    ShardOptions shards;
    WorkOptions work;
};

void declare(CLI::App& command, RenderOptions& options) {
    command.add_option("RUN", options.run, "the folder of a finished run that stored beds")
        ->required();
    command
        .add_option("-o,--output", options.folder,
                    "the folder for frames/ and movie.mp4 (may be the run's own)")
        ->type_name("DIR")
        ->required();
    auto* frames =
        command
            .add_option("--frames", options.frames,
                        "the numbers of the frames, from the first to the last: 0:99, or "
                        "12 alone (default: all)")
            ->type_name("FIRST:LAST");
    add_shard_options(command, options.shards,
                      "make the movie from the frames that the shards have drawn");
    command.get_option("--merge")->excludes(frames);
    add_force(command, options.force);
    add_settings(command, options.work.settings,
                 "override how the run looks: --set camera.azimuth=200 (repeatable)");
    add_thread_options(command, options.work);
    add_drawing_options(command, options.work);
    add_examples(
        command,
        {{"fumon run dunes-barchans -o out/sim --set output.fields_every=100 --set "
          "frames.every=100",
          ""},
         {"fumon render out/sim -o out/frames --shard 3/16", "one of 16 machines' share"},
         {"fumon render out/sim -o out/frames --merge", "the movie, when all are drawn"},
         {"fumon render out/sim -o out/noon --frames 0:9 --set sun.elevation=60", "another look"}},
        "Nothing is simulated: the run stores beds when its scene says output.fields_every=N. The "
        "files have the\nbytes that the run would have written. Frames that are there are kept, "
        "and "
        "two programs never draw the same.\n"
        "Exit status: 0 done, 2 wrong input, 3 could not work or frames are missing, 130/143 "
        "interrupted "
        "(what was drawn is kept).");
}

/// The frames that --frames names, of so many.
std::vector<std::int64_t> frames_in(const std::string& text, std::int64_t count) {
    std::int64_t first = 0;
    std::int64_t last = count - 1;
    if (!text.empty()) {
        const std::size_t colon = text.find(':');
        const auto number = [&](std::string_view digits, std::int64_t& value) {
            const auto read = std::from_chars(digits.data(), digits.data() + digits.size(), value);
            return read.ec == std::errc{} && read.ptr == digits.data() + digits.size();
        };
        const std::string_view whole = text;
        const bool good =
            number(whole.substr(0, colon), first) &&
            number(colon == std::string::npos ? whole : whole.substr(colon + 1), last);
        if (!good || first < 0 || last < first || last >= count) {
            throw InputError(fmt::format(
                "--frames is \"{}\"; it takes first:last, as 0:{}, or one number: the run has the "
                "frames 0 to {}",
                text, count - 1, count - 1));
        }
    }
    std::vector<std::int64_t> numbers;
    for (std::int64_t frame = first; frame <= last; ++frame) numbers.push_back(frame);
    return numbers;
}

/// Those of a shard: frames are taken to last equally long.
std::vector<std::int64_t> share_of(const std::vector<std::int64_t>& numbers, const Shard& shard) {
    const std::vector<int> shares = shares_of(std::vector<double>(numbers.size(), 1.0), shard.of);
    std::vector<std::int64_t> mine;
    for (std::size_t k = 0; k < numbers.size(); ++k) {
        if (shares[k] == shard.number) mine.push_back(numbers[k]);
    }
    return mine;
}

/// A frame that a killed program was writing is none of anybody else's.
void claim(const OutputClaims& claims, const fs::path& file) {
    std::error_code fault;
    claims.check(file, !fs::exists(fs::symlink_status(file, fault)) || is_made_by_fumon(file));
}

OutputClaims claims_of(const RenderOptions& options, const StoredBeds& beds) {
    std::error_code fault;
    check_output_folder(options.folder, "the frames");
    if (const fs::path frames = fs::path(options.folder) / "frames"; fs::exists(frames, fault))
        check_output_folder(frames, "the frames");
    OutputClaims claims(options.force);
    claims.reads(beds.files());
    return claims;
}

int merge(const RenderOptions& options, const StoredBeds& beds, const StoredFrames& frames,
          StatusLine& status) {
    const OutputClaims claims = claims_of(options, beds);
    const std::vector<std::int64_t> missing = frames.missing();
    if (!missing.empty()) {
        throw Error(fmt::format(
            "{}: {} of {} frames are missing, so the movie is not made: {}; `fumon render {} -o "
            "{}` draws the missing ones",
            options.folder, with_commas(static_cast<std::int64_t>(missing.size())),
            with_commas(frames.count()), ranges_text(missing), options.run, options.folder));
    }
    claim(claims, frames.movie());
    frames.write_movie(status);
    status.note(fmt::format("{} frames: {}", with_commas(frames.count()), frames.movie().string()));
    return 0;
}

int draw(const RenderOptions& options, const StoredBeds& beds, const StoredFrames& frames,
         const std::optional<Shard>& shard, StatusLine& status) {
    std::vector<std::int64_t> numbers = frames_in(options.frames, frames.count());
    if (shard) numbers = share_of(numbers, *shard);
    frames.check(numbers);
    const OutputClaims claims = claims_of(options, beds);
    for (const std::int64_t number : numbers) claim(claims, frames.frame(number));
    const StoredFrames::Drawn drawn = frames.draw(numbers, options.work, status);
    const std::string what = shard ? fmt::format("shard {}: ", shard_text(*shard)) : "";
    const std::int64_t done = drawn.drawn + drawn.kept;
    const auto all = static_cast<std::int64_t>(numbers.size());
    status.note(fmt::format(
        "{}{} of {} frames are done{}{}: {}", what, with_commas(done), with_commas(all),
        drawn.kept > 0 ? fmt::format(" ({} were there already)", with_commas(drawn.kept)) : "",
        drawn.elsewhere > 0 ? fmt::format(" ({} another fumon draws)", with_commas(drawn.elsewhere))
                            : "",
        options.folder));
    if (done + drawn.elsewhere == all) return 0;
    return exit_status_of_signal(interrupting_signal());
}

/// The share of a program that mpirun started; the movie where no other one has still to end.
int draw_rank(const RenderOptions& options, const StoredBeds& beds, const StoredFrames& frames,
              const Shard& shard, StatusLine& status) {
    const int ended = draw(options, beds, frames, shard, status);
    if (ended != 0 || !frames.missing().empty()) return ended;
    const FileLock lock(frames.movie().string() + ".lock");
    return lock.held() ? merge(options, beds, frames, status) : 0;
}

int perform(const RenderOptions& given) {
    const InterruptGuard guard;
    RenderOptions options = given;
    StatusLine status(options.work.verbosity);
    const Share share = share_of(options.shards, options.work, status, "makes the movie");
    prepare_drawing(options.work);
    const StoredBeds beds(options.run, options.work.threads, options.work.settings);
    const StoredFrames frames(beds, options.folder, options.work.settings);
    if (options.shards.slurm_shards > 0) {
        std::vector<std::string> words{"render", options.run, "-o", options.folder};
        for (const std::string& one : options.work.settings)
            words.insert(words.end(), {"--set", one});
        if (options.work.pinned) words.emplace_back("--pinned");
        const auto shards = static_cast<int>(options.shards.slurm_shards);
        std::fputs(slurm_script({"fumon-render", words, shards}).c_str(), stdout);
        return 0;
    }
    if (options.shards.merge) return merge(options, beds, frames, status);
    return share.of_mpirun ? draw_rank(options, beds, frames, *share.shard, status)
                           : draw(options, beds, frames, share.shard, status);
}

}  // namespace

Command render_command() {
    return make_command<RenderOptions>(
        "render", "draw a run's frames from the beds that it has stored, on any machine", declare,
        perform);
}

}  // namespace fumon
