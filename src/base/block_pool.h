#pragma once

#include <array>
#include <cstddef>
#include <cstdlib>
#include <mutex>

namespace fumon {

/// Large blocks of memory that fields no longer need, for the next ones of the same size: the
/// system would clear new ones page by page, frame after frame. It never holds more than `most`
/// bytes, so that what large beds took does go back.
class BlockPool {
  public:
    static constexpr std::size_t most = std::size_t{40} << 20;

    BlockPool() = default;
    /// Frees what it holds.
    ~BlockPool() {
        for (const Block& block : blocks_) std::free(block.memory);
    }
    BlockPool(const BlockPool&) = delete;
    BlockPool& operator=(const BlockPool&) = delete;

    /// The one that all fields share.
    static BlockPool& shared() {
        static auto* const kept = new BlockPool;  // fields may end after everything else
        return *kept;
    }

    /// A block of exactly that size, with what was in it; nullptr: there is none.
    [[nodiscard]] void* take(std::size_t bytes) noexcept {
        const std::lock_guard lock(mutex_);
        for (Block& block : blocks_) {
            if (block.memory == nullptr || block.bytes != bytes) continue;
            void* memory = block.memory;
            block = {};
            bytes_ -= bytes;
            return memory;
        }
        return nullptr;
    }

    /// Whether it holds a block of std::aligned_alloc() from now on.
    [[nodiscard]] bool keep(void* memory, std::size_t bytes) noexcept {
        const std::lock_guard lock(mutex_);
        if (bytes > most - bytes_) return false;
        for (Block& block : blocks_) {
            if (block.memory != nullptr) continue;
            block = {memory, bytes};
            bytes_ += bytes;
            return true;
        }
        return false;
    }

  private:
    struct Block {
        void* memory = nullptr;
        std::size_t bytes = 0;
    };
    std::mutex mutex_;
    std::array<Block, 8> blocks_{};
    std::size_t bytes_ = 0;
};

}  // namespace fumon
