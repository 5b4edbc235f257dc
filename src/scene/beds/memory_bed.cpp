#include "scene/beds/memory_bed.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <map>
#include <mutex>
#include <utility>

#include "base/error.h"
#include "base/sha256.h"
#include "files/hash.h"
#include "files/terrain/ground_lengths.h"

namespace fumon {

namespace {

constexpr std::string_view prefix = "memory:";
constexpr std::size_t hash_length = 64;

/// The beds that are held, by their names.
struct MemoryBeds {
    std::mutex mutex;
    std::map<std::string, std::weak_ptr<const MemoryBed>, std::less<>> beds;
};

MemoryBeds& memory_beds() {
    static MemoryBeds one;
    return one;
}

void add(Sha256Stream& stream, double value) {
    stream.add_little_endian(std::bit_cast<std::uint64_t>(value));
}

std::string hash_of(const Terrain& terrain, std::optional<bool> unit_counts) {
    Sha256Stream stream;
    stream.add_little_endian(static_cast<std::uint8_t>(!unit_counts ? 0 : *unit_counts ? 1 : 2));
    stream.add_little_endian(static_cast<std::uint64_t>(terrain.heights.nx()));
    stream.add_little_endian(static_cast<std::uint64_t>(terrain.heights.ny()));
    add(stream, terrain.dx);
    add(stream, terrain.dy);
    stream.add_little_endian(static_cast<std::uint8_t>(terrain.place ? 1 : 0));
    if (const auto& place = terrain.place) {
        for (const double value : {place->west, place->south, place->dx, place->dy})
            add(stream, value);
        stream.add_little_endian(static_cast<std::uint8_t>(place->degrees ? 1 : 0));
        stream.add_little_endian(static_cast<std::uint64_t>(place->crs.size()));
        stream.add(place->crs.data(), place->crs.size());
    }
    for (const double height : terrain.heights.values()) add(stream, height);
    stream.add(terrain.nodata.values().data(), terrain.nodata.size());
    return hex(stream.finish());
}

}  // namespace

MemoryBed::MemoryBed(Terrain terrain, std::string hash)
    : terrain_(std::move(terrain)), hash_(std::move(hash)) {}

std::shared_ptr<const MemoryBed> MemoryBed::hold(Terrain terrain, std::optional<bool> unit_counts) {
    std::string hash = hash_of(terrain, unit_counts);
    if (unit_counts) make_true_lengths(terrain, *unit_counts, memory_bed_title);
    std::shared_ptr<const MemoryBed> bed(new MemoryBed(std::move(terrain), std::move(hash)));
    const std::lock_guard lock(memory_beds().mutex);
    auto& beds = memory_beds().beds;
    std::erase_if(beds, [](const auto& entry) { return entry.second.expired(); });
    std::weak_ptr<const MemoryBed>& place = beds[bed->name()];
    if (auto same = place.lock()) return same;
    place = bed;
    return bed;
}

std::string MemoryBed::name() const {
    return std::string(prefix) + hash_;
}

bool is_memory_bed(std::string_view name) {
    return name.starts_with(prefix) && name.size() == prefix.size() + hash_length &&
           std::ranges::all_of(name.substr(prefix.size()), [](char c) {
               return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f');
           });
}

std::shared_ptr<const MemoryBed> find_memory_bed(const std::string& name) {
    {
        const std::lock_guard lock(memory_beds().mutex);
        const auto entry = memory_beds().beds.find(name);
        if (entry != memory_beds().beds.end()) {
            if (auto bed = entry->second.lock()) return bed;
        }
    }
    throw InputError(missing_memory_bed(name));
}

std::string missing_memory_bed(std::string_view name) {
    return fmt::format(
        "the bed was an array in the memory of a program (SHA-256 {}…), which no file holds; give "
        "the same heights again (in Python bed=array), or write them to a file",
        name.substr(prefix.size(), 12));
}

}  // namespace fumon
