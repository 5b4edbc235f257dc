#include "base/block_pool.h"

#include <gtest/gtest.h>

#include <cstdlib>

#include "base/grid.h"

namespace fumon {
namespace {

constexpr std::size_t page = std::size_t{1} << 21;

TEST(BlockPool, GivesBackBlocksOfTheSameSizeAlone) {
    BlockPool kept;
    void* block = std::aligned_alloc(page, 2 * page);
    EXPECT_EQ(kept.take(2 * page), nullptr);
    ASSERT_TRUE(kept.keep(block, 2 * page));
    EXPECT_EQ(kept.take(3 * page), nullptr);
    EXPECT_EQ(kept.take(page), nullptr);
    void* again = kept.take(2 * page);
    EXPECT_EQ(again, block);
    EXPECT_EQ(kept.take(2 * page), nullptr);
    std::free(again);
}

TEST(BlockPool, HoldsNoMoreThanItSays) {
    BlockPool kept;
    const std::size_t half = BlockPool::most / 2 / page * page;
    void* first = std::aligned_alloc(page, half);
    void* second = std::aligned_alloc(page, BlockPool::most - half + page);
    ASSERT_TRUE(kept.keep(first, half));
    EXPECT_FALSE(kept.keep(second, BlockPool::most - half + page));
    EXPECT_EQ(kept.take(BlockPool::most - half + page), nullptr);
    std::free(second);
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
