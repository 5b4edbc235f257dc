#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace fumon {

class WorkerPool;

/// What a random stream is for: part of the counter, so that no two uses share numbers.
enum class Purpose : std::uint32_t {
    initial_bed = 1,
    picks_per_row = 2,
    picks = 3,
    toppling_directions = 4,
    drop_sites = 5,
    bootstrap = 6,
    influx = 7,
    gusts = 8,
    first_plants = 9,
    plants = 10,
    plain = 11,
    footprints = 12,
    ravines = 13,
    raindrops = 14,
    persons = 15
};

/// Philox4x32-10 (Salmon, Moraes, Dror & Shaw 2011): ten rounds on a 128-bit counter under a 64-bit
/// key. Checked against its published known-answer vectors.
std::array<std::uint32_t, 4> philox4x32(std::array<std::uint32_t, 4> counter,
                                        std::array<std::uint32_t, 2> key);

/// The numbers of one (row, step, purpose) under one seed. Key = the seed; counter = (index, row,
/// step, purpose), so no result depends on the order in which threads run.
/// `step` is taken modulo 2^32.
class RandomStream {
  public:
    RandomStream(std::uint64_t seed, std::uint32_t row, std::int64_t step, Purpose purpose);

    std::uint32_t next32();
    std::uint64_t next64();
    double uniform();  ///< [0, 1), 53 bits
    std::uint32_t below(
        std::uint32_t count);  ///< uniform integer in [0, count), without modulo bias (Lemire 2019)

    /// Fills with next32(): the same words in the same order, computed many counters at a time.
    void fill(std::span<std::uint32_t> words);

  private:
    void make_words();

    std::array<std::uint32_t, 2> key_;
    std::array<std::uint32_t, 4> counter_;
    std::array<std::uint32_t, 64> words_{};  ///< the next ones
    std::size_t made_ = 0;                   ///< how many of them
    std::size_t used_ = 0;
};

/// A binomial variate: successes of `trials` at `probability`, exact in distribution; the algorithm
/// is named at its definition. Throws nothing; probability in [0, 1].
std::int64_t binomial(RandomStream& stream, std::int64_t trials, double probability);

/// How `trials` fall on `counts.size()` equally likely rows: an exact multinomial by conditional
/// binomials.
void multinomial_equal(RandomStream& stream, std::int64_t trials, std::span<std::int64_t> counts);

}  // namespace fumon
