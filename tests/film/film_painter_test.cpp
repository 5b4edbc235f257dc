#include "film/film_painter.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

#include "film/film_read.h"
#include "scene/placed_sun.h"
#include "support/program.h"

namespace fumon {
namespace {

using test::fumon;
using test::ScratchFolder;

/// A run of the small scene that stored every bed, made once.
const std::filesystem::path& filmed_run() {
    static const ScratchFolder folder;
    static const std::filesystem::path run = [] {
        test::write_text(folder / "scene.toml", test::small_scene());
        fumon({"run", "scene.toml", "-o", "out", "--quiet", "--set", "output.fields_every=1",
               "--set", "look.ground=table", "--set", "look.light=sun", "--set",
               "output.frames=false", "--set", "output.movie=false"},
              folder.path());
        return folder / "out";
    }();
    return run;
}

constexpr const char* film_head = "[film]\nwidth = 64\nheight = 48\nrate = 5\nsupersampling = 1\n";

/// A film's painter with all that it needs.
struct FilmAtWork {
    explicit FilmAtWork(const std::string& text)
        : film(parse_film(film_head + text, "f.toml")),
          runs({filmed_run().string()}, 1),
          beds(runs.first()),
          pool(1),
          painter(film, runs, film_size(film), {}, gl::Backend::automatic, pool) {}

