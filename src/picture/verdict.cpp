#include "picture/verdict.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <optional>
#include <vector>

namespace fumon {

namespace {

bool same_size(const Fingerprint& first, const Fingerprint& second) {
    return first.width == second.width && first.height == second.height;
}

std::string sizes(const Fingerprint& before, const Fingerprint& after) {
    return fmt::format("{} x {} pixels were recorded, these are {} x {}", before.width,
                       before.height, after.width, after.height);
}

std::string pixels_text(const std::optional<Comparison>& comparison) {
    if (!comparison) return "its pixels differ";
    return fmt::format("{:.3g} % of its pixels differ, by {} at most",
                       100.0 * comparison->changed_share, comparison->largest);
}

std::string thumbnail_text(const ThumbnailDifference& difference, double limit) {
    return fmt::format("thumbnail {:.1f} of {:g} at column {}, row {}", difference.largest, limit,
                       difference.x, difference.y);
}

std::string tiles_text(const TileSimilarity& tiles, double limit) {
    return fmt::format("smallest tile SSIM {:.3f} of {:g} at pixel {}, {}", tiles.smallest, limit,
                       tiles.x, tiles.y);
}

std::string ignored_text(const IgnoredPixels& ignored) {
    return fmt::format("{:.3g} % of the picture ignored", 100.0 * ignored.share());
}

}  // namespace

const char* name_of(Outcome outcome) {
    switch (outcome) {
        case Outcome::as_recorded:
            return "as-recorded";
        case Outcome::differs:
            return "differs";
        case Outcome::missing:
            return "missing";
        case Outcome::wrong_input:
            return "wrong-input";
        default:
            return "failed";
    }
}

Verdict judge(const BaselineCase& one, const BaselineRecord* recorded,
              const BaselineRecord& present, const Image& got, const Image* expected,
              const RecordUse& use, const IgnoredPixels& ignored) {
    if (recorded == nullptr) {
        return {Outcome::missing,
                "nothing is recorded; look at the picture, then `fumon verify --update`"};
    }
    if (one.picture && expected == nullptr) {
        return {Outcome::missing,
                "its expected picture is missing; check this one, then `fumon verify --update`"};
    }
    const Fingerprint& before = recorded->fingerprint;
    const Fingerprint& after = present.fingerprint;
    const std::string reason =
        use.is_known_here ? "" : why_pixels_may_differ(recorded->environment, present.environment);
    std::string tier = reason.empty() ? "strict" : fmt::format("portable ({})", reason);
    if (!use.which.empty()) tier += ", " + use.which;
    const auto found = [&](bool good, std::vector<std::string> what) {
        if (ignored.any()) what.push_back(ignored_text(ignored));
        return Verdict{good ? Outcome::as_recorded : Outcome::differs,
                       fmt::format("{}: {}", tier, fmt::join(what, "; "))};
    };

    const bool same_state = recorded->state == present.state;
    std::vector<std::string> what;
    if (!same_state) what.emplace_back("the state differs");
    if (!same_size(before, after)) {
        what.push_back(sizes(before, after));
        return found(false, what);
    }
    if (recorded->ignored != present.ignored) {
        what.emplace_back(
            "what is ignored is not what it was when this was recorded; look at the picture, then "
            "`fumon verify --update`");
        return found(false, what);
    }
    if (before.pixels == after.pixels) {
        what.emplace_back(same_state ? "state and pixels as recorded" : "pixels as recorded");
        return found(same_state, what);
    }
    if (!recorded->under_overlays.empty() && recorded->under_overlays == present.under_overlays)
        what.emplace_back("text and overlays alone differ, the picture under them is as recorded");
    std::optional<Comparison> comparison;
    if (expected != nullptr) comparison = compare(*expected, got, ignored);
    const ThumbnailDifference thumbnail = thumbnail_difference(before.thumbnail, after.thumbnail);
    what.push_back(pixels_text(comparison));
    what.push_back(thumbnail_text(thumbnail, one.thumbnail_difference));
    what.push_back(comparison ? tiles_text(comparison->tiles, one.tile_ssim)
                              : "no picture is kept for SSIM");
    if (const std::string drawn = difference(recorded->environment, present.environment);
        use.is_known_here && !drawn.empty())
        what.push_back(drawn);
    const bool within = thumbnail.largest <= one.thumbnail_difference &&
                        (!comparison || comparison->tiles.smallest >= one.tile_ssim);
    return found(same_state && within && !reason.empty(), what);
}

std::string changes(const BaselineRecord& before, const BaselineRecord& after) {
    std::vector<std::string> what;
    if (before.state != after.state) what.emplace_back("the state changes");
    if (!same_size(before.fingerprint, after.fingerprint)) {
        what.push_back(sizes(before.fingerprint, after.fingerprint));
    } else if (before.fingerprint.pixels != after.fingerprint.pixels) {
        const auto thumbnail =
            thumbnail_difference(before.fingerprint.thumbnail, after.fingerprint.thumbnail);
        what.push_back(
            fmt::format("the pixels change, their thumbnail by {:.1f} at column {}, row {}",
                        thumbnail.largest, thumbnail.x, thumbnail.y));
    }
    if (before.ignored != after.ignored) what.emplace_back("what is ignored changes");
    if (const std::string drawn = difference(before.environment, after.environment); !drawn.empty())
        what.push_back(drawn);
    if (before.fumon != after.fumon)
        what.push_back(fmt::format("fumon {} there, {} here", before.fumon, after.fumon));
    return fmt::format("{}", fmt::join(what, "; "));
}

}  // namespace fumon
