#pragma once

#include <sys/mman.h>

#include <cstddef>
#include <cstdlib>
#include <new>

#include "base/kept_blocks.h"

namespace fumon {

/// An allocator for fields: large ones lie on large pages where the system has them, so that random
/// access does not wait for address translation as well as for memory. Those of fields that are
/// gone are used again, see KeptBlocks.
template <class Value>
struct LargePages {
    using value_type = Value;

    LargePages() = default;
    template <class Other>
    explicit LargePages(const LargePages<Other>& /*any*/) noexcept {}

    Value* allocate(std::size_t count) {
        const std::size_t bytes = count * sizeof(Value);
        if (bytes < worth_it) return static_cast<Value*>(::operator new(bytes));
        const std::size_t whole = whole_pages(bytes);
        if (void* kept = KeptBlocks::shared().take(whole)) return static_cast<Value*>(kept);
        void* memory = std::aligned_alloc(page, whole);
        if (memory == nullptr) throw std::bad_alloc();
#ifdef MADV_HUGEPAGE
        madvise(memory, whole, MADV_HUGEPAGE);  // a wish: small pages do as well
#endif
        return static_cast<Value*>(memory);
    }

    void deallocate(Value* memory, std::size_t count) noexcept {
        const std::size_t bytes = count * sizeof(Value);
        if (bytes < worth_it) {
            ::operator delete(memory);
        } else if (!KeptBlocks::shared().keep(memory, whole_pages(bytes))) {
            std::free(memory);
        }
    }

    friend bool operator==(const LargePages&, const LargePages&) {
        return true;
    }

  private:
    static constexpr std::size_t page = std::size_t{1} << 21;
    static constexpr std::size_t worth_it = 2 * page;

    static constexpr std::size_t whole_pages(std::size_t bytes) {
        return (bytes + page - 1) / page * page;
    }
};

}  // namespace fumon
