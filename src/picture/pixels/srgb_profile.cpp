// ICC.1:2001-04: a header of 128 bytes, a table of tags (signature, offset, size), and their data,
// each from a multiple of four bytes on. All numbers have their highest byte first.

#include "picture/pixels/srgb_profile.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "base/elementary_power.h"

namespace fumon {

namespace {

void put(std::string& bytes, std::uint32_t number, unsigned count) {
    for (unsigned shift = 8 * count; shift > 0; shift -= 8)
        bytes += static_cast<char>(number >> (shift - 8) & 0xFFU);
}

/// Numbers of 16 bits before the point and 16 behind it.
std::string xyz(std::uint32_t x, std::uint32_t y, std::uint32_t z) {
    std::string bytes("XYZ \0\0\0\0", 8);
    for (const std::uint32_t number : {x, y, z}) put(bytes, number, 4);
    return bytes;
}

std::string description(std::string_view text) {
    std::string bytes("desc\0\0\0\0", 8);
    put(bytes, static_cast<std::uint32_t>(text.size() + 1), 4);
    bytes += text;
    constexpr std::size_t other_scripts = 4 + 4 + 2 + 1 + 67;  // none
    return bytes + std::string(1 + other_scripts, '\0');
}

std::string curve() {
    constexpr std::uint32_t steps = 1024;
    std::string bytes("curv\0\0\0\0", 8);
    put(bytes, steps, 4);
    for (std::uint32_t i = 0; i < steps; ++i) {
        const double shown = i / (steps - 1.0);
        const double light =
            shown <= 0.04045 ? shown / 12.92 : elementary::pow((shown + 0.055) / 1.055, 2.4);
        put(bytes, static_cast<std::uint32_t>(light * 65535.0 + 0.5), 2);
    }
    return bytes;
}

struct Tag {
    std::string_view name;
    std::size_t data;  ///< number of its data, which tags may share
};

}  // namespace

std::string srgb_profile() {
    const std::vector<std::string> data{
        description(srgb_name),
        std::string("text\0\0\0\0", 8) + "No copyright, use freely" + '\0',
        xyz(0xF6D6, 0x10000, 0xD32D),  // D50
        xyz(0x6FA0, 0x38F5, 0x0390),   // red, green and blue, which add up to it
        xyz(0x6297, 0xB787, 0x18D9),
        xyz(0x249F, 0x0F84, 0xB6C4),
        curve()};
    constexpr std::array<Tag, 9> tags{{{"desc", 0},
                                       {"cprt", 1},
                                       {"wtpt", 2},
                                       {"rXYZ", 3},
                                       {"gXYZ", 4},
                                       {"bXYZ", 5},
                                       {"rTRC", 6},
                                       {"gTRC", 6},
                                       {"bTRC", 6}}};
    constexpr std::size_t head = 128;
    std::size_t end = head + 4 + 12 * tags.size();
    std::vector<std::size_t> offsets;
    std::string body;
    for (const std::string& one : data) {
        offsets.push_back(end + body.size());
        body += one;
        body.append((4 - body.size() % 4) % 4, '\0');
    }
    end += body.size();
    std::string profile;
    put(profile, static_cast<std::uint32_t>(end), 4);
    put(profile, 0, 4);           // no preferred program
    put(profile, 0x02100000, 4);  // version
    profile += "mntrRGB XYZ ";
    for (const std::uint32_t part : {2000U, 1U, 1U, 0U, 0U, 0U}) put(profile, part, 2);
    profile += "acsp";
    profile.append(28, '\0');  // of no platform or maker; perceptual
    for (const std::uint32_t part : {0xF6D6U, 0x10000U, 0xD32DU}) put(profile, part, 4);
    profile.append(head - profile.size(), '\0');
    put(profile, static_cast<std::uint32_t>(tags.size()), 4);
    for (const Tag& tag : tags) {
        profile += tag.name;
        put(profile, static_cast<std::uint32_t>(offsets[tag.data]), 4);
        put(profile, static_cast<std::uint32_t>(data[tag.data].size()), 4);
    }
    return profile + body;
}

}  // namespace fumon
