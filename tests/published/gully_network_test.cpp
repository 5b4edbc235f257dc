// The network of gullies that ships, on the whole of its ground: what halving the morphological
// factor does to the measures of the network. Two runs of 512 x 1024 cells take some half an hour
// on two processors, so they are made only where FUMON_WHOLE_NETWORK is set.

#include <gtest/gtest.h>

#include <cstdlib>

#include "published/sweep_table.h"

namespace fumon::test {
namespace {

/// Its measures after 2.25 million seconds of the bed.
SweepTable::Row network(const char* factor, const char* steps) {
    const std::string every = steps;
    const SweepTable table(
        {.scene = "gully-network.toml",
         .over = {std::string("model.morphological_factor=") + factor},
         .settings = {"run.steps=" + every, "frames.every=" + every, "output.channel_area=200"},
         .seeds = 1});
    return table.rows().empty() ? SweepTable::Row{} : table.rows().back();
}

TEST(PublishedNetwork, HalvingTheMorphologicalFactorKeepsItsMeasures) {
    if (std::getenv("FUMON_WHOLE_NETWORK") == nullptr)
        GTEST_SKIP() << "takes half an hour: set FUMON_WHOLE_NETWORK=1 and run ctest -R "
                        "PublishedNetwork";
    SweepTable::Row whole = network("1500", "140");
    SweepTable::Row halved = network("750", "240");
    EXPECT_EQ(whole["bed_time"], halved["bed_time"]);
    for (const char* measure :
         {"drainage_density", "network_spacing", "channel_concavity", "hack_exponent",
          "bifurcation_ratio", "stream_length_ratio", "stream_sources"}) {
        expect_within(halved[measure], whole[measure], 0.1, measure);
    }
}

}  // namespace
}  // namespace fumon::test