    Film film;
    FilmRuns runs;
    const StoredBeds& beds;
    WorkerPool pool;
    FilmPainter painter;
};

TEST(StoredBeds, AreThoseThatTheRunRecorded) {
    const StoredBeds beds(filmed_run(), 1);
    ASSERT_EQ(beds.beds().size(), 21U);
    EXPECT_EQ(beds.beds()[7].step, 7);
    EXPECT_EQ(beds.snapshot(7)->step, 7);
    EXPECT_EQ(visible_change(*beds.snapshot(0), beds.first()), 0.0);
    EXPECT_GT(visible_change(*beds.snapshot(20), beds.first()), 0.0);
    EXPECT_EQ(beds.heights(12)->bed, beds.snapshot(12)->bed);
    EXPECT_EQ(beds.heights(13)->step, 13);
    EXPECT_EQ(beds.heights(13)->bed, StoredBeds(filmed_run(), 1).snapshot(13)->bed);
    EXPECT_EQ(beds.scene().title, "small");
    const auto rows = beds.measurements({"step", "wavelength_spectrum"});
    EXPECT_EQ(rows[4].find("step")->values.size(), 1U);
    EXPECT_EQ(rows[20].find("step")->values.size(), 5U);
}

TEST(StoredBeds, BetweenTwoOfThemHeightsAreTheirMean) {
    const StoredBeds beds(filmed_run(), 1);
    const auto middle = beds.snapshot(RecordPlace{4, 8, 0.5});
    EXPECT_EQ(middle->step, 6);
    EXPECT_EQ(middle->time, 6.0);
    const Grid& one = beds.snapshot(4)->bed;
    const Grid& other = beds.snapshot(8)->bed;
    ASSERT_NE(one, other);
    for (std::size_t i = 0; i < one.size(); ++i)
        ASSERT_EQ(middle->bed.values()[i], 0.5 * (one.values()[i] + other.values()[i]));
    EXPECT_EQ(beds.snapshot(RecordPlace{4, 8, 0.0}), beds.snapshot(4));
}

TEST(BedClock, BlendsEvenlyInTimeAtEveryPace) {
    const auto place = [](const std::string& settings) {
        const FilmAtWork film("[[shot]]\nseconds = 1\nfrom = 0\nto = 1\n" + settings);
        const Film blending = [&] {
            Film copy = film.film;
            copy.settings.between = RecordsBetween::blend;
            return copy;
        }();
        EXPECT_EQ(BedClock(film.film, 0, film.beds).place_at(0.3), (RecordPlace{0, 0, 0.0}));
        return BedClock(blending, 0, film.beds).place_at(0.25);
    };
    EXPECT_EQ(place(""), (RecordPlace{0, 1, 0.25}));
    const RecordPlace late = place("pace = \"logarithmic\"\n");
    EXPECT_NEAR(late.share, std::pow(2.0, 0.25) - 1.0, 1e-12);  // of a time that grows by factors
}

// What slides show of a film that does not play yet.
TEST(FilmPainter, TheFirstFrameHasNothingOfACardThatComes) {
    const std::string shot = "[[shot]]\nseconds = 2\n";
    FilmAtWork plain(shot);
    FilmAtWork titled(shot + "[[card]]\ntitle = \"dunes\"\nseconds = 2\n");
    EXPECT_EQ(titled.painter.paint(0), plain.painter.paint(0));
    EXPECT_NE(titled.painter.paint(1), plain.painter.paint(1));
}

/// A time stamp and a scale bar stay as bright under a title as without one.
TEST(FilmPainter, ATitleDoesNotDarkenWhatIsWrittenOverThePicture) {
    const std::string shot =
        "[[shot]]\nseconds = 2\nfrom = 4\nto = 4\n"
        "[[overlay]]\nkind = \"time\"\nopacity = 1\nfont_size = 6\n";
    FilmAtWork plain(shot);
    FilmAtWork titled(shot + "[[card]]\ntitle = \"i\"\nseconds = 2\nfade = 0\n");
    const Image bright = plain.painter.paint(4);
    const Image dimmed = titled.painter.paint(4);
    const auto brightest = [](const Image& image) {  // where the plate is
        int most = 0;
        for (int y = 0; y < 16; ++y)
            for (int x = 0; x < 24; ++x) most = std::max<int>(most, image.row(y)[3 * x]);
        return most;
    };
    EXPECT_GT(brightest(bright), 240);
    EXPECT_EQ(brightest(dimmed), brightest(bright));
    EXPECT_LT(dimmed.row(46)[3 * 60], bright.row(46)[3 * 60]) << "the picture itself is darker";
}

TEST(BedClock, KeepsItsPace) {
    const FilmAtWork at(
        "[[shot]]\n[[shot]]\npace = \"logarithmic\"\n[[shot]]\nfrom = 20\nto = 5\n"
        "[[shot]]\nfrom = 4\nto = 4\n[[shot]]\npace = \"change\"\n[[shot]]\nclock = \"time\"\nfrom "
        "= 3\nto = 9.2\n");
    const auto& shots = at.painter.shots();
    EXPECT_EQ(shots[0].bed_at(0.5), 10U);
    EXPECT_EQ(shots[0].bed_at(1.0), 20U);
    EXPECT_EQ(shots[1].bed_at(0.5), 4U);  // sqrt(21) - 1 = 3.6
    EXPECT_EQ(shots[2].bed_at(0.0), 20U);
    EXPECT_EQ(shots[2].bed_at(1.0), 5U);
    EXPECT_EQ(shots[3].bed_at(0.7), 4U);
    EXPECT_EQ(shots[5].bed_at(1.0), 9U);
    // Equal visible change: no half of the shot shows more of it than the other, but for one bed's.
    const auto& beds = at.beds;
    const auto change = [&](std::size_t from, std::size_t to, double& most) {
        double sum = 0.0;
        for (std::size_t i = from; i < to; ++i) {
            const double one = visible_change(*beds.snapshot(i), *beds.snapshot(i + 1));
            most = std::max(most, one);
            sum += one;
        }
        return sum;
    };
    double most = 0.0;
    const std::size_t middle = shots[4].bed_at(0.5);
    const double first_half = change(0, middle, most);
    const double second_half = change(middle, 20, most);
    EXPECT_NEAR(first_half, second_half, 1.01 * most);
}

TEST(BedClock, OfADraftLooksAtFewerBeds) {
    Film film;
    EXPECT_EQ(stride_over(400, film), 1U);
    film.settings.draft = true;
    EXPECT_EQ(stride_over(400, film), 10U);
    EXPECT_EQ(stride_over(39, film), 1U);

    const ScratchFolder folder;
    test::write_text(folder / "scene.toml", test::small_scene());
    ASSERT_EQ(fumon({"run", "scene.toml", "-o", "out", "--quiet", "--set", "run.steps=90", "--set",
                     "output.fields_every=1", "--set", "output.frames=false", "--set",
                     "output.movie=false"},
                    folder.path())
                  .status,
              0);
    const StoredBeds beds((folder / "out").string(), 1);
    const auto clock = [&](const std::string& draft) {
        return BedClock(parse_film("[[shot]]\npace = \"change\"\n[film]\ndraft = " + draft, "f"), 0,
                        beds);
    };
    const BedClock whole = clock("false");
    const BedClock quick = clock("true");
    EXPECT_EQ(quick.bed_at(0.0), 0U);
    EXPECT_EQ(quick.bed_at(1.0), 90U);
    for (const double share : {0.2, 0.5, 0.8}) {
        EXPECT_NEAR(static_cast<double>(quick.bed_at(share)),
                    static_cast<double>(whole.bed_at(share)), 6.0)
            << share;
    }
}

TEST(FilmPainter, AFreezeWithAStillCameraDoesNotChange) {
    FilmAtWork at(
        "[[shot]]\nseconds = 1\nfrom = 12\nto = 12\n[[overlay]]\nkind = \"time\"\nfont_size = 6\n");
    const Image first = at.painter.paint(0);
    for (std::int64_t frame = 1; frame < at.painter.frames(); ++frame)
        EXPECT_EQ(at.painter.paint(frame), first) << frame;
}

TEST(FilmPainter, FramesDoNotDependOnThoseDrawnBefore) {
    FilmAtWork at(
        "[[shot]]\nseconds = 1\nmove = \"morning-to-evening\"\n[[shot]]\nseconds = 1\nmove = "
        "\"orbit\"\ntransition = \"cross-fade\"\ntransition_seconds = 0.4\nexposure = 1\n");
    std::vector<Image> frames;
    for (std::int64_t i = 0; i < at.painter.frames(); ++i) frames.push_back(at.painter.paint(i));
    for (std::int64_t i = at.painter.frames() - 1; i >= 0; --i)
        EXPECT_EQ(at.painter.paint(i), frames[static_cast<std::size_t>(i)]) << i;
    EXPECT_NE(frames[0], frames[2]);
}

TEST(FilmPainter, ThePlainLiesInTheLightOfTheShotsSun) {
    FilmAtWork at(
        "[[shot]]\nseconds = 1\nsun_elevation = 4\n[[shot]]\nseconds = 1\nsun_elevation = 60\n");
    const auto redness = [&](std::int64_t frame) {
        const Image image = at.painter.paint(frame);
        return image.rgb[0] - image.rgb[2];  // in its upper left corner, beside the block
    };
    const int low_sun = redness(0);
    EXPECT_GT(low_sun, redness(9) + 5);
    EXPECT_EQ(redness(0), low_sun);
}

/// A run whose sun wanders takes it along, unless a shot says where it stands.
TEST(FilmPainter, TheSunOfARunWandersInItsFilmToo) {
    const std::vector<std::string> morning{"sun.place=[23, 5]", "sun.time=2026-03-20T06:30Z",
                                           "sun.hours=5"};
    const std::string bare = film_head;
    const auto paint = [&](const std::string& shot, bool wanders, std::int64_t frame) {
        std::vector<StoredBeds> beds;
        beds.emplace_back(filmed_run(), 1, wanders ? morning : std::vector<std::string>{});
        const FilmRuns runs(std::move(beds));
        const Film film = parse_film(bare + shot, "f.toml");
        WorkerPool pool(1);
        FilmPainter painter(film, runs, film_size(film), {}, gl::Backend::automatic, pool);
        return painter.paint(frame);
    };
    const std::string shot = "[[shot]]\nseconds = 2\n";
    // The last bed at the first: only the light can differ.
    const std::string frozen_late = "[[shot]]\nseconds = 2\nfrom = \"end\"\n";
    const SunSettings sun = [&] {
        const StoredBeds beds(filmed_run(), 1, morning);
        return sun_at(beds.scene().view.sun, 1.0);
    }();
    const std::string there =
        fmt::format("sun_azimuth = {}\nsun_elevation = {}\n", sun.azimuth, sun.elevation);
    EXPECT_EQ(paint(frozen_late, true, 3), paint(frozen_late + there, false, 3));
    EXPECT_NE(paint(frozen_late, true, 3), paint(frozen_late + "sun_azimuth = 200\n", true, 3));
    EXPECT_NE(paint(shot, true, 9), paint(shot, false, 9));
}

double film_brightness(const Image& image) {
    double sum = 0.0;
    for (const std::uint8_t value : image.rgb) sum += value;
    return sum / static_cast<double>(image.rgb.size());
}

TEST(FilmPainter, KeysMoveCameraLensSunAndExposure) {
    FilmAtWork at(
        "[[shot]]\nseconds = 2\nmove = \"keys\"\nspeed = \"constant\"\nfocal_length = 30\n"
        "[[shot.key]]\nat = [2, 3, 6]\nlook_at = [12, 10, 0]\n"
        "[[shot.key]]\nat = [20, 4, 9]\nlook_at = [12, 12, 0]\nfocal_length = 60\nsun_azimuth = "
        "100\nsun_elevation = 20\nexposure = 2\n");
    const StagedShot& shot = at.painter.shots().front();
    const FilmStage& stage = at.painter.stage();
    const auto& bed = *at.beds.snapshot(0);
    EXPECT_LT(glm::length(shot.pose_at(0.0).eye - place_on_stage(stage, {2, 3, 6}, bed)), 1e-9);
    EXPECT_LT(glm::length(shot.pose_at(1.0).eye - place_on_stage(stage, {20, 4, 9}, bed)), 1e-9);
    EXPECT_LT(glm::length(shot.pose_at(1.0).look_at - place_on_stage(stage, {12, 12, 0}, bed)),
              1e-9);
    EXPECT_NEAR(shot.pose_at(0.0).focal_length, 30.0, 1e-9);
    EXPECT_NEAR(shot.pose_at(0.5).focal_length, std::sqrt(30.0 * 60.0), 0.5);
    EXPECT_NEAR(shot.pose_at(1.0).sun_azimuth, 100.0, 1e-9);
    EXPECT_NEAR(camera_of(stage, shot.pose_at(1.0)).half.y, 12.0 / 60.0, 1e-9);
    EXPECT_GT(film_brightness(at.painter.paint(9)), film_brightness(at.painter.paint(0)) + 20.0);
}

/// The largest distance of the bed's corners from the picture's middle, 1 at its edge.
double film_extent(const std::string& size, const std::string& move) {
    const Film film =
        parse_film("[film]\n" + size + "[[shot]]\nmove = \"" + move + "\"\n", "f.toml");
    const FilmRuns runs({filmed_run().string()}, 1);
    const FilmStage stage = make_stage(film, runs.first(), film_size(film));
    const StagedShot shot(film, 0, stage, runs);
    double most = 0.0;
    for (int i = 0; i <= 40; ++i) {
        const Camera camera = camera_of(stage, shot.pose_at(i / 40.0));
        for (const glm::dvec3& corner : block_corners(stage.block)) {
            const glm::dvec2 seen = project(camera, corner);
            most = std::max({most, std::abs(seen.x), std::abs(seen.y)});
        }
    }
    return most;
}

TEST(FilmPainter, ABedThatFitsFillsThePictureWhateverItsShape) {
    for (const char* size : {"size = \"1080p\"\n", "size = \"vertical\"\n", "size = \"square\"\n",
                             "size = \"widescreen\"\n"}) {
        for (const char* move : {"still", "orbit"}) {
            EXPECT_LE(film_extent(size, move), 1.0) << size << move;
            EXPECT_GE(film_extent(size, move), 0.85) << size << move;
        }
    }
}

TEST(FilmPainter, TheColourBarHasTheRangeOfTheWholeFilm) {
    const ScratchFolder folder;
    test::write_text(folder / "scene.toml", test::small_scene());
    ASSERT_EQ(fumon({"run", "scene.toml", "-o", "out", "--quiet", "--set", "output.bed_every=5",
                     "--set", "look.colour_by=height", "--set", "look.ground=table", "--set",
                     "output.movie=false"},
                    folder.path())
                  .status,
              0);
    const Film film =
        parse_film(std::string(film_head) + "[[shot]]\nseconds = 1\nfrom = 5\nto = 15\n", "f.toml");
    const FilmRuns runs({(folder / "out").string()}, 1);
    const StoredBeds& beds = runs.first();
    ASSERT_EQ(beds.beds().size(), 5U);  // of the files in beds/
    WorkerPool pool(1);
    const FilmPainter painter(film, runs, film_size(film), {}, gl::Backend::automatic, pool);
    const LookSettings& look = painter.stage().scene.view.look;
    ASSERT_FALSE(look.low.is_word());
    const auto range_of = [&](std::size_t number) {
        const auto& heights = beds.snapshot(number)->bed.values();
        return *std::max_element(heights.begin(), heights.end());
    };
    const double highest = std::max({range_of(1), range_of(2), range_of(3)});
    EXPECT_LE(look.high.value, highest);
    EXPECT_GT(look.high.value, 0.8 * highest);
}

/// The levels of a place's pixel.
std::array<int, 3> film_levels_at(const FilmPainter& painter, const Image& image,
                                  const std::vector<double>& place, const Snapshot& bed) {
    const FilmStage& stage = painter.stage();
    const Camera camera = camera_of(stage, painter.shots().front().pose_at(0.0));
    const glm::dvec2 seen = project(camera, place_on_stage(stage, place, bed));
    const std::uint8_t* pixel =
        image.row(static_cast<int>(0.5 * (1.0 - seen.y) * image.height)) +
        std::ptrdiff_t{3} * static_cast<int>(0.5 * (1.0 + seen.x) * image.width);
    return {pixel[0], pixel[1], pixel[2]};
}

TEST(FilmPainter, GroundThatDoesNotChangeKeepsItsColourWhileAPileGrows) {
    const ScratchFolder folder;
    std::string uneven = "ncols 24\nnrows 20\nxllcorner 0\nyllcorner 0\ncellsize 1\n";
    for (int cell = 0; cell < 24 * 20; ++cell)
        uneven += std::to_string(cell * 7 % 11 % 3) + (cell % 24 == 23 ? "\n" : " ");
    test::write_text(folder / "uneven.asc", uneven);
    test::write_text(
        folder / "scene.toml",
        "seed = 5\n[model]\nname = \"sandpile\"\ndrop_x = [4]\ndrop_y = [4]\ngrains_per_step = 20\n"
        "[bed]\nfile = \"uneven.asc\"\n[run]\nsteps = 20\n"
        "[frames]\nevery = 20\n[camera]\nazimuth = 45\nelevation = 50\n"
        "[look]\ncolour_by = \"height\"\npalette = \"viridis\"\nexaggeration = 0.5\nroom = 12\n");
    ASSERT_EQ(fumon({"run", "scene.toml", "-o", "out", "--quiet", "--set", "output.fields_every=20",
                     "--set", "output.frames=false", "--set", "output.movie=false"},
                    folder.path())
                  .status,
              0);
    const Film film = parse_film(
        "[film]\nwidth = 192\nheight = 144\nrate = 5\n[[shot]]\nseconds = 1\nfrom = 0\nto = 20\n",
        "f.toml");
    const FilmRuns runs({(folder / "out").string()}, 1);
    WorkerPool pool(1);
    FilmPainter painter(film, runs, film_size(film), {}, gl::Backend::automatic, pool);
    const Image begin = painter.paint(0);
    const Image end = painter.paint(painter.frames() - 1);
    const Snapshot& first = runs.first().first();
    const Snapshot& last = *runs.first().snapshot(1);
    ASSERT_GT(last.bed(4, 4), 8.0) << "a pile";
    int most = 0;
    int compared = 0;
    for (int y = 12; y < 20; ++y) {
        for (int x = 14; x < 24; ++x) {
            if (first.bed(x, y) != last.bed(x, y)) continue;
            const auto one = film_levels_at(painter, begin, {x + 0.5, y + 0.5, 0.0}, first);
            const auto other = film_levels_at(painter, end, {x + 0.5, y + 0.5, 0.0}, first);
            for (std::size_t band = 0; band < 3; ++band)
                most = std::max(most, std::abs(one.at(band) - other.at(band)));
            ++compared;
        }
    }
    EXPECT_GT(compared, 60);
    EXPECT_LE(most, 3) << "levels, of the sky that the pile hides";
}

TEST(FilmPainter, ATransparentFilmFadesByWhatIsSeen) {
    FilmAtWork at(
        "background = \"transparent\"\n[[shot]]\nseconds = 1\nfrom = 9\nto = 9\n[[shot]]\nseconds "
        "= "
        "1\nfrom = 9\nto = 9\nazimuth = 120\ntransition = \"cross-fade\"\ntransition_seconds = "
        "0.4\n[[card]]\nground = \"dark\"\nplace = \"end\"\nseconds = 1\nfade = 0\n");
    const Image first = at.painter.paint(0);
    const Image second = at.painter.paint(6);
    const Image between = at.painter.paint(3);
    ASSERT_TRUE(first.transparent() && second.transparent() && between.transparent());
    EXPECT_EQ(first.alpha.front(), 0);
    for (std::size_t i = 0; i < first.alpha.size(); ++i) {
        EXPECT_NEAR(between.alpha[i], (2.0 * first.alpha[i] + second.alpha[i]) / 3.0, 1.0);
        if (first.alpha[i] == 255 && second.alpha[i] == 0) {
            EXPECT_NEAR(between.rgb[3 * i], first.rgb[3 * i], 1) << "no colour from behind";
        }
    }
    EXPECT_FALSE(at.painter.paint(at.painter.frames() - 1).transparent()) << "a dark card";
}

/// Two runs side by side, beds that change and stand still, two shots that fade into each other and
/// a card: frame after frame, what the next picture needs is found while one is drawn.
TEST(FilmPainter, FramesAreTheSameFoundAheadOrEachAlone) {
    for (const char* ground : {"endless", "table"}) {
        const Film film = parse_film(
            "[film]\nwidth = 192\nheight = 96\nrate = 5\nsupersampling = 2\ncap_height = 100\n"
            "[[shot]]\nseconds = 1.6\nfrom = 5\nto = 8\nmove = \"orbit\"\nturn = 30\n"
            "[[shot]]\nseconds = 1.6\nfrom = 9\nto = 9\nhold = 0.6\n"
            "transition = \"cross-fade\"\ntransition_seconds = 0.6\n"
            "[[card]]\nplace = \"end\"\nground = \"blurred\"\nseconds = 0.6\n",
            "f.toml");
        std::vector<StoredBeds> both;
        for (int run = 0; run < 2; ++run)
            both.emplace_back(filmed_run(), 1,
                              std::vector<std::string>{std::string("look.ground=") + ground});
        const FilmRuns runs(std::move(both));
        WorkerPool alone(1);
        WorkerPool two(2);
        FilmPainter each(film, runs, film_size(film), {}, gl::Backend::automatic, alone);
        FilmPainter ahead(film, runs, film_size(film), {}, gl::Backend::automatic, two);
        std::vector<Image> frames;
        for (std::int64_t frame = 0; frame < ahead.frames(); ++frame)
            frames.push_back(ahead.paint(frame));
        EXPECT_NE(frames[0].rgb, frames[1].rgb);
        for (std::int64_t frame = each.frames(); frame-- > 0;)
            EXPECT_EQ(each.paint(frame).rgb, frames[static_cast<std::size_t>(frame)].rgb)
                << ground << ", frame " << frame;
    }
}

}  // namespace
}  // namespace fumon
