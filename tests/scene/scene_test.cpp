#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "base/error.h"
#include "base/stopwatch.h"
#include "keys/keys.h"
#include "models/sand/sand.h"
#include "scene/describe.h"
#include "scene/read.h"
#include "scene/scene_keys.h"
#include "scene/write.h"

namespace fumon {
namespace {

const std::string least = "[model]\nname = \"sand\"\n[run]\nsteps = 10\n";

/// The lines that reading a scene is refused with.
std::string scene_refusals(const std::string& text, const std::vector<std::string>& settings = {}) {
    try {
        parse_scene(text, "scene.toml", "", settings);
    } catch (const InputError& fault) {
        EXPECT_EQ(fault.exit_status(), 2);
        return fault.what();
    }
    return "(accepted)";
}

/// The one line that it is refused with.
std::string scene_refusal(const std::string& text, const std::vector<std::string>& settings = {}) {
    const std::string line = scene_refusals(text, settings);
    EXPECT_EQ(line.find('\n'), std::string::npos) << "one line only: " << line;
    return line;
}

TEST(Scene, DefaultsFillWhatIsNotWritten) {
    const Scene scene = parse_scene(least, "scene.toml", "");
    EXPECT_EQ(scene.model.name, "sand");
    EXPECT_EQ(scene.run.steps, 10);
    EXPECT_EQ(scene.grid.nx, 100);
    EXPECT_EQ(scene.view.image.width, 1920);
}

TEST(Scene, EveryKindOfValueIsRead) {
    const Scene scene = parse_scene(
        "title = \"砂丘\"\nseed = 42\n[model]\nname = \"sand\"\n[run]\nsteps = 1e3\n[frames]\nat = "
        "[5, 7]\n"
        "[grid]\nnx = 64\ncell_size = [0.5, 1]\nheight_unit = 2\n[bed]\nnodata = "
        "-3\n[camera]\nprojection = \"map\"\n"
        "distance = 2.5\n[output]\nmovie = false\n",
        "scene.toml", "");
    EXPECT_EQ(scene.title, "砂丘");
    EXPECT_EQ(scene.seed, 42);
    EXPECT_EQ(scene.run.steps, 1000) << "1e3 is exact, so it serves as a whole number";
    EXPECT_EQ(scene.frames.at, (std::vector<std::int64_t>{5, 7}));
    EXPECT_EQ(scene.grid.cell_size, (std::vector<double>{0.5, 1.0}))
        << "a whole number serves as a real one";
    EXPECT_DOUBLE_EQ(scene.grid.height_unit.value, 2.0);
    EXPECT_DOUBLE_EQ(scene.bed.nodata.value, -3.0);
    EXPECT_EQ(scene.view.camera.projection, Projection::map);
    EXPECT_FALSE(scene.view.camera.distance.is_word());
    EXPECT_FALSE(scene.output.movie);
}

struct Broken {
    const char* name;
    std::string text;
    std::string line;
};

void PrintTo(const Broken& broken, std::ostream* out) {
    *out << broken.name;
}

class BrokenScene : public testing::TestWithParam<Broken> {};

TEST_P(BrokenScene, IsRefusedWithOneLocatedLine) {
    EXPECT_EQ(scene_refusal(GetParam().text), GetParam().line);
}

INSTANTIATE_TEST_SUITE_P(
    All, BrokenScene,
    testing::Values(
        Broken{"misspelt_key", least + "[camera]\nazimut = 3\n",
               "scene.toml:6:1: unknown key camera.azimut; did you mean \"camera.azimuth\"?"},
        Broken{"wrong_section", least + "[sun]\nfield_of_view = 3\n",
               "scene.toml:6:1: unknown key sun.field_of_view; did you mean "
               "\"camera.field_of_view\"?"},
        Broken{
            "wrong_type", least + "[camera]\nazimuth = \"north\"\n",
            "scene.toml:6:11: camera.azimuth is 'north'; it takes a number -360 … 360 (degrees)"},
        Broken{"out_of_range", least + "[sun]\nelevation = 91\n",
               "scene.toml:6:13: sun.elevation is 91; it takes a number 1 … 90 (degrees)"},
        Broken{"fields_after_the_end", least + "[output]\nfields_at = [5, 11]\n",
               "scene.toml:6:13: output.fields_at names step 11, after the run's end at 10; "
               "lengthen run.steps or drop it"},
        Broken{"half_a_place", least + "[camera]\nat = [1, 2]\n",
               "scene.toml:6:6: camera.at has 2 numbers; it takes [east, north, above the bed]"},
        Broken{"a_place_on_a_map", least + "[camera]\nprojection = \"map\"\nlook_at = [1, 2, 3]\n",
               "scene.toml:7:11: camera.look_at belongs to camera.projection = \"perspective\""},
        Broken{"a_framing_and_a_place", least + "[camera]\nframing = \"low\"\nat = [1, 2, 3]\n",
               "scene.toml:7:6: camera.at and camera.framing both set the camera's position; keep "
               "one of them"},
        Broken{"a_framing_on_a_map", least + "[camera]\nprojection = \"map\"\nframing = \"low\"\n",
               "scene.toml:7:11: camera.framing belongs to camera.projection = \"perspective\""},
        Broken{"two_lenses", least + "[camera]\nfield_of_view = 30\nfocal_length = 50\n",
               "scene.toml:7:16: camera.focal_length and camera.field_of_view set the same "
               "quantity; keep one of them"},
        Broken{"a_lens_said_twice", least + "[camera]\nf_number = 2.8\naperture = 0.1\n",
               "scene.toml:7:12: camera.f_number and camera.aperture set the same quantity; keep "
               "one of them"},
        Broken{"a_lens_over_a_map", least + "[camera]\nprojection = \"map\"\naperture = 1\n",
               "scene.toml:7:12: camera.aperture belongs to camera.projection = \"perspective\""},
        Broken{"a_lens_before_a_figure",
               least + "[look]\nmode = \"figure\"\n[camera]\nf_number = 2.8\n",
               "scene.toml:8:12: camera.f_number belongs to look.mode = \"scenic\""},
        Broken{"a_focus_of_no_lens", least + "[camera]\nfocus = 3.5\n",
               "scene.toml:6:9: camera.focus belongs to a lens; write camera.f_number or "
               "camera.aperture"},
        Broken{"half_a_point_of_a_lens", least + "[camera]\nf_number = 2.8\nlens_samples = 16.5\n",
               "scene.toml:7:16: camera.lens_samples is 16.5; it takes a whole number"},
        Broken{"too_few_points_of_a_lens", least + "[camera]\nf_number = 2.8\nlens_samples = 2\n",
               "scene.toml:7:16: camera.lens_samples is 2; it takes \"auto\" or a number 4 … 256"},
        Broken{"an_endless_figure", least + "[look]\nground = \"endless\"\nmode = \"figure\"\n",
               "scene.toml:6:10: look.ground = \"endless\" takes look.mode = \"scenic\""},
        Broken{"clouds_in_a_plain_sky",
               least + "[look]\nsky = \"overcast\"\n[air]\nclouds = \"cirrus\"\n",
               "scene.toml:8:10: air.clouds need look.sky = \"atmosphere\" or \"auto\""},
        Broken{"clouds_of_another_planet",
               least + "[air]\nplanet = \"mars\"\nclouds = \"cumulus\"\n",
               "scene.toml:7:10: air.clouds = \"cumulus\" need the Earth's air; thin air takes "
               "\"cirrus\""},
        Broken{
            "unknown_model", "[model]\nname = \"sant\"\n",
            "scene.toml:2:8: unknown model \"sant\"; did you mean \"sand\"? (see `fumon models`)"},
        Broken{"no_model", "[run]\nsteps = 3\n",
               "scene.toml:1:1: model.name is missing; write [model] and name = \"…\" (known: "
               "sand, dunes, sandpile, gully, water, airflow, static)"},
        Broken{"no_length", "[model]\nname = \"sand\"\n",
               "scene.toml: run.steps is missing; set the length of the run, for example [run] "
               "steps = "
               "1000"},
        Broken{"unknown_choice", least + "[look]\nmode = \"figur\"\n",
               "scene.toml:6:8: look.mode is \"figur\"; it takes one of \"scenic\", \"figure\" "
               "(did you mean \"figure\"?)"},
        Broken{"bad_toml", "[model\nname = 1\n",
               "scene.toml:1:7: Error while parsing table header: expected ']', saw '\\n'; a scene "
               "is TOML: [section] lines and "
               "key = value lines"},
        Broken{"key_that_is_none", least + "[:x]\na = 1\n",
               "scene.toml:5:2: Error while parsing key: expected bare key starting character or "
               "string delimiter, saw ':'; a scene is TOML: [section] lines and key = value lines"},
        Broken{"control_characters", "\"two\\nlines\\u001b\" = 1\n" + least,
               "scene.toml:1:1: unknown key two lines?; `fumon describe sand` lists the known "
               "ones"},
        Broken{"section_as_value", "camera = 3\n" + least,
               "scene.toml:1:1: camera is a section; write [camera] and its keys below"},
        Broken{"value_as_section", least + "[seed]\nx = 1\n",
               "scene.toml:5:2: seed is not a section; it takes a whole number 0 … "
               "9.223e+18"},
        Broken{"not_whole", "seed = 1.5\n" + least,
               "scene.toml:1:8: seed is 1.5; it takes a whole number 0 … 9.223e+18"},
        Broken{"two_ways_of_frames", least + "[frames]\nevery = 2\nat = [1]\n",
               "scene.toml:7:6: frames are chosen more than once; keep one of frames.every, "
               "frames.at, "
               "frames.logarithmic"},
        Broken{"frame_after_the_end", least + "[frames]\nat = [11]\n",
               "scene.toml:6:6: frames.at names step 11, after the run's end at 10; lengthen "
               "run.steps or drop it"},
        Broken{
            "noise_upside_down", least + "[bed]\nlow = 2\nhigh = 1\n",
            "scene.toml:7:8: bed.high (1) is below bed.low (2); noise is uniform in [low, high)"},
        Broken{"too_many_cells", least + "[grid]\nnx = 100000\nny = 100000\n",
               "scene.toml:7:6: 100000 x 100000 cells are too many; at most 134217728 in all"},
        Broken{"file_without_name", least + "[bed]\nkind = \"file\"\n",
               "scene.toml:6:8: bed.file is missing; name the terrain file"},
        Broken{"infinite", least + "[sun]\nstrength = inf\n",
               "scene.toml:6:12: sun.strength is inf; it takes a number 0 … 10"},
        Broken{"item_of_a_list", least + "[frames]\nat = [1, -2]\n",
               "scene.toml:6:10: frames.at is -2; it takes a list of whole numbers 0 … 1e+15 "
               "(steps)"}),
    [](const auto& test) { return test.param.name; });

TEST(SceneFaults, AreToldAllAtOnceInOrder) {
    EXPECT_EQ(
        scene_refusals("seeed = 3\n[sun]\nelevation = 91\nazimut = 3\n[model]\nname = "
                       "\"sant\"\ncreep = 1\n[look]\nlow = 3\nhigh = 2\n",
                       {"seed=x", "camera.azimut=1"}),
        "scene.toml:1:1: unknown key seeed; did you mean \"seed\"?\n"
        "scene.toml:3:13: sun.elevation is 91; it takes a number 1 … 90 (degrees)\n"
        "scene.toml:4:1: unknown key sun.azimut; did you mean \"sun.azimuth\"?\n"
        "scene.toml:6:8: unknown model \"sant\"; did you mean \"sand\"? (see `fumon models`)\n"
        "scene.toml:10:8: look.high (2) must be above look.low (3)\n"
        "--set 1:6: seed is 'x'; it takes a whole number 0 … 9.223e+18\n"
        "--set 2:1: unknown key camera.azimut; did you mean \"camera.azimuth\"?");
}

TEST(SceneFaults, ThatFollowFromOthersAreNotTold) {
    EXPECT_EQ(scene_refusal("[model]\nname = \"sand\"\n[run]\nstesp = 9\n[frames]\nat = [4]\n"),
              "scene.toml:4:1: unknown key run.stesp; did you mean \"run.steps\"?")
        << "neither that run.steps is missing nor that a frame lies behind its end";
    EXPECT_EQ(
        scene_refusal(least + "[camera]\ntarget = 1\n"),
        "scene.toml:6:1: unknown key camera.target; `fumon describe camera` lists the known ones");
    EXPECT_EQ(scene_refusal(least + "[look]\nambient = \"x\"\nlow = 3\nhigh = 2\n").find("must be"),
              std::string::npos);
}

TEST(SceneFaults, OfAModelOnTheCommandLineAreToldOnce) {
    EXPECT_EQ(scene_refusal(least, {"model.name=sant", "model.creep=1"}),
              "--set 1:12: unknown model \"sant\"; did you mean \"sand\"? (see `fumon models`)");
    EXPECT_EQ(scene_refusal(least, {"model.name=3"}).substr(0, 11), "--set 1:12:");
}

TEST(SceneFaults, OfManyTheFirstTwentyAreTold) {
    std::string text = least;
    for (int n = 10; n < 35; ++n) text += "[x" + std::to_string(n) + "]\n";
    const std::string lines = scene_refusals(text);
    EXPECT_EQ(std::count(lines.begin(), lines.end(), '\n'), 20);
    EXPECT_TRUE(lines.ends_with("\nscene.toml: and 5 more")) << lines;
    EXPECT_NE(lines.find("scene.toml:24:2: unknown key x29"), std::string::npos) << lines;
}

TEST(SceneFaults, AreNotLookedForWhenThereAreEnough) {
    std::string text = least;
    for (int n = 0; n < 20000; ++n) text += "unknown_" + std::to_string(n) + " = 1\n";
    const std::string lines = scene_refusals(text);
    EXPECT_EQ(std::count(lines.begin(), lines.end(), '\n'), 20);
    EXPECT_TRUE(lines.ends_with("\nscene.toml: and at least 80 more")) << lines;
}

TEST(SceneFaults, ShowNumbersAsShortAsTheyAreWritten) {
    EXPECT_EQ(scene_refusal("[model]\nname = 0.1\n"),
              "scene.toml:2:8: model.name is 0.1; it takes a text in quotes");
    EXPECT_EQ(scene_refusal(least, {"title=[0.1, 2.0, [\"a\"]]"}),
              "--set 1:7: title is [0.1, 2.0, ['a']]; it takes a text in quotes");
}

TEST(SceneFile, WithoutAnEndIsRefused) {
    try {
        static_cast<void>(read_scene("/dev/zero"));
        FAIL() << "it was taken";
    } catch (const InputError& fault) {
        EXPECT_STREQ(fault.what(),
                     "/dev/zero: has more than 16777216 bytes; a scene is a TOML file");
    }
}

TEST(Settings, OverrideTheFileInOrder) {
    const Scene scene =
        parse_scene(least + "[frames]\nat = [1, 2]\n", "scene.toml", "",
                    {"run.steps=20", "camera.projection=map", "frames.at.1=9", "seed=7", "seed=8"});
    EXPECT_EQ(scene.run.steps, 20);
    EXPECT_EQ(scene.view.camera.projection, Projection::map) << "a bare word is a string";
    EXPECT_EQ(scene.frames.at, (std::vector<std::int64_t>{1, 9}));
    EXPECT_EQ(scene.seed, 8);
}

TEST(Settings, AreLocatedByNumberAndColumn) {
    EXPECT_EQ(scene_refusal(least, {"seed=1", "sun.elevation=91"}),
              "--set 2:15: sun.elevation is 91; it takes a number 1 … 90 (degrees)");
    EXPECT_EQ(scene_refusal(least, {"sun.elevatoin=9"}),
              "--set 1:1: unknown key sun.elevatoin; did you mean \"sun.elevation\"?");
    EXPECT_EQ(
        scene_refusal(least, {"seed"}),
        "--set 1:1: \"seed\" sets nothing; write key.path=VALUE, for example model.creep_rate=0.2");
    EXPECT_EQ(scene_refusal(least, {"frames.at=[1, -1]"}),
              "--set 1:15: frames.at is -1; it takes a list of whole numbers 0 … 1e+15 (steps)");
    EXPECT_EQ(scene_refusal(least + "[frames]\nat = [1]\n", {"frames.at.3=1"}),
              "--set 1:13: frames.at has no item 3; it has 1 (counted from 0)");
}

TEST(Settings, AreUtf8) {
    EXPECT_EQ(scene_refusal(least, {"title=d\xFCne"}),
              "--set 1:7: the value of title is not UTF-8; write it in that encoding");
    EXPECT_EQ(parse_scene(least, "scene.toml", "", {"title=d\xC3\xBCne"}).title, "d\xC3\xBCne");
}

TEST(Settings, ModelCanBeChosenThere) {
    EXPECT_EQ(parse_scene("", "scene.toml", "", {"model.name=static"}).model.name, "static");
}

TEST(ResolvedScene, ReadsBackTheSame) {
    const Scene scene =
        parse_scene("title = \"a \\\"quoted\\\" \\\\ title\"\n" + least +
                        "[grid]\ncell_size = 0.1\n[look]\nlow = -0.25\n[camera]\ndistance = "
                        "3\n[sun]\ndiameter = 0.30000000000000004\n",
                    "scene.toml", "");
    const std::string text = to_toml(scene);
    const Scene again = parse_scene(text, "again.toml", "");
    EXPECT_EQ(to_toml(again), text);
    EXPECT_EQ(again.title, "a \"quoted\" \\ title");
    EXPECT_EQ(again.view.sun.diameter, 0.30000000000000004);
}

TEST(ListsOfTables, AreReadAndWrittenBackInOrder) {
    const std::string text =
        least +
        "[[overlay]]\nkind = \"time\"\n[[overlay]]\ncorner = \"lower-right\"\n"
        "[figure]\nwidth = 100\n[[figure.panel]]\nx_label = \"a\"\n[[figure.panel.curve]]\n"
        "y = \"one\"\n[[figure.panel.curve]]\ny = \"two\"\n[[figure.panel]]\nkind = \"map\"\n";
    const Scene scene = parse_scene(text, "scene.toml", "");
    ASSERT_EQ(scene.view.overlays.size(), 2U);
    EXPECT_EQ(scene.view.overlays[0].kind, OverlayKind::time);
    EXPECT_EQ(scene.view.overlays[1].corner, OverlayCorner::lower_right);
    ASSERT_EQ(scene.figure.panels.size(), 2U);
    EXPECT_EQ(scene.figure.panels[1].kind, PanelKind::map);
    ASSERT_EQ(scene.figure.panels[0].curves.size(), 2U);
    EXPECT_EQ(scene.figure.panels[0].curves[1].y, "two");
    EXPECT_EQ(scene.figure.width.value, 100.0);
    const std::string written = to_toml(scene);
    EXPECT_EQ(to_toml(parse_scene(written, "again.toml", "")), written);
    EXPECT_NE(written.find("[[figure.panel.curve]]"), std::string::npos) << written;
}

TEST(ListsOfTables, OfAModelAreWrittenBackAfterItsKeys) {
    const Scene scene = parse_scene(
        "[model]\nname = \"dunes\"\nflux = 9\n[[wind]]\nfrom = 250\n[[wind]]\nfrom = 30\nduration "
        "= "
        "2\n[run]\nsteps = 3\n",
        "scene.toml", "");
    const std::string written = to_toml(scene);
    EXPECT_EQ(to_toml(parse_scene(written, "resolved.toml", "")), written);
    EXPECT_NE(written.find("[[wind]]\nfrom = 30"), std::string::npos) << written;
}

/// A resolved scene lists all keys, those too that another one rules out.
TEST(Scene, ResolvedScenesWithAFramingOrALensAreReadAgain) {
    for (const char* camera : {"framing = \"low\"", "focal_length = 50"}) {
        const Scene scene = parse_scene(
            std::string("[model]\nname = \"dunes\"\n[run]\nsteps = 1\n[camera]\n") + camera + "\n",
            "scene.toml", "");
        const std::string written = to_toml(scene);
        EXPECT_EQ(to_toml(parse_scene(written, "resolved.toml", "")), written);
    }
}

void list_from(std::int64_t& wind, const std::string& path, KeyTable& table) {
    table.integer(path + ".from", wind, {});
}

TEST(ListsOfTables, MayStandBetweenTheKeysOfTheirSection) {
    std::vector<std::int64_t> winds = {1, 2};
    std::int64_t before = 3;
    std::int64_t after = 4;
    KeyTable table;
    table.integer("model.before", before, {});
    table.tables("wind", winds, "", list_from);
    table.integer("model.after", after, {});
    EXPECT_EQ(to_toml(table),
              "\n[model]\nbefore = 3\nafter = 4\n\n[[wind]]\nfrom = 1\n\n[[wind]]\nfrom = 2\n");
}

TEST(ListsOfTables, TakeSettingsAndMoreItems) {
    const Scene scene = parse_scene(least + "[[overlay]]\n", "scene.toml", "",
                                    {"overlay.0.size=0.5", "overlay.1.kind=arrow"});
    ASSERT_EQ(scene.view.overlays.size(), 2U);
    EXPECT_EQ(scene.view.overlays[0].size, 0.5);
    EXPECT_EQ(scene.view.overlays[1].kind, OverlayKind::arrow);
    EXPECT_EQ(
        scene_refusal(least, {"overlay.7.kind=arrow"}),
        "--set 1:1: there is no overlay.7: the scene has no [[overlay]], and they are counted "
        "from 0");
}

TEST(ListsOfTables, WrongOnesAreLocated) {
    EXPECT_EQ(scene_refusal(least + "[overlay]\nkind = \"time\"\n"),
              "scene.toml:5:2: overlay is a list of sections; write [[overlay]] and its keys "
              "below, once for each");
    EXPECT_EQ(
        scene_refusal("overlay = [1]\n" + least),
        "scene.toml:1:12: overlay is a list of sections; write [[overlay]] and its keys below");
    EXPECT_EQ(scene_refusal(least + "[[overlay]]\n[[overlay]]\ncolour = 1\n").substr(0, 46),
              "scene.toml:7:1: unknown key overlay.1.colour; ");
    EXPECT_EQ(scene_refusal(least + "[[overlay]]\nkind = \"clock\"\n").substr(0, 43),
              "scene.toml:6:8: overlay.0.kind is \"clock\"; ");
}

/// So many panels in one line, each with so many curves.
std::string panels(int count, int curves) {
    std::string text = "figure.panel = [";
    for (int panel = 0; panel < count; ++panel) {
        text += "{kind = \"plot\", curve = [";
        for (int curve = 0; curve < curves; ++curve) text += "{},";
        text += "]},";
    }
    return text + "]\n";
}

TEST(ListsOfTables, AreReadInATimeThatGrowsWithTheirNumber) {
    const Stopwatch watch;
    EXPECT_NE(scene_refusals(panels(500, 2)), "");
    constexpr double far_below_a_table_for_each = 5.0;  // seconds; they were minutes
    EXPECT_LT(watch.seconds(), far_below_a_table_for_each);
}

TEST(ListsOfTables, HaveOneLimitForAllItemsThatHoldThem) {
    EXPECT_EQ(scene_refusals(panels(10, 100)).find("occurs more than"), std::string::npos);
    EXPECT_NE(
        scene_refusals(panels(10, 101)).find("[[figure.panel.curve]] occurs more than 1000 times"),
        std::string::npos);
}

TEST(Describe, ListsEveryKeyWithTypeUnitDefaultAndRange) {
    const std::string text = describe_text("scene");
    EXPECT_NE(text.find("camera.azimuth"), std::string::npos);
    EXPECT_NE(text.find("number, degrees, 1 … 90 [default 24.0]"), std::string::npos);
    EXPECT_THROW(describe_text("sant"), InputError);
    Scene scene;
    const KeyTable table = scene_keys(scene);
    for (const Key& key : table.keys()) EXPECT_FALSE(key.notes.help.empty()) << key.path;
}

TEST(Describe, DefaultsLieWithinTheirRanges) {
    Scene scene = parse_scene(least, "scene.toml", "");
    // Reading back the resolved scene checks every default against its own range.
    EXPECT_NO_THROW(parse_scene(to_toml(scene), "defaults.toml", ""));
}

}  // namespace
}  // namespace fumon
