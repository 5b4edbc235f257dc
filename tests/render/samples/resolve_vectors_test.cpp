#include "render/samples/resolve_vectors.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "vectors/target.h"

namespace fumon {
namespace {

std::uint32_t random_number(std::uint32_t& state) {
    state = state * 1664525U + 1013904223U;
    return state >> 8U;
}

/// Nothing or a colour, a third of them dark.
std::uint32_t random_sample(std::uint32_t& state) {
    if (random_number(state) % 3 == 0) return 0;
    const std::uint32_t mask = random_number(state) % 3 == 0 ? 0x030303U : 0xFFFFFFU;
    return 0xFF000000U | (random_number(state) & mask);
}

/// The nearest whole number to the root of `sum` over `count`, halves upward.
int root_of_mean(std::uint32_t sum, std::uint32_t count) {
    int root = 0;
    while (static_cast<std::uint32_t>((2 * root + 1) * (2 * root + 1)) * count <= 4 * sum) ++root;
    return root;
}

TEST(RowResolver, AveragesSquaresOverWhatIsBehindOnEveryTarget) {
    for (const std::string& target : vectors::targets()) {
        vectors::use_target(target);
        for (const int factor : {1, 2, 4}) {
            for (const int width : {1, 16, 37, 131}) {
                std::uint32_t state = 7;
                const int samples = factor * width;
                RowResolver row(width, factor);
                ColourPlanes behind(width);
                for (int again = 0; again < 2; ++again) {
                    for (auto* plane : {&behind.red, &behind.green, &behind.blue})
                        for (std::uint8_t& value : *plane)
                            value = static_cast<std::uint8_t>(random_number(state));
                    std::vector<std::uint32_t> all;
                    for (int j = 0; j < factor; ++j) {
                        std::vector<std::uint32_t> line;
                        for (int i = 0; i < samples + RowResolver::samples_read_beyond; ++i)
                            line.push_back(random_sample(state));
                        row.add(line.data());
                        all.insert(all.end(), line.begin(), line.begin() + samples);
                    }
                    std::vector<std::uint8_t> rgb(3 * static_cast<std::size_t>(width) + 1, 77);
                    row.finish(behind, rgb.data());
                    EXPECT_EQ(rgb.back(), 77) << "written past the end";
                    for (int x = 0; x < width; ++x) {
                        const auto at = static_cast<std::size_t>(x);
                        const std::uint32_t back[3] = {behind.red[at], behind.green[at],
                                                       behind.blue[at]};
                        for (unsigned channel = 0; channel < 3; ++channel) {
                            std::uint32_t sum = 0;
                            for (int j = 0; j < factor; ++j) {
                                for (int i = 0; i < factor; ++i) {
                                    const std::uint32_t sample =
                                        all[static_cast<std::size_t>(j * samples + x * factor + i)];
                                    const std::uint32_t value =
                                        sample >> 24U != 0 ? (sample >> (8U * channel)) & 255U
                                                           : back[channel];
                                    sum += value * value;
                                }
                            }
                            EXPECT_EQ(
                                int{rgb[3 * at + channel]},
                                root_of_mean(sum, static_cast<std::uint32_t>(factor * factor)))
                                << target << ", factor " << factor << ", pixel " << x;
                        }
                    }
                }
            }
        }
    }
    vectors::use_target(vectors::targets().front());
}

}  // namespace
}  // namespace fumon
