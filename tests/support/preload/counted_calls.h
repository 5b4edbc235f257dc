#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <mutex>
#include <string>

#include "support/preload/call_log.h"

/// Counting of the operations on what lies in one folder, which of them fails, and their log; told
/// by the environment, see failing_calls.cpp.
namespace fumon::test {

struct OpenFile {
    std::string path;
    std::int64_t number = 0;
};

struct CallState {
    std::recursive_mutex mutex;
    std::string folder;
    CallReport* report = nullptr;
    CallReport none;
    std::int64_t fail = 0;
    int error = 0;  ///< with which it fails
    bool lasting = false;
    int log = -1;
    std::map<int, OpenFile> files;
    std::int64_t opened = 0;
};

/// Not a static object: operations may come before and after those live.
CallState& state();

/// An absolute path without "." and "..".
std::string absolute(const char* path);

/// Whether it is the folder or lies in it.
bool is_inside(const std::string& path);

/// The file of a descriptor, or null where it is none of the folder's.
OpenFile* open_file(int descriptor);

/// Counts an operation on a path of the folder; true, with errno set, where it is to fail.
bool fails(Call call, const std::string& path);

/// Adds an operation that was done to the log, if there is one.
void log(Call call, const std::string& path, const std::string& other, std::int64_t file,
         std::int64_t offset, const void* data, std::size_t count);

}  // namespace fumon::test
