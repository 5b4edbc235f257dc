#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdlib>
#include <mutex>

namespace fumon {

/// Large blocks of memory that fields no longer need, for the next ones of the same size: the
/// system would clear new ones page by page, frame after frame. It holds at most `always` bytes, or
/// half as many as are in use, so that a run finds the memory of its last snapshot again, and what
/// large beds took does go back. The oldest go first, also where others are asked for: what it
/// holds never takes more than `always` beyond the most that was in use.
class BlockPool {
  public:
    static constexpr std::size_t always = std::size_t{40} << 20;

    /// While it lives, a pool holds all that was in use at once since: for work that needs the same
    /// memory again and again, like the frames of a film. A picture of water on endless ground
    /// takes some 400 MB of fields.
    class Repetition {
      public:
        explicit Repetition(BlockPool& pool) : pool_(pool) {
            const std::lock_guard lock(pool_.mutex_);
            if (pool_.repetitions_++ == 0) pool_.most_repeated_ = pool_.in_use_;
        }
        ~Repetition() {
            const std::lock_guard lock(pool_.mutex_);
            --pool_.repetitions_;
            pool_.hold_at_most(pool_.room());
        }
        Repetition(const Repetition&) = delete;
        Repetition& operator=(const Repetition&) = delete;

      private:
        BlockPool& pool_;
    };

    BlockPool() = default;
    /// Frees what it holds.
    ~BlockPool() { hold_at_most(0); }
    BlockPool(const BlockPool&) = delete;
    BlockPool& operator=(const BlockPool&) = delete;

    /// The one that all fields share.
    static BlockPool& shared() {
        static auto* const kept = new BlockPool;  // fields may end after everything else
        return *kept;
    }

    /// A block of exactly that size, with what was in it; nullptr: there is none, and the caller
    /// makes one. Either way as many bytes are in use from now on.
    [[nodiscard]] void* take(std::size_t bytes) noexcept {
        const std::lock_guard lock(mutex_);
        in_use_ += bytes;
        most_in_use_ = std::max(most_in_use_, in_use_);
        most_repeated_ = std::max(most_repeated_, in_use_);
        for (std::size_t k = count_; k-- > 0;) {
            if (blocks_[k].bytes == bytes) return removed(k);
        }
        const std::size_t whole = most_in_use_ + always;
        hold_at_most(whole - in_use_);
        return nullptr;
    }

    /// Says that a block which take() did not have could not be made.
    void not_made(std::size_t bytes) noexcept {
        const std::lock_guard lock(mutex_);
        in_use_ -= bytes;
    }

    /// Takes back a block of std::aligned_alloc() that take() gave or was told of.
    void give_back(void* memory, std::size_t bytes) noexcept {
        const std::lock_guard lock(mutex_);
        in_use_ -= bytes;
        const std::size_t room_now = room();
        if (bytes > room_now) {
            std::free(memory);
            hold_at_most(room_now);
            return;
        }
        hold_at_most(room_now - bytes);
        if (count_ == blocks_.size()) std::free(removed(0));
        blocks_[count_++] = {memory, bytes};
        bytes_ += bytes;
    }

    /// Bytes that it holds.
    [[nodiscard]] std::size_t held() const {
        const std::lock_guard lock(mutex_);
        return bytes_;
    }

  private:
    struct Block {
        void* memory = nullptr;
        std::size_t bytes = 0;
    };

    [[nodiscard]] std::size_t room() const noexcept {
        const std::size_t usual = std::max(always, in_use_ / 2);
        return repetitions_ > 0 ? std::max(usual, most_repeated_ - in_use_) : usual;
    }

    void hold_at_most(std::size_t bytes) noexcept {
        while (bytes_ > bytes) std::free(removed(0));
    }

    void* removed(std::size_t place) noexcept {
        const Block block = blocks_[place];
        std::move(blocks_.begin() + place + 1, blocks_.begin() + count_, blocks_.begin() + place);
        --count_;
        bytes_ -= block.bytes;
        return block.memory;
    }

    mutable std::mutex mutex_;
    std::array<Block, 64> blocks_{};  ///< the oldest first
    std::size_t count_ = 0;
    std::size_t bytes_ = 0;
    std::size_t in_use_ = 0;
    std::size_t most_in_use_ = 0;
    std::size_t most_repeated_ = 0;  ///< in use at once since the first repetition began
    int repetitions_ = 0;
};

}  // namespace fumon
