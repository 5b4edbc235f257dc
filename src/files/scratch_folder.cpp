#include "files/scratch_folder.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <string>
#include <system_error>

#include "base/error.h"

namespace fumon {

ScratchFolder::ScratchFolder() {
    std::error_code fault;
    const std::filesystem::path parent = std::filesystem::temp_directory_path(fault);
    std::string name = ((fault ? std::filesystem::path("/tmp") : parent) / "fumon-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) {
        throw Error(fmt::format("cannot make a temporary folder {}: {}", name,
                                std::generic_category().message(errno)));
    }
    path_ = name;
}

ScratchFolder::~ScratchFolder() {
    std::error_code fault;
    std::filesystem::remove_all(path_, fault);
}

}  // namespace fumon
