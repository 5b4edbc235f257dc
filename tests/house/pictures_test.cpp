// What the pictures of the source tree weigh.

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>

namespace fs = std::filesystem;

namespace {

constexpr std::uintmax_t largest_picture = 400'000;         // bytes
constexpr std::uintmax_t largest_of_pictures = 15'000'000;  // bytes, all together

bool is_a_picture(const fs::path& file) {
    const std::string ending = file.extension().string();
    return ending == ".png" || ending == ".webp" || ending == ".jpg" || ending == ".gif";
}

TEST(Pictures, AreLight) {
    const fs::path tree = fs::path(FUMON_SOURCES_FOLDER).parent_path();
    std::uintmax_t all = 0;
    std::size_t number = 0;
    for (const char* folder : std::array{"assets", "scenes", "tests"}) {
        for (const fs::directory_entry& entry : fs::recursive_directory_iterator(tree / folder)) {
            if (!entry.is_regular_file() || !is_a_picture(entry.path())) continue;
            const std::uintmax_t size = entry.file_size();
            EXPECT_LE(size, largest_picture)
                << entry.path() << ": draw it smaller, or save it as WebP";
            all += size;
            ++number;
        }
    }
    EXPECT_GT(number, 50U);
    EXPECT_LE(all, largest_of_pictures);
}

}  // namespace
