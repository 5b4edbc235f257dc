#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

// What Linux and macOS tell of a running program in ways of their own. All such ways are in
// platform.cpp.

namespace fumon::platform {

/// The file of the program that runs; empty where it is not known.
std::filesystem::path program_file();

/// The file of the library or program that holds a function or an object; empty where it is not
/// known.
std::filesystem::path file_with(const void* address);

/// How many letters of a thread's name the system keeps.
std::size_t longest_thread_name();

/// Names the calling thread, by at most so many letters.
void name_this_thread(const std::string& name);

/// CPU seconds (user and system) of this process's living threads whose names begin so.
double cpu_seconds_of_threads(const std::vector<std::string_view>& name_prefixes);

/// What getrusage() counts the largest resident memory in, bytes.
long long unit_of_peak_memory();

/// Whether the system refuses memory that it does not have, rather than a process's limit. Safe
/// before main().
bool counts_memory();

}  // namespace fumon::platform
