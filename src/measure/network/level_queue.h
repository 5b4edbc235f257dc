#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace fumon {

/// Cells waiting at levels: the lowest leaves first, of equal ones the one that came first. For
/// floods, in which nothing comes in below what has left: what comes in at the level that left last
/// waits in line (Barnes, Lehman & Mulla 2014), the rest in a heap of four branches.
class LevelQueue {
  public:
    struct Entry {
        double level;
        std::int32_t number;  ///< of those that came in
        std::int32_t cell;
    };

    void push(double level, std::int32_t cell) {
        const Entry entry{level, number_++, cell};
        if (level == current_) {
            line_.push_back(entry);
            return;
        }
        std::size_t at = heap_.size();
        heap_.push_back(entry);
        while (at > 0) {
            const std::size_t above = (at - 1) / branches;
            if (!before(entry, heap_[above])) break;
            heap_[at] = heap_[above];
            at = above;
        }
        heap_[at] = entry;
    }

    [[nodiscard]] bool empty() const { return heap_.empty() && next_in_line_ == line_.size(); }

    /// Takes out the first one. There is one.
    Entry pop() {
        Entry first{};
        const bool waits = next_in_line_ < line_.size();
        if (waits && (heap_.empty() || before(line_[next_in_line_], heap_.front()))) {
            first = line_[next_in_line_++];
            if (next_in_line_ == line_.size()) {
                line_.clear();
                next_in_line_ = 0;
            }
        } else {
            first = heap_.front();
            take_top();
        }
        current_ = first.level;
        return first;
    }

  private:
    static constexpr std::size_t branches = 4;

    static bool before(const Entry& one, const Entry& other) {
        return one.level != other.level ? one.level < other.level : one.number < other.number;
    }

    void take_top() {
        const Entry last = heap_.back();
        heap_.pop_back();
        const std::size_t count = heap_.size();
        if (count == 0) return;
        std::size_t at = 0;
        for (std::size_t child = 1; child < count; child = branches * at + 1) {
            const std::size_t end = child + branches < count ? child + branches : count;
            std::size_t least = child;
            for (std::size_t i = child + 1; i < end; ++i)
                if (before(heap_[i], heap_[least])) least = i;
            if (!before(heap_[least], last)) break;
            heap_[at] = heap_[least];
            at = least;
        }
        heap_[at] = last;
    }

    std::vector<Entry> heap_;
    std::vector<Entry> line_;
    std::size_t next_in_line_ = 0;
    double current_ = -std::numeric_limits<double>::infinity();
    std::int32_t number_ = 0;
};

}  // namespace fumon
