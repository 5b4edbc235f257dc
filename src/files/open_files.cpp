#include "files/open_files.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <system_error>

#include "base/error.h"

namespace fumon {

int shortage_of_open_files() {
    std::array<int, 2> tried{-1, -1};  // a library may need two at a time
    int shortage = 0;
    for (int& descriptor : tried) {
        descriptor = ::open("/", O_RDONLY | O_DIRECTORY | O_CLOEXEC);
        if (descriptor < 0 && (errno == EMFILE || errno == ENFILE)) shortage = errno;
    }
    for (const int descriptor : tried) {
        if (descriptor >= 0) ::close(descriptor);
    }
    return shortage;
}

void refuse_shortage_of_open_files(const std::filesystem::path& file) {
    const int shortage = shortage_of_open_files();
    if (shortage == 0) return;
    throw Error(fmt::format("{}: cannot be read: {}", file.string(),
                            std::generic_category().message(shortage)));
}

}  // namespace fumon
