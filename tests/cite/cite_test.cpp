#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "cite/reference_text.h"
#include "cite/scene_works.h"
#include "keys/key_value.h"
#include "scene/read.h"
#include "scene/scene_keys.h"
#include "support/program.h"

namespace fumon::test {
namespace {

std::set<std::string> ids_of(const std::string& model, const std::vector<std::string>& settings) {
    SceneText text;
    text.text = "[model]\nname = \"" + model + "\"\n[run]\nsteps = 1\n";
    const Scene scene = parse_scene(text, read_settings(settings));
    std::set<std::string> ids;
    for (const CitedWork& cited : works_of(scene)) ids.emplace(cited.work->id);
    return ids;
}

TEST(Cite, ADuneFieldCitesWhatItIsMadeOf) {
    EXPECT_EQ(ids_of("dunes", {}),
              (std::set<std::string>{"nilles_2024", "kroy_2002", "rouy_tourin_1992"}));
    EXPECT_EQ(ids_of("dunes", {"model.transport=slabs", "model.speed_up=height",
                               "model.plants=grow", "model.wall_angle=55"}),
              (std::set<std::string>{"werner_1995", "momiji_2000", "rouy_tourin_1992",
                                     "nield_baas_2008", "baas_2002", "tsoar_1983"}));
    EXPECT_TRUE(
        ids_of("dunes", {"wind.0.from=270", "wind.0.threshold_ratio=1.5"}).contains("gadal_2019"));
    EXPECT_FALSE(ids_of("dunes", {"wind.0.from=270"}).contains("gadal_2019"));
    const auto of_speed = ids_of("dunes", {"wind.0.speed=8"});
    for (const char* id : {"gadal_2019", "sauermann_2001", "duran_moore_2013"})
        EXPECT_TRUE(of_speed.contains(id)) << id;
}

TEST(Cite, DunesCiteWhatPlantsAndSlopesDo) {
    EXPECT_FALSE(ids_of("dunes", {}).contains("hersen_2004"));
    EXPECT_TRUE(ids_of("dunes", {"model.slope_deflection=0.2"}).contains("hersen_2004"));
    const auto sheltered = ids_of("dunes", {"model.plants=grow", "model.plant_shelter=raupach"});
    EXPECT_TRUE(sheltered.contains("raupach_1993"));
    EXPECT_FALSE(sheltered.contains("okin_2008"));
}

TEST(Cite, WaterCitesTheSchemeThatItIsAdvancedBy) {
    EXPECT_TRUE(ids_of("gully", {}).contains("yabe_aoki_1991"));
    EXPECT_FALSE(ids_of("gully", {}).contains("toro_2001"));
    const auto open = ids_of(
        "gully", {"model.edges_y=open", "model.transport=loads", "model.infiltration=green-ampt"});
    EXPECT_FALSE(open.contains("rossman_huber_2016"));
    EXPECT_TRUE(ids_of("water", {"model.infiltration=horton", "model.infiltration_recovery=0.1"})
                    .contains("rossman_huber_2016"));
    for (const char* id : {"saeki_okamura_2007", "toro_2001", "audusse_2004", "van_leer_1977",
                           "meyer_peter_mueller_1948", "ferguson_church_2004", "green_ampt_1911"})
        EXPECT_TRUE(open.contains(id)) << id;
    EXPECT_FALSE(open.contains("yabe_aoki_1991"));
    EXPECT_FALSE(ids_of("gully", {}).contains("meyer_peter_mueller_1948")) << "no loads";
    EXPECT_TRUE(ids_of("water", {}).contains("toro_2001"));
    EXPECT_TRUE(ids_of("gully", {"bed.file=dem.asc"}).contains("toro_2001")) << "open edges";
    EXPECT_TRUE(
        ids_of("gully", {"bed.file=dem.asc", "model.edges_x=periodic", "model.edges_y=periodic"})
            .contains("yabe_aoki_1991"));
}

TEST(Cite, PalettesCountWhereSomethingIsColoured) {
    EXPECT_FALSE(ids_of("sandpile", {"look.palette=batlow"}).contains("crameri_2021"));
    EXPECT_TRUE(ids_of("sandpile", {"look.palette=batlow", "look.colour_by=height"})
                    .contains("crameri_2021"));
}

TEST(Cite, EveryRuleNamesAWorkAKeyAndAValueThatThereAre) {
    for (const CitingRule& rule : citing_rules()) {
        EXPECT_NO_THROW(work_of(rule.work)) << rule.work;
        if (!rule.key.starts_with("model.")) continue;
        const std::string model(rule.model.empty() ? "gully" : rule.model);
        Scene scene = default_scene(model);
        const KeyTable table = scene_keys(scene);
        const Key* key = table.find(std::string(rule.key));
        ASSERT_NE(key, nullptr) << rule.key;
        EXPECT_NO_THROW(read_settings({std::string(rule.key) + "=" + std::string(rule.value)}));
        const std::string word(rule.value.substr(1, rule.value.size() - 2));
        std::vector<std::string> settings{std::string(rule.key) + "=" + word};
        if (model == "gully") {
            settings.emplace_back("model.transport=loads");
            settings.emplace_back("model.edges_y=open");
        }
        EXPECT_TRUE(ids_of(model, settings).contains(std::string(rule.work)))
            << rule.key << " " << rule.value;
    }
}

TEST(Cite, ReferencesHaveTheThreeFormats) {
    const std::vector<const Work*> works{&work_of("nield_baas_2008"), &work_of("sudo_2002")};
    const std::string text = reference_list(works, ReferenceFormat::text);
    EXPECT_TRUE(contains(
        text,
        "Nield, J. M., & Baas, A. C. W. (2008). Investigating parabolic and nebkha dune formation "
        "using a cellular automaton modelling approach. Earth Surface Processes and Landforms, 33, "
        "724–740. https://doi.org/10.1002/esp.1571\n"))
        << text;
    const std::string bibtex = reference_list(works, ReferenceFormat::bibtex);
    EXPECT_TRUE(contains(bibtex,
                         "@article{nield_baas_2008,\n  author = {Nield, J. M. and Baas, "
                         "A. C. W.},\n"))
        << bibtex;
    EXPECT_TRUE(contains(bibtex, "  pages = {724--740},\n"));
    EXPECT_TRUE(contains(bibtex,
                         "  title = {{Simulation of pattern formation in dunes}},\n"
                         "  origtitle = {{砂丘のパターン形成のシミュレーション}},\n"
                         "  note = {In Japanese},\n"))
        << bibtex;
    EXPECT_EQ(std::ranges::count(bibtex, '{'), std::ranges::count(bibtex, '}'));
    const std::string ris = reference_list(works, ReferenceFormat::ris);
    EXPECT_TRUE(contains(ris, "SP  - 724\nEP  - 740\n")) << ris;
    EXPECT_TRUE(contains(ris, "TY  - THES\nAU  - Sudo, M.\n"));
    EXPECT_EQ(short_citation(work_of("kroy_2002")), "Kroy et al. 2002");
    EXPECT_EQ(short_citation(work_of("nield_baas_2008")), "Nield & Baas 2008");
}

TEST(Cite, MethodsTellParametersAndHash) {
    const ScratchFolder folder;
    const std::string scene =
        "[model]\nname = \"dunes\"\nflux = 60\n[grid]\nnx = 64\nny = 32\ncell_size = [2]\n"
        "[run]\nsteps = 50\n";
    write_text(folder / "a.toml", scene);
    const Ended ended = fumon({"cite", "a.toml", "--methods"}, folder.path());
    EXPECT_EQ(ended.status, 0) << ended.errors;
    EXPECT_TRUE(contains(ended.output,
                         "model \"dunes\", on a grid of 64 × 32 cells of 2 m × 2 m, "
                         "for 50 steps."))
        << ended.output;
    EXPECT_TRUE(contains(ended.output, "continuous drift (Nilles et al. 2024)"));
    EXPECT_TRUE(contains(ended.output, "flux = 60.0 m^2/yr")) << ended.output;
    EXPECT_EQ(fumon({"cite", "none.toml"}, folder.path()).status, 2);
}

TEST(Cite, TheCitationFileNamesAllWorksOfModels) {
    const std::string file = read_text(std::filesystem::path(FUMON_GUIDE_FOLDER) / "CITATION.cff");
    for (const Work& work : works())
        EXPECT_TRUE(contains(file, std::string(work.title))) << work.id;
}

}  // namespace
}  // namespace fumon::test
