#include "base/worker_pool.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <exception>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace fumon {
namespace {

TEST(WorkerPool, CoversEveryIndexOnceAtAnySize) {
    for (const int threads : {1, 2, 3, 8}) {
        WorkerPool pool(threads);
        EXPECT_EQ(pool.size(), threads);
        for (const int count : {0, 1, 2, 7, 100}) {
            std::vector<std::atomic<int>> visits(static_cast<std::size_t>(count));
            std::atomic<int> calls = 0;
            pool.for_ranges(count, [&](int begin, int end) {
                ++calls;
                ASSERT_LT(begin, end);
                for (int i = begin; i < end; ++i) ++visits[static_cast<std::size_t>(i)];
            });
            for (const auto& visit : visits) EXPECT_EQ(visit, 1);
            EXPECT_LE(calls, threads);
        }
    }
}

TEST(WorkerPool, ManyRoundsInARow) {
    WorkerPool pool(3);
    std::atomic<long> sum = 0;
    for (int round = 0; round < 5000; ++round)
        pool.for_ranges(10, [&](int begin, int end) { sum += end - begin; });
    EXPECT_EQ(sum, 50000);
}

TEST(WorkerPool, RethrowsTheFirstErrorInRangeOrderAndGoesOn) {
    WorkerPool pool(4);
    for (int round = 0; round < 20; ++round) {
        std::string caught;
        try {
            pool.for_ranges(4, [](int begin, int) {
                if (begin >= 1) throw std::runtime_error(std::to_string(begin));
            });
        } catch (const std::runtime_error& error) {
            caught = error.what();
        }
        EXPECT_EQ(caught, "1");
    }
    int done = 0;
    pool.for_ranges(1, [&](int, int) { done = 1; });
    EXPECT_EQ(done, 1);
}

TEST(WorkerPool, ZeroTakesTheMachinesProcessors) {
    EXPECT_GE(WorkerPool(0).size(), 1);
}

TEST(WorkerPool, ThatCannotStartAllItsThreadsSaysSoAndEnds) {
#ifdef FUMON_SANITIZED
    GTEST_SKIP() << "sanitizers take more address space than any limit";
#endif
    const pid_t child = ::fork();
    if (child == 0) {
        ::alarm(20);  // ends it where it waits for ever
        long pages = 0;
        std::ifstream("/proc/self/statm") >> pages;
        const auto room = static_cast<rlim_t>(pages * ::sysconf(_SC_PAGESIZE)) + (rlim_t{64} << 20);
        const rlimit limit{room, room};
        ::setrlimit(RLIMIT_AS, &limit);
        try {
            const WorkerPool pool(512);
        } catch (const std::exception&) {
            ::_exit(0);
        }
        ::_exit(1);
    }
    int status = 0;
    ASSERT_EQ(::waitpid(child, &status, 0), child);
    EXPECT_TRUE(WIFEXITED(status)) << "it waits";
    EXPECT_EQ(WEXITSTATUS(status), 0) << "there was room for all";
}

}  // namespace
}  // namespace fumon
