#include "files/active_library.h"

namespace fumon {

namespace {

thread_local const char* active_line = nullptr;

}  // namespace

ActiveLibrary::ActiveLibrary(const char* line) {
    active_line = line;
}

ActiveLibrary::~ActiveLibrary() {
    active_line = nullptr;
}

const char* active_library_line() {
    return active_line;
}

}  // namespace fumon
