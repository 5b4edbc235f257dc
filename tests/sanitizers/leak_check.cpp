// Part of every program under AddressSanitizer. At a program's end the leak checker stops all its
// threads; beside those of an OpenGL driver, which EGL keeps to the very end, it crashes now and
// then. So a program that ends with more threads than one is not checked for leaks; all else of
// AddressSanitizer stays.

#include <filesystem>
#include <iterator>
#include <system_error>

extern "C" int __lsan_is_turned_off() {
    std::error_code none_to_see;
    const std::filesystem::directory_iterator threads("/proc/self/task", none_to_see);
    return std::distance(threads, {}) > 1 ? 1 : 0;
}
