#include "film/make_film.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <system_error>
#include <utility>

#include "base/block_pool.h"
#include "base/error.h"
#include "base/number_text.h"
#include "base/sha256.h"
#include "base/stopwatch.h"
#include "files/atomic_file.h"
#include "files/hash.h"
#include "film/cache/frame_cache.h"
#include "film/cache/frame_spool.h"
#include "film/contact_sheet.h"
#include "film/film_read.h"
#include "film/film_texts.h"
#include "film/frame_consumer.h"
#include "film/frame_pace.h"
#include "film/frame_sequence.h"
#include "film/joined_film.h"
#include "film/script/layer_files.h"
#include "picture/colour_table.h"
#include "picture/exr.h"
#include "picture/movie.h"
#include "run/picture_text.h"
#include "run/terminal/interrupt.h"
#include "run/terminal/job_watch.h"
#include "scene/json.h"

namespace fumon {

namespace {

namespace fs = std::filesystem;

constexpr int worst_rate_factor = 44;  // before pictures become smaller instead
constexpr int rate_factor_step = 4;    // rate factors from one try to the next
constexpr int most_try_count = 14;
constexpr double sheet_dots_per_inch = 100.0;  // dots per inch

/// Ends a film that was interrupted.
struct Interrupted {
    int signal;
};

/// A file that is there until this ends; only what kills the program leaves it.
struct TransientFile {
    fs::path file{};  ///< none where empty

    explicit TransientFile(fs::path file_) : file(std::move(file_)) {}
    TransientFile(const TransientFile&) = delete;
    TransientFile& operator=(const TransientFile&) = delete;
    ~TransientFile() {
        std::error_code fault;
        if (!file.empty()) fs::remove(file, fault);
    }
};

/// Whether what a killed program leaves of such a movie plays: MP4 and QuickTime say only at their
/// end where the frames are.
bool plays_while_incomplete(const MovieFormat& format) {
    return format.muxer != "mp4" && format.muxer != "mov";
}

void add_to_hash(Sha256Stream& hash, const Image& image) {
    const Sha256 pixels = pixel_hash(image);
    hash.add(pixels.data(), pixels.size());
}

/// Throws InputError for a film that has no light of its own to write.
void check_light(const Film& film, const FilmRuns& runs) {
    const auto refuse = [&](const std::string& key, std::string_view what) {
        throw InputError(
            fmt::format("{}OpenEXR files hold the light of a run; {}", film.at(key), what));
    };
    if (!film.excerpts.empty()) refuse("excerpt", "cut its pieces from one film each");
    if (runs.size() > 1) refuse("panes.show", "make a film of each run");
    for (std::size_t i = 0; i < film.cards.size(); ++i) {
        if (film.cards[i].ground != CardBackground::picture)
            refuse(fmt::format("card.{}.ground", i), "leave out cards before and after the shots");
    }
}

/// One film being made into one file.
class FilmMaker {
  public:
    FilmMaker(const FilmOutput& output, const FilmRuns& runs, const std::string& remake,
              const WorkOptions& work, StatusLine& status, PictureCache* cache)
        : output_(output),
          film_(output.film),
          runs_(runs),
          beds_(runs.first()),
          status_(status),
          facts_{film_.settings.title.empty() ? beds_.scene().title : film_.settings.title, remake},
          pool_(work.threads, "fumon-render"),
          cache_(holds_light(output.file) ? nullptr : cache),
          drawn_(with_whole_layer_paths(film_)),
          painter_(film_frames(drawn_, runs, facts_, work.backend, pool_, cache_)),
          layers_(layer_records(film_)) {
        if (holds_light(output.file)) check_light(film_, runs);
        for (const std::string& note : painter_->notes()) status.note(note);
        const MovieFormat* format = find_movie_format(film_.settings.format);
        const bool transparent = painter_->transparent();
        open_ = transparent && (format == nullptr || !format->open_pixels.empty());
        if (transparent && !open_) {
            status.note(fmt::format("{}: {} has no alpha, so its background is white; {} have",
                                    output.file.string(), film_.settings.format,
                                    transparent_format_names()));
        }
    }

