#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace fumon {

/// A set of cells as a bit each, row by row, so that threads which own rows can fill it and a whole
/// empty row is seen at a glance.
class CellBitset {
  public:
    using Word = std::uint64_t;
    static constexpr int word_bits = 64;

    CellBitset() = default;
    CellBitset(int nx, int ny)
        : nx_(nx),
          words_((nx + word_bits - 1) / word_bits),
          bits_(static_cast<std::size_t>(words_) * static_cast<std::size_t>(ny)),
          any_(static_cast<std::size_t>(ny)) {}

    [[nodiscard]] int words() const { return words_; }
    Word* row(int y) { return bits_.data() + place(y); }
    [[nodiscard]] const Word* row(int y) const { return bits_.data() + place(y); }

    [[nodiscard]] bool any(int y) const { return any_[static_cast<std::size_t>(y)] != 0; }
    /// Whether the row has cells, to be said after it was filled.
    void set_any(int y, bool any) { any_[static_cast<std::size_t>(y)] = any ? 1 : 0; }

    [[nodiscard]] bool contains(int x, int y) const {
        return ((row(y)[x / word_bits] >> static_cast<unsigned>(x % word_bits)) & 1U) != 0;
    }

    /// Word w of row y moved one cell east: the cells whose western neighbour is in the set.
    [[nodiscard]] Word from_west(int y, int w, bool periodic) const {
        const Word* words = row(y);
        Word moved = words[w] << 1U;
        if (w > 0) {
            moved |= words[w - 1] >> (word_bits - 1U);
        } else if (periodic) {
            moved |= (words[words_ - 1] >> last_bit()) & 1U;
        }
        return w == words_ - 1 ? moved & last_word() : moved;
    }

    /// Likewise the cells whose eastern neighbour is in the set.
    [[nodiscard]] Word from_east(int y, int w, bool periodic) const {
        const Word* words = row(y);
        Word moved = words[w] >> 1U;
        if (w < words_ - 1) {
            moved |= words[w + 1] << (word_bits - 1U);
        } else if (periodic) {
            moved |= (words[0] & 1U) << last_bit();
        }
        return moved;
    }

  private:
    [[nodiscard]] std::size_t place(int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(words_);
    }
    /// Where in the last word the last cell stands.
    [[nodiscard]] unsigned last_bit() const { return static_cast<unsigned>((nx_ - 1) % word_bits); }
    [[nodiscard]] Word last_word() const { return ~Word{0} >> (word_bits - 1U - last_bit()); }

    int nx_ = 0;
    int words_ = 0;
    std::vector<Word> bits_;
    std::vector<std::uint8_t> any_;
};

}  // namespace fumon
