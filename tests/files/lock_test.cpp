#include <gtest/gtest.h>
#include <sys/file.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <optional>
#include <thread>

#include "base/error.h"
#include "files/file_lock.h"
#include "files/folder_lock.h"
#include "support/temporary_folder.h"

namespace {

int lock_fault = 0;  // an errno value that flock fails with; 0: none

}  // namespace

/// Takes the place of the C library's.
extern "C" int flock(int descriptor, int operation) noexcept {
    if (lock_fault == 0) return static_cast<int>(::syscall(SYS_flock, descriptor, operation));
    errno = lock_fault;
    return -1;
}

namespace fumon {
namespace {

using test::message_of;
using test::TemporaryFolder;

TEST(Lock, OneHolderAtATime) {
    const TemporaryFolder folder;
    std::optional<FolderLock> lock(folder.path());
    EXPECT_EQ(message_of<InputError>([&] { FolderLock(folder.path()); }),
              "another fumon is working in " + folder.path().string() +
                  "; wait for it or name another folder");
    lock.reset();
    EXPECT_EQ(message_of<InputError>([&] { FolderLock(folder.path()); }), "");
    const FileLock one(folder / "a.lock");
    const FileLock other(folder / "a.lock");
    EXPECT_TRUE(one.held());
    EXPECT_FALSE(other.held());
}

TEST(Lock, AFolderIsWaitedForAsLongAsIsAsked) {
    const TemporaryFolder folder;
    std::optional<FolderLock> lock(folder.path());
    std::thread holder([&] {
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
        lock.reset();
    });
    EXPECT_EQ(message_of<InputError>([&] { FolderLock(folder.path(), std::chrono::seconds(60)); }),
              "");
    holder.join();
}

TEST(Lock, WhereThereAreNoneItIsSaidOnceAndWorkGoesOn) {
    const TemporaryFolder folder;
    testing::internal::CaptureStderr();
    lock_fault = ENOLCK;
    {
        const FolderLock lock(folder.path());
        const FolderLock second(folder.path());
        const FileLock file(folder / "a.lock");
        EXPECT_TRUE(file.held());
    }
    lock_fault = 0;
    EXPECT_EQ(testing::internal::GetCapturedStderr(),
              folder.path().string() +
                  " cannot be locked (No locks available): make sure that no other fumon works "
                  "there\n");
}

}  // namespace
}  // namespace fumon
