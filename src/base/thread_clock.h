#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace fumon {

/// Gives the calling thread a name (cut at what the system keeps, 15 letters on Linux). Threads
/// that a library starts from it inherit it.
void name_this_thread(const std::string& name);

/// CPU seconds (user and system) that this process's living threads of these names have used.
double cpu_seconds_of_threads(const std::vector<std::string_view>& name_prefixes);

/// CPU seconds (user and system) of the whole process so far, ended threads included.
double cpu_seconds_of_process();

/// The largest resident memory of the process so far, in bytes.
long long peak_memory_bytes();

}  // namespace fumon
