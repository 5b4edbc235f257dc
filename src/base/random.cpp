#include "base/random.h"

#if defined(__x86_64__)
#include <immintrin.h>
#endif

#include <algorithm>
#include <cmath>
#include <tuple>

#include "base/cancellation.h"
#include "base/elementary.h"

namespace fumon {

namespace {

// Salmon, Moraes, Dror & Shaw (2011), table 2: the multipliers and the Weyl increments of the key.
constexpr std::uint32_t multiplier_0 = 0xD2511F53;
constexpr std::uint32_t multiplier_1 = 0xCD9E8D57;
constexpr std::uint32_t weyl_0 = 0x9E3779B9;
constexpr std::uint32_t weyl_1 = 0xBB67AE85;
constexpr int rounds = 10;

struct Block {
    std::uint32_t w0, w1, w2, w3;
};

inline Block philox(Block c, std::uint32_t k0, std::uint32_t k1) {
    for (int round = 0; round < rounds; ++round) {
        const std::uint64_t product_0 = static_cast<std::uint64_t>(multiplier_0) * c.w0;
        const std::uint64_t product_1 = static_cast<std::uint64_t>(multiplier_1) * c.w2;
        c = {static_cast<std::uint32_t>(product_1 >> 32) ^ c.w1 ^ k0,
             static_cast<std::uint32_t>(product_1),
             static_cast<std::uint32_t>(product_0 >> 32) ^ c.w3 ^ k1,
             static_cast<std::uint32_t>(product_0)};
        k0 += weyl_0;
        k1 += weyl_1;
    }
    return c;
}

constexpr std::size_t lanes = 16;  // blocks made at a time

using Counter = std::array<std::uint32_t, 4>;
using PhiloxKey = std::array<std::uint32_t, 2>;

/// `lanes` blocks for counters index, index + 1, …, written one after the other.
void philox_lanes_plain(Counter counter, PhiloxKey key, std::uint32_t* words) {
    for (std::size_t lane = 0; lane < lanes; ++lane) {
        const Block block = philox(
            {counter[0] + static_cast<std::uint32_t>(lane), counter[1], counter[2], counter[3]},
            key[0], key[1]);
        words[4 * lane] = block.w0;
        words[4 * lane + 1] = block.w1;
        words[4 * lane + 2] = block.w2;
        words[4 * lane + 3] = block.w3;
    }
}

#if defined(__x86_64__)

/// The same words, four blocks side by side: compilers do not find the 32 × 32 → 64 bit multiply by
/// themselves.
__attribute__((target("avx2"))) void philox_lanes_avx2(Counter counter, PhiloxKey key,
                                                       std::uint32_t* words) {
    constexpr std::size_t width = 4;
    constexpr std::size_t groups = lanes / width;
    const __m256i factor_0 = _mm256_set1_epi64x(multiplier_0);
    const __m256i factor_1 = _mm256_set1_epi64x(multiplier_1);
    __m256i w0[groups];
    __m256i w1[groups];
    __m256i w2[groups];
    __m256i w3[groups];
    for (std::size_t group = 0; group < groups; ++group) {
        const std::uint32_t first = counter[0] + static_cast<std::uint32_t>(width * group);
        w0[group] = _mm256_set_epi64x(first + 3U, first + 2U, first + 1U, first);
        w1[group] = _mm256_set1_epi64x(counter[1]);
        w2[group] = _mm256_set1_epi64x(counter[2]);
        w3[group] = _mm256_set1_epi64x(counter[3]);
    }
    for (int round = 0; round < rounds; ++round) {
        const __m256i k0 = _mm256_set1_epi64x(key[0]);
        const __m256i k1 = _mm256_set1_epi64x(key[1]);
        for (std::size_t group = 0; group < groups; ++group) {
            const __m256i product_0 = _mm256_mul_epu32(w0[group], factor_0);
            const __m256i product_1 = _mm256_mul_epu32(w2[group], factor_1);
            w0[group] =
                _mm256_xor_si256(_mm256_xor_si256(_mm256_srli_epi64(product_1, 32), w1[group]), k0);
            w2[group] =
                _mm256_xor_si256(_mm256_xor_si256(_mm256_srli_epi64(product_0, 32), w3[group]), k1);
            w1[group] = product_1;  // the upper halves of lanes are of no account until the end
            w3[group] = product_0;
        }
        key[0] += weyl_0;
        key[1] += weyl_1;
    }
    for (std::size_t group = 0; group < groups; ++group) {
        // (w0, w1) and (w2, w3) of each block in one 64-bit lane, then the two halves of each block
        // side by side
        constexpr int odd_words = 0xAA;
        const __m256i first =
            _mm256_blend_epi32(w0[group], _mm256_slli_epi64(w1[group], 32), odd_words);
        const __m256i second =
            _mm256_blend_epi32(w2[group], _mm256_slli_epi64(w3[group], 32), odd_words);
        const __m256i even = _mm256_unpacklo_epi64(first, second);  // blocks 0 and 2
        const __m256i odd = _mm256_unpackhi_epi64(first, second);   // blocks 1 and 3
        auto* out = reinterpret_cast<__m256i*>(words + 4 * width * group);
        _mm256_storeu_si256(out, _mm256_permute2x128_si256(even, odd, 0x20));
        _mm256_storeu_si256(out + 1, _mm256_permute2x128_si256(even, odd, 0x31));
    }
}

#endif

/// As many times `lanes` blocks as asked for.
void philox_chunks(Counter counter, PhiloxKey key, std::uint32_t* words, std::size_t chunks) {
#if defined(__x86_64__)
    static const bool has_avx2 = __builtin_cpu_supports("avx2") != 0;
    const auto make = has_avx2 ? philox_lanes_avx2 : philox_lanes_plain;
#else
    const auto make = philox_lanes_plain;
#endif
    const std::uint32_t first = counter[0];
    for (std::size_t chunk = 0; chunk < chunks; ++chunk) {
        make(
            {first + static_cast<std::uint32_t>(lanes * chunk), counter[1], counter[2], counter[3]},
            key, words + 4 * lanes * chunk);
    }
}

/// Binomial by inversion: the geometric gaps between successes are added up (Devroye 1986, section
/// X.4.3, "second waiting time method"). Costs about trials · probability draws.
std::int64_t binomial_by_gaps(RandomStream& stream, std::int64_t trials, double probability) {
    const double log_failure = elementary::log(1.0 - probability);
    std::int64_t successes = 0;
    double position = 0.0;
    for (;;) {
        const double u = 1.0 - stream.uniform();  // (0, 1]
        position += std::floor(elementary::log(u) / log_failure) + 1.0;
        if (position > static_cast<double>(trials)) return successes;
        ++successes;
    }
}

/// log k! − (k + ½) log(k + 1) + (k + 1) − ½ log 2π: what Stirling's formula leaves, for BTRS.
double stirling_rest(double k) {
    static constexpr std::array<double, 10> table{
        0.08106146679532726,  0.04134069595540929, 0.02767792568499834, 0.02079067210376509,
        0.01664469118982119,  0.01387612882307075, 0.01189670994589177, 0.01041126526197209,
        0.009255462182712733, 0.008330563433362871};
    if (k < static_cast<double>(table.size())) return table[static_cast<std::size_t>(k)];
    const double inverse = 1.0 / (k + 1.0);
    const double square = inverse * inverse;
    return (1.0 / 12.0 - (1.0 / 360.0 - square / 1260.0) * square) * inverse;
}

/// Binomial by transformed rejection with squeeze, algorithm BTRS (Hörmann 1993), for
/// trials · probability ≥ 10 and probability ≤ ½.
std::int64_t binomial_by_rejection(RandomStream& stream, std::int64_t trials, double probability) {
    const auto n = static_cast<double>(trials);
    const double deviation = std::sqrt(n * probability * (1.0 - probability));
    const double b = 1.15 + 2.53 * deviation;
    const double a = -0.0873 + 0.0248 * b + 0.01 * probability;
    const double c = n * probability + 0.5;
    const double accepted_at_once = 0.92 - 4.2 / b;
    const double alpha = (2.83 + 5.1 / b) * deviation;
    const double odds = probability / (1.0 - probability);
    const double mode = std::floor((n + 1.0) * probability);
    for (;;) {
        const double u = stream.uniform() - 0.5;
        double v = 1.0 - stream.uniform();  // (0, 1]
        const double us = 0.5 - std::fabs(u);
        const double k = std::floor((2.0 * a / us + b) * u + c);
        if (us >= 0.07 && v <= accepted_at_once) return static_cast<std::int64_t>(k);
        if (!(k >= 0.0) || k > n) continue;
        v = elementary::log(v * alpha / (a / (us * us) + b));
        const double bound =
            (mode + 0.5) * elementary::log((mode + 1.0) / (odds * (n - mode + 1.0))) +
            (n + 1.0) * elementary::log((n - mode + 1.0) / (n - k + 1.0)) +
            (k + 0.5) * elementary::log(odds * (n - k + 1.0) / (k + 1.0)) + stirling_rest(mode) +
            stirling_rest(n - mode) - stirling_rest(k) - stirling_rest(n - k);
        if (v <= bound) return static_cast<std::int64_t>(k);
    }
}

}  // namespace

std::array<std::uint32_t, 4> philox4x32(std::array<std::uint32_t, 4> counter,
                                        std::array<std::uint32_t, 2> key) {
    const Block block = philox({counter[0], counter[1], counter[2], counter[3]}, key[0], key[1]);
    return {block.w0, block.w1, block.w2, block.w3};
}

RandomStream::RandomStream(std::uint64_t seed, std::uint32_t row, std::int64_t step,
                           Purpose purpose)
    : key_{static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32)},
      counter_{0, row, static_cast<std::uint32_t>(step), static_cast<std::uint32_t>(purpose)} {}