    MadeFilm make() {
        const FilmSize size = film_size(film_);
        made_ = {painter_->frames(), static_cast<double>(painter_->frames()) / film_.settings.rate,
                 static_cast<int>(size.width), static_cast<int>(size.height)};
        try {
            const std::string& format = film_.settings.format;
            if (format == "poster") {
                write_poster();
            } else if (format == "sheet") {
                write_sheet();
            } else if (format == "sequence") {
                write_sequence();
            } else if (format == "gif" || output_.most_bytes > 0) {
                write_in_tries();
            } else {
                write_at_once();
            }
        } catch (const Interrupted& stop) {
            made_.signal = stop.signal;
            made_.goes_on = kept_.has_value();
        }
        status_.clear();
        return made_;
    }

  private:
    Image draw(std::int64_t frame, std::int64_t all) {
        made_.begun_frame = frame;
        if (const int signal = interrupting_signal(); signal != 0) throw Interrupted{signal};
        const std::int64_t drawn_before = cache_ ? cache_->drawn() : 0;
        std::optional<Image> before = kept_ ? kept_->find(frame) : std::nullopt;
        const bool fits = before && before->width == painter_->size().width &&
                          before->height == painter_->size().height;
        Image image = fits ? *std::move(before) : painter_->paint(frame);
        if (image.transparent() && !open_) image = composited_on(image, 255);
        if (kept_ && !fits) kept_->add(frame, image);
        pace_.count(!fits && (!cache_ || cache_->drawn() > drawn_before), watch_.seconds());
        if (JobWatch* const job = status_.watch(); job != nullptr) {
            job->tell(
                {{"frames", pace_.done(), all, fmt::format("{:.2g} frames/s", pace_.per_second())}},
                pace_.seconds_left(all));
            if (job->wants_picture()) {
                job->show(std::make_shared<const Image>(image), fmt::format("frame {}", frame));
            }
        }
        if (status_.due()) status_.show(pace_.text(all));
        return image;
    }

    /// Draws all frames and hands them on, each while the next one is drawn.
    void draw_all(const FrameConsumer::Use& use) {
        const BlockPool::Repetition frames(BlockPool::shared());
        FrameConsumer consumer([&](const Image& image) {
            add_to_hash(pixels_, image);
            use(image);
        });
        for (std::int64_t frame = 0; frame < painter_->frames(); ++frame)
            consumer.add(draw(frame, painter_->frames()));
        consumer.finish();
    }

    /// Of a file of this film, with the hash of its pixels.
    [[nodiscard]] PictureText texts_of(const Film& film, const Sha256& pixels,
                                       const std::string& environment) const {
        PictureText texts;
        if (!facts_.title.empty()) texts.emplace_back("Title", facts_.title);
        texts.emplace_back("Software", "fumon " FUMON_VERSION);
        texts.emplace_back(version_keyword, FUMON_VERSION);
        texts.emplace_back(film_keyword, film_toml(film));
        texts.emplace_back(remake_keyword, facts_.remake);
        texts.emplace_back("fumon:scene", resolved_scene(beds_.scene(), beds_.inputs()));
        texts.emplace_back(runs_keyword, filmed_runs_text(runs_));
        if (!layers_.empty()) texts.emplace_back(layers_keyword, filmed_layers_text(layers_));
        add_between(texts);
        if (output_.most_bytes > 0)
            texts.emplace_back(most_bytes_keyword, fmt::format("{}", output_.most_bytes));
        texts.emplace_back("fumon:pixels-sha256", hex(pixels));
        texts.emplace_back("fumon:environment", environment);
        return texts;
    }

    /// Says in a file's texts what no model computed.
    void add_between(PictureText& texts) const {
        if (film_.settings.between == RecordsBetween::blend)
            texts.emplace_back("fumon:between-records",
                               "blended: heights, water and colours between two stored records "
                               "change evenly in time and were computed by no model");
    }

    /// On the thread that draws.
    [[nodiscard]] std::string environment() const {
        return environment_text(painter_->record().environment);
    }

    [[nodiscard]] PictureText texts() const {
        return texts_of(film_, pixels_.so_far(), environment());
    }

    [[nodiscard]] std::int64_t poster_frame() const {
        const double second = film_.settings.poster_second;
        if (second < 0.0) return painter_->frames() / 2;
        return std::min<std::int64_t>(std::lround(second * film_.settings.rate),
                                      painter_->frames() - 1);
    }

    void write_poster() {
        made_.frames = 1;
        if (holds_light(output_.file)) return write_light(poster_frame(), output_.file);
        const Image image = draw(poster_frame(), 1);
        add_to_hash(pixels_, image);
        write_file(output_.file,
                   encode_png(image, beds_.scene().view.image.dots_per_inch, texts()));
    }

