#include "render/life/person_figure.h"

#include <array>
#include <cstdint>

#include "base/random.h"

namespace fumon {

PersonFigure person_figure(std::size_t number) {
    PersonFigure figure;
    if (number == 0) return figure;
    const std::array<glm::vec3, 9> shirts{{{0.55F, 0.53F, 0.48F},
                                           {0.10F, 0.16F, 0.28F},
                                           {0.30F, 0.24F, 0.14F},
                                           {0.12F, 0.20F, 0.14F},
                                           {0.50F, 0.22F, 0.05F},
                                           {0.055F, 0.060F, 0.070F},
                                           {0.42F, 0.36F, 0.10F},
                                           {0.20F, 0.27F, 0.34F},
                                           {0.26F, 0.06F, 0.11F}}};
    const std::array<glm::vec3, 5> trousers{{{0.060F, 0.075F, 0.120F},
                                             {0.23F, 0.185F, 0.120F},
                                             {0.055F, 0.055F, 0.055F},
                                             {0.13F, 0.13F, 0.095F},
                                             {0.34F, 0.30F, 0.23F}}};
    const std::array<glm::vec3, 4> skins{{{0.45F, 0.28F, 0.19F},
                                          {0.34F, 0.20F, 0.13F},
                                          {0.21F, 0.115F, 0.070F},
                                          {0.095F, 0.055F, 0.038F}}};
    const std::array<glm::vec3, 4> cloths{{{0.42F, 0.37F, 0.28F},
                                           {0.60F, 0.58F, 0.53F},
                                           {0.10F, 0.14F, 0.24F},
                                           {0.22F, 0.15F, 0.08F}}};
    const std::array<glm::vec3, 3> hairs{
        {{0.022F, 0.018F, 0.015F}, {0.070F, 0.042F, 0.024F}, {0.21F, 0.15F, 0.085F}}};
    const std::array<glm::vec3, 4> packs{{{0.060F, 0.090F, 0.055F},
                                          {0.19F, 0.045F, 0.035F},
                                          {0.050F, 0.055F, 0.065F},
                                          {0.070F, 0.115F, 0.19F}}};
    RandomStream stream(number, 0, 0, Purpose::persons);
    const auto uniform_in = [&](double low, double high) {
        return low + (high - low) * stream.uniform();
    };
    const auto one_of = [&](const auto& choices) {
        return choices.at(stream.below(static_cast<std::uint32_t>(choices.size())));
    };
    figure.height = 0.5 * (uniform_in(1.58, 1.90) + uniform_in(1.58, 1.90));
    figure.girth = uniform_in(0.90, 1.16);
    const bool walks = stream.uniform() < 0.55;
    figure.stride = walks ? uniform_in(0.13, 0.21) : uniform_in(0.0, 0.035);
    figure.leading = stream.uniform() < 0.5 ? -1.0 : 1.0;
    figure.elbows = walks ? uniform_in(0.0, 0.4) : uniform_in(0.0, 1.0);
    figure.head_turn = uniform_in(-40.0, 40.0);
    figure.pack = stream.uniform() < 0.5;
    figure.headwear = static_cast<Headwear>(stream.below(4));
    figure.trousers = one_of(trousers);
    figure.shirt = one_of(shirts);
    figure.skin = one_of(skins);
    figure.on_head = figure.headwear == Headwear::hair ? one_of(hairs) : one_of(cloths);
    figure.hair = figure.headwear == Headwear::hair ? figure.on_head : one_of(hairs);
    figure.weight = walks ? 0.0 : figure.leading * uniform_in(0.4, 1.0);
    figure.lean = walks ? uniform_in(0.02, 0.05) : uniform_in(-0.01, 0.015);
    figure.hem = stream.uniform() < 0.7 ? uniform_in(0.81, 0.86) : uniform_in(0.66, 0.78);
    figure.folds = uniform_in(0.0, 6.0);
    figure.has_long_hair = figure.headwear != Headwear::scarf && stream.uniform() < 0.35;
    figure.has_short_sleeves = stream.uniform() < 0.3;
    figure.pack_colour = one_of(packs);
    return figure;
}

double person_facing(std::size_t number) {
    constexpr double south = 180.0;
    constexpr double farthest = 120.0;
    if (number == 0) return south;
    RandomStream stream(number, 1, 0, Purpose::persons);
    return south + farthest * (2.0 * stream.uniform() - 1.0);
}

}  // namespace fumon
