#include "base/block_pool.h"

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <cstdlib>

#include "base/grid.h"

namespace fumon {
namespace {

constexpr std::size_t page = std::size_t{1} << 21;

/// A block that is in use.
void* taken(BlockPool& pool, std::size_t bytes) {
    void* kept = pool.take(bytes);
    return kept != nullptr ? kept : std::aligned_alloc(page, bytes);
}

TEST(BlockPool, GivesBackBlocksOfTheSameSizeAlone) {
    BlockPool pool;
    void* block = taken(pool, 2 * page);
    pool.give_back(block, 2 * page);
    EXPECT_EQ(pool.take(3 * page), nullptr);
    EXPECT_EQ(pool.take(page), nullptr);
    EXPECT_EQ(pool.take(2 * page), block);
    EXPECT_EQ(pool.take(2 * page), nullptr);
    pool.give_back(block, 2 * page);
    EXPECT_EQ(pool.held(), 2 * page);
}

TEST(BlockPool, HoldsTheNewestThatItHasRoomFor) {
    BlockPool pool;
    const std::size_t half = BlockPool::always / 2 / page * page;
    const std::size_t more = BlockPool::always - half + page;
    void* first = taken(pool, half);
    void* second = taken(pool, more);
    pool.give_back(first, half);
    pool.give_back(second, more);
    EXPECT_EQ(pool.held(), more);
    void* large = taken(pool, BlockPool::always + page);
    pool.give_back(large, BlockPool::always + page);
    EXPECT_EQ(pool.held(), more) << "nothing goes for what is too large";
}

TEST(BlockPool, HoldsHalfOfWhatIsInUse) {
    BlockPool pool;
    constexpr std::size_t field = 8 * page;
    std::array<void*, 12> model{};
    for (void*& one : model) one = taken(pool, field);
    for (int snapshot = 0; snapshot < 3; ++snapshot) {
        std::array<void*, 4> fields{};
        for (void*& one : fields) one = taken(pool, field);
        for (void* one : fields) pool.give_back(one, field);
        EXPECT_EQ(pool.held(), 4 * field);
    }
    for (void* one : model) pool.give_back(one, field);
    EXPECT_LE(pool.held(), BlockPool::always) << "what a run took goes back";
}

TEST(BlockPool, HoldsAllThatARepetitionHadInUse) {
    BlockPool pool;
    constexpr std::size_t field = 8 * page;
    void* before = taken(pool, 20 * field);
    pool.give_back(before, 20 * field);
    {
        const BlockPool::Repetition frames(pool);
        for (int frame = 0; frame < 3; ++frame) {
            std::array<void*, 12> fields{};
            for (void*& one : fields) one = taken(pool, field);
            for (void* one : fields) pool.give_back(one, field);
            EXPECT_EQ(pool.held(), 12 * field) << "frame " << frame;
        }
    }
    EXPECT_LE(pool.held(), BlockPool::always) << "no frame comes any more";
}

TEST(BlockPool, MakesRoomForOtherSizes) {
    BlockPool pool;
    constexpr std::size_t field = 8 * page;
    std::array<void*, 20> fields{};
    for (void*& one : fields) one = taken(pool, field);
    for (std::size_t k = 0; k < 6; ++k) pool.give_back(fields[k], field);
    EXPECT_EQ(pool.held(), 6 * field);
    void* other = taken(pool, 7 * field);
    EXPECT_LE(pool.held(), BlockPool::always) << "beyond the most that was in use";
    pool.give_back(other, 7 * field);
    for (std::size_t k = 6; k < fields.size(); ++k) pool.give_back(fields[k], field);
}

TEST(BlockPool, AFieldInAnUsedBlockIsNewAllTheSame) {
    constexpr int side = 1024;
    const float* before = nullptr;
    {
        const Field<float> field(side, side, 3.0F);
        before = field.data();
    }
    const Field<float> field(side, side);
    EXPECT_EQ(field.data(), before);
    for (const float value : field.values()) ASSERT_EQ(value, 0.0F);
}

}  // namespace
}  // namespace fumon
