#pragma once

#include <sys/mman.h>

#include <cstddef>
#include <cstdlib>
#include <new>

#include "base/block_pool.h"

namespace fumon {

/// An allocator for fields: large ones lie on huge pages where the system has them, so that random
/// access does not wait for address translation as well as for memory. Those of fields that are
/// gone are used again, see BlockPool.
template <class Value>
struct HugePageAllocator {
    using value_type = Value;

    HugePageAllocator() = default;
    template <class Other>
    explicit HugePageAllocator(const HugePageAllocator<Other>& /*any*/) noexcept {}

    Value* allocate(std::size_t count) {
        const std::size_t bytes = count * sizeof(Value);
        if (bytes < huge_page_threshold_bytes) return static_cast<Value*>(::operator new(bytes));
        const std::size_t whole = rounded_to_pages(bytes);
        if (void* kept = BlockPool::shared().take(whole)) return static_cast<Value*>(kept);
        void* memory = std::aligned_alloc(page, whole);
        if (memory == nullptr) {
            BlockPool::shared().not_made(whole);
            throw std::bad_alloc();
        }
#ifdef MADV_HUGEPAGE
        madvise(memory, whole, MADV_HUGEPAGE);  // a wish: small pages do as well
#endif
        return static_cast<Value*>(memory);
    }

    void deallocate(Value* memory, std::size_t count) noexcept {
        const std::size_t bytes = count * sizeof(Value);
        if (bytes < huge_page_threshold_bytes) {
            ::operator delete(memory);
        } else {
            BlockPool::shared().give_back(memory, rounded_to_pages(bytes));
        }
    }

    friend bool operator==(const HugePageAllocator&, const HugePageAllocator&) {
        return true;
    }

  private:
    static constexpr std::size_t page = std::size_t{1} << 21;
    static constexpr std::size_t huge_page_threshold_bytes = 2 * page;

    static constexpr std::size_t rounded_to_pages(std::size_t bytes) {
        return (bytes + page - 1) / page * page;
    }
};

}  // namespace fumon
