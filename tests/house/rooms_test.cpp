// The order of the house: src/CMakeLists.txt lists every room and the rooms that it may use, and no
// file includes anything of another one.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

namespace fs = std::filesystem;

namespace {

struct Room {
    std::string folder;
    std::vector<std::string> uses;
};

/// The rooms as CMake has them, the lowest first.
std::vector<Room> rooms() {
    std::ifstream file(FUMON_ROOMS);
    std::vector<Room> list;
    for (std::string line; std::getline(file, line);) {
        const std::size_t colon = line.find(':');
        if (colon == std::string::npos) continue;
        Room room{line.substr(0, colon), {}};
        std::istringstream used(line.substr(colon + 1));
        for (std::string name; used >> name;) room.uses.push_back(name);
        list.push_back(std::move(room));
    }
    return list;
}

std::vector<fs::path> sources() {
    std::vector<fs::path> files;
    for (const auto& entry : fs::recursive_directory_iterator(FUMON_SOURCES_FOLDER)) {
        const auto ending = entry.path().extension();
        if (ending == ".h" || ending == ".cpp") files.push_back(entry.path());
    }
    return files;
}

std::string room_of(const fs::path& file) {
    return fs::relative(file, FUMON_SOURCES_FOLDER).parent_path().generic_string();
}

std::vector<std::string> own_includes(const fs::path& file) {
    static const std::regex include("^#include \"([^\"]+)\"");
    std::vector<std::string> names;
    std::ifstream stream(file);
    std::smatch match;
    for (std::string line; std::getline(stream, line);) {
        if (std::regex_search(line, match, include)) names.push_back(match[1]);
    }
    return names;
}

TEST(RoomsTest, ARoomNamesOnlyRoomsThatStandBeforeIt) {
    std::vector<std::string> before;
    for (const Room& room : rooms()) {
        for (const std::string& used : room.uses) {
            EXPECT_TRUE(std::ranges::count(before, used) == 1)
                << room.folder << " names " << used << ", which does not stand before it";
        }
        before.push_back(room.folder);
    }
    EXPECT_GT(before.size(), 20U);
}

TEST(RoomsTest, FilesIncludeOnlyTheirOwnRoomAndTheRoomsItNames) {
    std::map<std::string, std::vector<std::string>> uses;
    for (const Room& room : rooms()) uses[room.folder] = room.uses;
    std::size_t arrows = 0;
    for (const fs::path& file : sources()) {
        const std::string room = room_of(file);
        if (room.empty()) continue;  // main.cpp
        ASSERT_TRUE(uses.contains(room)) << file << " lies in no room of src/CMakeLists.txt";
        for (const std::string& name : own_includes(file)) {
            const std::string used = fs::path(name).parent_path().generic_string();
            if (used == room) continue;
            ++arrows;
            EXPECT_EQ(std::ranges::count(uses[room], used), 1)
                << file << " includes " << name << ", but " << room << " does not name " << used
                << " in src/CMakeLists.txt";
        }
    }
    EXPECT_GT(arrows, 500U);
}

TEST(RoomsTest, ARoomNamesNoRoomThatItDoesNotUse) {
    std::map<std::string, std::vector<std::string>> used;
    for (const fs::path& file : sources()) {
        for (const std::string& name : own_includes(file))
            used[room_of(file)].push_back(fs::path(name).parent_path().generic_string());
    }
    for (const Room& room : rooms()) {
        for (const std::string& named : room.uses) {
            EXPECT_GT(std::ranges::count(used[room.folder], named), 0)
                << room.folder << " names " << named << " and includes nothing of it";
        }
    }
}

TEST(RoomsTest, FoldersHaveAtMost45Files) {
    std::map<std::string, int> files;
    for (const fs::path& file : sources()) ++files[room_of(file)];
    for (const auto& [room, count] : files) EXPECT_LE(count, 45) << room;
}

}  // namespace