    [[nodiscard]] ContactSheet sheet_of_frames() const {
        return {painter_->frames(), film_.settings.rate, made_.width, made_.height};
    }

    void write_sheet() {
        ContactSheet sheet = sheet_of_frames();
        const auto count = static_cast<std::int64_t>(sheet.frames().size());
        made_.frames = 0;
        for (const std::int64_t frame : sheet.frames()) {
            ++made_.frames;
            const Image image = draw(frame, count);
            add_to_hash(pixels_, image);
            sheet.add(frame, image);
        }
        write_file(output_.file, encode_png(sheet.image(), sheet_dots_per_inch, texts()));
    }

    /// Each frame as a poster, which `fumon again` draws alone.
    void write_sequence() {
        if (holds_light(output_.file)) return write_lights();
        if (output_.goes_on) kept_.emplace(output_.file, identity());
        const double dots_per_inch = beds_.scene().view.image.dots_per_inch;
        const std::string drawn_by = environment();
        Film film = film_;
        film.settings.format = "poster";
        draw_all([&, frame = std::int64_t{0}](const Image& image) mutable {
            Sha256Stream pixels;
            add_to_hash(pixels, image);
            film.settings.poster_second = static_cast<double>(frame) / film_.settings.rate;
            write_file(sequence_file(output_.file, frame++),
                       encode_png(image, dots_per_inch, texts_of(film, pixels.so_far(), drawn_by)));
        });
        if (kept_) kept_->finish();
    }

    /// The light of a frame, for editors, which `fumon again` draws alone.
    void write_light(std::int64_t frame, const fs::path& file) {
        made_.begun_frame = frame;
        if (const int signal = interrupting_signal(); signal != 0) throw Interrupted{signal};
        const LayeredImage light = painter_->light(frame);
        Film film = film_;
        film.settings.format = "poster";
        film.settings.poster_second = static_cast<double>(frame) / film_.settings.rate;
        write_file(file, encode_exr(light, beds_.scene().view.image.dots_per_inch,
                                    texts_of(film, layers_hash(light), environment())));
        pace_.count(true, watch_.seconds());
    }

    void write_lights() {
        for (std::int64_t frame = 0; frame < painter_->frames(); ++frame) {
            write_light(frame, sequence_file(output_.file, frame));
            if (status_.due()) status_.show(pace_.text(painter_->frames()));
        }
    }

    /// The sheet beside a movie, as one that is made alone.
    void write_sheet_beside(const ContactSheet& sheet, const Sha256Stream& pixels) {
        Film film = film_;
        film.settings.format = "sheet";
        write_file(output_.sheet, encode_png(sheet.image(), sheet_dots_per_inch,
                                             texts_of(film, pixels.so_far(), environment())));
        made_.sheet_frames = static_cast<std::int64_t>(sheet.frames().size());
    }

    [[nodiscard]] const MovieFormat& format() const {
        return *find_movie_format(film_.settings.format);
    }

    [[nodiscard]] PictureText movie_texts() const {
        PictureText all = texts();
        all.emplace_back("fumon:encoder", movie_encoder());
        return all;
    }

    void write_at_once() {
        if (output_.goes_on) kept_.emplace(output_.file, identity());
        const TransientFile part{plays_while_incomplete(format())
                                     ? fs::path()
                                     : temporary_name(resolved_link(output_.file))};
        Movie movie(kept_ ? kept_->whole() : output_.file, made_.width, made_.height,
                    film_.settings.rate,
                    MovieCoding{format(), static_cast<int>(film_.settings.quality), nullptr, open_,
                                kept_ ? kept_->so_far() : part.file, film_.settings.draft});
        std::optional<ContactSheet> sheet;
        if (!output_.sheet.empty()) sheet.emplace(sheet_of_frames());
        Sha256Stream pixels_of_sheet;
        draw_all([&, frame = std::int64_t{0}](const Image& image) mutable {
            movie.add(image);
            if (sheet && sheet->shows(frame)) {
                add_to_hash(pixels_of_sheet, image);
                sheet->add(frame, image);
            }
            ++frame;
        });
        made_.width = movie.padded_width();
        made_.height = movie.padded_height();
        movie.finish(movie_texts());
        if (kept_) kept_->finish();
        if (sheet) write_sheet_beside(*sheet, pixels_of_sheet);
    }

