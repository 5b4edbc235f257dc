#include "measure/network/network_groups.h"

#include <optional>
#include <string>

#include "base/snapshot_lookup.h"
#include "measure/network/channel_network.h"

namespace fumon {

MeasureGroup network_group(const Snapshot& first, double channel_area) {
    const std::string length = first.scale.in_metres ? "m" : "sites";
    const auto find = [channel_area](const Snapshot& snapshot) -> std::optional<NetworkShape> {
        const FlowRouting routing = route_flow(snapshot);
        return network_shape(routing, channel_area, snapshot.nodata, wraps_across(snapshot));
    };
    return group_of<NetworkShape>(
        find,
        {{"drainage_density", first.scale.in_metres ? "1/m" : "1/site",
          "length of the channels over the area", &NetworkShape::drainage_density},
         {"highest_stream_order", "", "of the channels, after Strahler",
          &NetworkShape::highest_order},
         {"stream_sources", "", "channels that begin: streams of order 1", &NetworkShape::sources},
         {"bifurcation_ratio", "", "how many times more streams an order has than the next",
          &NetworkShape::bifurcation_ratio},
         {"stream_length_ratio", "", "how many times longer streams of the next order are",
          &NetworkShape::length_ratio},
         {"weighted_bifurcation_ratio", "",
          "the same, each pair of orders weighted by its number of streams",
          &NetworkShape::weighted_bifurcation_ratio},
         {"weighted_stream_length_ratio", "",
          "how many times longer streams of the next order are, weighted likewise",
          &NetworkShape::weighted_length_ratio},
         {"channel_concavity", "", "theta of slope = k area^-theta along the channels",
          &NetworkShape::concavity},
         {"hack_exponent", "", "h of length = k area^h, of the basins of all streams",
          &NetworkShape::hack_exponent},
         {"network_spacing", length, "four times the ground's mean distance from a channel",
          &NetworkShape::spacing},
         {"longest_flow_way", length, "of water, from the divide to where it leaves",
          &NetworkShape::longest_path_length}});
}

}  // namespace fumon
