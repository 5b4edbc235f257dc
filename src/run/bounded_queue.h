#pragma once

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <mutex>
#include <optional>
#include <utility>

namespace fumon {

/// A queue between two stages of the pipeline. A full queue makes the producer wait (back-pressure,
/// nothing is dropped); close() lets the consumer finish what is in it; abort() wakes everyone at
/// once.
template <class Item>
class BoundedQueue {
  public:
    explicit BoundedQueue(std::size_t capacity) : capacity_(capacity) {}

    /// Waits for room. False when the queue was aborted: the item is not taken.
    bool push(Item item) {
        std::unique_lock lock(mutex_);
        room_.wait(lock, [this] { return aborted_ || items_.size() < capacity_; });
        if (aborted_) return false;
        items_.push_back(std::move(item));
        filled_.notify_one();
        return true;
    }

    /// Waits for an item. Nothing when the queue is closed and empty, or aborted.
    std::optional<Item> pop() {
        std::unique_lock lock(mutex_);
        filled_.wait(lock, [this] { return aborted_ || closed_ || !items_.empty(); });
        if (aborted_ || items_.empty()) return std::nullopt;
        std::optional<Item> item(std::move(items_.front()));
        items_.pop_front();
        room_.notify_one();
        return item;
    }

    void close() {
        const std::lock_guard lock(mutex_);
        closed_ = true;
        filled_.notify_all();
    }

    void abort() {
        const std::lock_guard lock(mutex_);
        aborted_ = true;
        items_.clear();
        filled_.notify_all();
        room_.notify_all();
    }

  private:
    std::size_t capacity_;
    std::mutex mutex_;
    std::condition_variable room_;
    std::condition_variable filled_;
    std::deque<Item> items_;
    bool closed_ = false;
    bool aborted_ = false;
};

}  // namespace fumon