/// The first blocks one by one, since many streams end with them, then many at a time.
void RandomStream::make_words() {
    constexpr std::uint32_t one_by_one = 4;
    static_assert(std::tuple_size_v<decltype(words_)> == 4 * lanes);
    used_ = 0;
    if (counter_[0] < one_by_one) {
        const auto block = philox4x32(counter_, key_);
        std::ranges::copy(block, words_.begin());
        ++counter_[0];
        made_ = block.size();
    } else {
        philox_chunks(counter_, key_, words_.data(), 1);
        counter_[0] += static_cast<std::uint32_t>(lanes);
        made_ = words_.size();
    }
}

std::uint32_t RandomStream::next32() {
    if (used_ == made_) make_words();
    return words_[used_++];
}

std::uint64_t RandomStream::next64() {
    const std::uint64_t low = next32();
    return low | (static_cast<std::uint64_t>(next32()) << 32);
}

double RandomStream::uniform() {
    constexpr int dropped_bits = 11;
    return static_cast<double>(next64() >> dropped_bits) * 0x1p-53;
}

std::uint32_t RandomStream::below(std::uint32_t count) {
    std::uint64_t product = static_cast<std::uint64_t>(next32()) * count;
    if (static_cast<std::uint32_t>(product) < count) {
        const std::uint32_t biased = (0U - count) % count;
        while (static_cast<std::uint32_t>(product) < biased)
            product = static_cast<std::uint64_t>(next32()) * count;
    }
    return static_cast<std::uint32_t>(product >> 32);
}

