#include <gtest/gtest.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstdlib>
#include <vector>

namespace fumon {
namespace {

#ifdef FUMON_SANITIZED
#define SKIP_WHERE_ANOTHER_ALLOCATES GTEST_SKIP() << "the sanitizer gives the memory"
#else
#define SKIP_WHERE_ANOTHER_ALLOCATES
#endif

constexpr std::size_t alignment = 64;
constexpr std::size_t large = std::size_t{5} << 20;

bool system_maps_pages_at_once() {
    void* page = mmap(nullptr, 4096, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    constexpr int populate_write = 23;
    const bool does = madvise(page, 4096, populate_write) == 0;
    munmap(page, 4096);
    return does;
}

TEST(DriverMemory, HasThePagesOfALargePieceBeforeTheyAreUsed) {
    SKIP_WHERE_ANOTHER_ALLOCATES;
    if (!system_maps_pages_at_once()) GTEST_SKIP() << "Linux before 5.14";
    void* memory = nullptr;
    ASSERT_EQ(posix_memalign(&memory, alignment, large), 0);
    EXPECT_EQ(reinterpret_cast<std::uintptr_t>(memory) % alignment, 0U);
    const std::uintptr_t first = (reinterpret_cast<std::uintptr_t>(memory) + 4095) / 4096 * 4096;
    const std::size_t pages = large / 4096 - 1;
    std::vector<unsigned char> there(pages);
    ASSERT_EQ(mincore(reinterpret_cast<void*>(first), pages * 4096, there.data()), 0);
    EXPECT_TRUE(std::ranges::all_of(there, [](unsigned char page) { return (page & 1U) != 0; }));
    std::free(memory);
}

TEST(DriverMemory, IsRefusedAsByTheCLibrary) {
    SKIP_WHERE_ANOTHER_ALLOCATES;
    void* memory = nullptr;
    EXPECT_EQ(posix_memalign(&memory, 48, 100), EINVAL);
    EXPECT_EQ(posix_memalign(&memory, 4, 100), EINVAL);
    errno = 7;
    EXPECT_EQ(posix_memalign(&memory, alignment, SIZE_MAX / 2), ENOMEM);
    EXPECT_EQ(errno, 7);
    EXPECT_EQ(memory, nullptr);
    ASSERT_EQ(posix_memalign(&memory, alignment, 100), 0);
    std::free(memory);
}

}  // namespace
}  // namespace fumon
