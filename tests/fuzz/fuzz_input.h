#pragma once

#include <sys/mman.h>
#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <string_view>

#include "base/error.h"

namespace fumon::fuzz {

inline std::string_view as_text(const std::uint8_t* data, std::size_t size) {
    return {reinterpret_cast<const char*>(data), size};
}

/// Stops the fuzzer: what was read breaks a promise that the reader makes.
[[noreturn]] inline void broken_promise(std::string_view promise, std::string_view found) {
    const auto say = [](std::string_view text) {
        [[maybe_unused]] const ssize_t written = ::write(STDERR_FILENO, text.data(), text.size());
    };
    say("broken promise: ");
    say(promise);
    say("\n");
    say(found);
    say("\n");
    std::abort();
}

/// How many lines a refusal may have: a scene's has one for each fault.
enum class RefusalLines { one, many };

/// Calls read() on some input. It may refuse it by an InputError; anything else that it throws is
/// a fault. Returns whether it was taken.
template <class Read>
bool taken(const Read& read, RefusalLines lines = RefusalLines::one) {
    try {
        read();
        return true;
    } catch (const InputError& refusal) {
        if (refusal.lines().empty()) broken_promise("a refusal has a text", "");
        if (lines == RefusalLines::one && refusal.lines().size() != 1)
            broken_promise("a refusal is one line", refusal.what());
        for (const std::string& line : refusal.lines()) {
            if (line.empty()) broken_promise("no line of a refusal is empty", refusal.what());
            for (const char letter : line) {
                const auto code = static_cast<unsigned char>(letter);
                if (code < 0x20 || code == 0x7F)
                    broken_promise("a refusal is without control characters", line);
            }
        }
        return false;
    }
}

/// A file in memory, for what reads by path.
class MemoryFile {
  public:
    explicit MemoryFile(std::string_view bytes) : descriptor_(memfd_create("fuzz", 0)) {
        const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
        if (written != static_cast<ssize_t>(bytes.size())) std::abort();
    }
    ~MemoryFile() { ::close(descriptor_); }
    MemoryFile(const MemoryFile&) = delete;
    MemoryFile& operator=(const MemoryFile&) = delete;

    [[nodiscard]] std::filesystem::path path() const {
        return "/proc/self/fd/" + std::to_string(descriptor_);
    }

  private:
    int descriptor_;
};

}  // namespace fumon::fuzz
