#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <string>
#include <vector>

#ifdef __GLIBC__
#include <malloc.h>
#endif

#include "base/error.h"
#include "cli/command_line.h"
#include "run/terminal/crash.h"

static int report_out_of_memory() {
    std::fputs(fumon::out_of_memory.data(), stderr);
    return fumon::could_not_work;
}

/// Ends the program without what libraries do at the end of one, where memory has ended within
/// them: a driver would wait for its own locks.
static int ended_with(int status) {
    if (!fumon::memory_exhausted()) return status;
    std::fflush(nullptr);
    std::_Exit(status);
}

/// Gives large fields back to the system as they are freed. By itself the C library raises the size
/// from which it does so, and each thread's heap keeps the most that it ever held: frames of a bed
/// of 1024 x 1024 cells took 770 MB instead of 460. What pictures of 1920 x 1080 pixels and a bed's
/// measures take over and over again is kept: the system would clear it for each frame, which took
/// a fifteenth of the time.
static void give_memory_back() {
#ifdef __GLIBC__
    constexpr int large = 6 << 20;
    mallopt(M_MMAP_THRESHOLD, large);
    mallopt(M_TRIM_THRESHOLD, 64 << 20);
#endif
}

int main(int count, char** values) {
    give_memory_back();
    fumon::install_crash_reports();
    std::signal(SIGXFSZ, SIG_IGN);  // what exceeds the limit on files is a failed write (EFBIG)
    try {
        return fumon::run_command_line(std::vector<std::string>(values + 1, values + count));
    } catch (const fumon::InputError& error) {
        // A library that finds no memory may call its input wrong, as the reader of TOML does.
        if (fumon::memory_exhausted()) return ended_with(report_out_of_memory());
        std::fprintf(stderr, "%s\n", error.what());
        return error.exit_status();
    } catch (const fumon::Error& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return ended_with(error.exit_status());
    } catch (const std::bad_alloc&) {
        return ended_with(report_out_of_memory());
    } catch (const std::filesystem::filesystem_error& error) {
        std::fprintf(stderr, "%s: %s\n", error.path1().c_str(), error.code().message().c_str());
        return ended_with(fumon::could_not_work);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "fumon: unexpected: %s\n", error.what());
        return ended_with(fumon::could_not_work);
    }
}