void RandomStream::fill(std::span<std::uint32_t> words) {
    constexpr std::size_t chunk = 4 * lanes;
    std::size_t done = 0;
    while (done < words.size() && used_ != made_) words[done++] = next32();
    const std::size_t whole = (words.size() - done) / chunk;
    philox_chunks(counter_, key_, words.data() + done, whole);
    counter_[0] += static_cast<std::uint32_t>(lanes * whole);
    done += chunk * whole;
    if (done == words.size()) return;
    philox_chunks(counter_, key_, words_.data(), 1);
    counter_[0] += static_cast<std::uint32_t>(lanes);
    made_ = words_.size();
    used_ = words.size() - done;
    std::copy_n(words_.begin(), used_, words.begin() + static_cast<std::ptrdiff_t>(done));
}

std::int64_t binomial(RandomStream& stream, std::int64_t trials, double probability) {
    if (trials <= 0 || probability <= 0.0) return 0;
    if (probability >= 1.0) return trials;
    if (probability > 0.5) return trials - binomial(stream, trials, 1.0 - probability);
    constexpr double few = 10.0;
    return static_cast<double>(trials) * probability < few
               ? binomial_by_gaps(stream, trials, probability)
               : binomial_by_rejection(stream, trials, probability);
}

void multinomial_equal(RandomStream& stream, std::int64_t trials, std::span<std::int64_t> counts) {
    std::int64_t left = trials;
    for (std::size_t row = 0; row < counts.size(); ++row) {
        throw_if_cancelled();
        const std::size_t rows_left = counts.size() - row;
        counts[row] =
            rows_left == 1 ? left : binomial(stream, left, 1.0 / static_cast<double>(rows_left));
        left -= counts[row];
    }
}

}  // namespace fumon
