#include "files/library_at_work.h"

namespace fumon {

namespace {

thread_local const char* line_at_work = nullptr;

}  // namespace

LibraryAtWork::LibraryAtWork(const char* line) {
    line_at_work = line;
}

LibraryAtWork::~LibraryAtWork() {
    line_at_work = nullptr;
}

const char* line_of_library_at_work() {
    return line_at_work;
}

}  // namespace fumon
