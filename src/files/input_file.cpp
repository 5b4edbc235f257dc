#include "files/input_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <span>
#include <system_error>
#include <vector>

#include "base/error.h"

namespace fumon {

namespace {

[[noreturn]] void refuse(const std::filesystem::path& file, std::string_view reason,
                         std::string_view remedy) {
    throw InputError(fmt::format("{}: {}; {}", file.string(), reason, remedy));
}

struct Descriptor {
    int number = -1;
    explicit Descriptor(int number_) : number(number_) {}
    ~Descriptor() {
        if (number >= 0) ::close(number);
    }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
};

std::size_t size_of_regular_file(const std::filesystem::path& file, int descriptor) {
    struct stat status {};
    if (::fstat(descriptor, &status) != 0) refuse_to_read(file, errno);
    if (S_ISDIR(status.st_mode)) refuse(file, "is a folder", "name a file in it");
    if (!S_ISREG(status.st_mode)) refuse(file, "is not a regular file", "name a file on disk");
    return static_cast<std::size_t>(status.st_size);
}

/// O_NONBLOCK: a named pipe nobody writes to would otherwise block here.
int open_to_read(const std::filesystem::path& file) {
    const int descriptor = ::open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
    if (descriptor < 0) refuse_to_read(file, errno);
    return descriptor;
}

/// Fills `bytes` as far as the file goes; returns how many there were.
std::size_t read_into(std::span<char> bytes, const std::filesystem::path& file, int descriptor) {
    constexpr std::size_t most_at_once = std::size_t{1} << 30;  // bytes; Linux reads at most 2 GiB
    std::size_t filled = 0;
    while (filled < bytes.size()) {
        const ssize_t got = ::read(descriptor, bytes.data() + filled,
                                   std::min(bytes.size() - filled, most_at_once));
        if (got < 0 && errno == EINTR) continue;
        if (got < 0) refuse_to_read(file, errno);
        if (got == 0) break;
        filled += static_cast<std::size_t>(got);
    }
    return filled;
}

std::string read_bytes(const std::filesystem::path& file, int descriptor, std::size_t count) {
    std::string bytes(count, '\0');
    bytes.resize(read_into(bytes, file, descriptor));
    return bytes;
}

}  // namespace

void refuse_to_read(const std::filesystem::path& file, int reason) {
    const std::string why = fmt::format("{}: cannot be read: {}", file.string(),
                                        std::generic_category().message(reason));
    switch (reason) {
        case EIO:
        case ENOMEM:
        case EMFILE:
        case ENFILE:
        case ESTALE:
        case ETIMEDOUT:
            throw Error(why);
        default:
            throw InputError(why + "; name a file that exists and that you may read");
    }
}

std::string read_input_file(const std::filesystem::path& file) {
    const Descriptor input(open_to_read(file));
    const std::size_t size = size_of_regular_file(file, input.number);
    if (size > static_cast<std::size_t>(largest_input_file))
        refuse(file, fmt::format("has {} bytes", size),
               fmt::format("at most {} are read; cut out or coarsen the part you need",
                           largest_input_file));
    return read_bytes(file, input.number, size);
}

void stream_input_file(const std::filesystem::path& file, std::int64_t count,
                       const std::function<void(std::string_view)>& take) {
    constexpr std::int64_t block = std::int64_t{1} << 18;  // bytes
    const Descriptor input(open_to_read(file));
    size_of_regular_file(file, input.number);
    std::vector<char> bytes(
        static_cast<std::size_t>(std::min(block, std::max<std::int64_t>(count, 0))));
    for (std::int64_t left = count; left > 0;) {
        const auto wanted = static_cast<std::size_t>(std::min(block, left));
        const std::size_t got = read_into(std::span(bytes).first(wanted), file, input.number);
        take({bytes.data(), got});
        if (got < wanted) return;
        left -= static_cast<std::int64_t>(got);
    }
}

std::string start_of_input_file(const std::filesystem::path& file, std::size_t count) {
    const Descriptor input(open_to_read(file));
    const std::size_t size = size_of_regular_file(file, input.number);
    return read_bytes(file, input.number, std::min(size, count));
}

}  // namespace fumon