    /// All that decides the frames.
    [[nodiscard]] std::string identity() const {
        return film_toml(film_) + filmed_runs_text(runs_) + facts_.remake + FUMON_VERSION +
               environment();
    }

    /// Keeps the frames, and encodes them worse and smaller until they fit.
    void write_in_tries() {
        FrameSpool spool(output_.file, made_.width, made_.height, open_);
        ColourCounts counts;
        draw_all([&](const Image& image) {
            counts.add(image);
            spool.add(image);
        });
        std::optional<ColourTable> colours;
        if (film_.settings.format == "gif") colours.emplace(counts);
        const bool has_quality =
            film_.settings.format != "gif" && film_.settings.format != "apng" &&
            film_.settings.format != "ffv1" && film_.settings.format != "prores";
        int quality = static_cast<int>(film_.settings.quality);
        double scale = 1.0;
        for (int tries = 0; tries < most_try_count; ++tries) {
            const std::int64_t bytes = encode(spool, colours ? &*colours : nullptr, quality, scale);
            if (output_.most_bytes == 0 || bytes <= output_.most_bytes) return;
            fs::remove(output_.file);
            if (has_quality && quality + rate_factor_step <= worst_rate_factor) {
                quality += rate_factor_step;
                continue;
            }
            const double ratio =
                static_cast<double>(output_.most_bytes) / static_cast<double>(bytes);
            scale *= std::min(0.95, 0.98 * std::sqrt(ratio));
            const FilmSize size = film_size(film_);
            if (static_cast<double>(std::min(size.width, size.height)) * scale < smallest_film_side)
                break;
        }
        throw Error(
            fmt::format("{}: cannot be made as small as {} bytes; make the film shorter, or lower "
                        "its frame rate",
                        output_.file.string(), with_commas(output_.most_bytes)));
    }

    std::int64_t encode(const FrameSpool& spool, const ColourTable* colours, int quality,
                        double scale) {
        const FilmSize size = film_size(film_);
        const auto scaled = [&](std::int64_t side) {
            if (scale == 1.0) return static_cast<int>(side);
            return std::max(
                2, 2 * static_cast<int>(std::lround(0.5 * scale * static_cast<double>(side))));
        };
        Movie movie(output_.file, scaled(size.width), scaled(size.height), film_.settings.rate,
                    MovieCoding{format(), quality, colours, open_});
        for (std::int64_t frame = 0; frame < spool.frames(); ++frame) {
            if (const int signal = interrupting_signal(); signal != 0) throw Interrupted{signal};
            movie.add(resized(spool.frame(frame), scaled(size.width), scaled(size.height)));
        }
        made_.width = movie.padded_width();
        made_.height = movie.padded_height();
        movie.finish(movie_texts());
        return static_cast<std::int64_t>(fs::file_size(output_.file));
    }

    const FilmOutput& output_;
    const Film& film_;
    const FilmRuns& runs_;
    const StoredBeds& beds_;
    StatusLine& status_;
    TitleFacts facts_;
    WorkerPool pool_;
    PictureCache* cache_;
    Film drawn_;  ///< the same, with where the files of its layers lie
    std::unique_ptr<FilmFrames> painter_;
    std::vector<LayerRecord> layers_;  ///< files of its layers
    bool open_ = false;                ///< its frames have alpha
    Sha256Stream pixels_;
    Stopwatch watch_;
    FramePace pace_;
    MadeFilm made_;
    std::optional<FrameCache> kept_;

  public:
    /// What stands beside the file.
    void write_beside() const {
        const std::string& name = film_.settings.format;
        if (find_movie_format(name) == nullptr) return;
        if (!film_.captions.empty()) {
            write_file(captions_of(output_.file),
                       subrip(ready_captions(film_, beds_.scene(), beds_.first(), facts_)));
        }
        if (format().muxer == "mp4") return;
        nlohmann::ordered_json json;
        for (const auto& [keyword, text] : movie_texts()) json[keyword] = text;
        write_file(sidecar_of(output_.file), json_text(json, 2) + "\n");
    }
};

}  // namespace

fs::path captions_of(fs::path file) {
    return file.replace_extension(".srt");
}

MadeFilm make_film(const FilmOutput& output, const FilmRuns& runs, const std::string& remake,
                   const WorkOptions& work, StatusLine& status, PictureCache* cache) {
    FilmMaker maker(output, runs, remake, work, status, cache);
    const MadeFilm made = maker.make();
    if (made.signal == 0) maker.write_beside();
    return made;
}

}  // namespace fumon
