#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace fumon {

/// A set of cell numbers 0 … size − 1 that finds its next member quickly: one bit a cell, above it
/// one bit for each word of 64 that is not empty, and so on. Insertion, removal and the search for
/// the next member touch a word or two; the three levels serve up to some 10⁸ cells.
class CellSet {
  public:
    static constexpr std::size_t none = ~std::size_t{0};

    explicit CellSet(std::size_t size = 0)
        : cells_(words(size)), groups_(words(cells_.size())), regions_(words(groups_.size())) {}

    [[nodiscard]] bool contains(std::size_t cell) const {
        return (cells_[cell >> shift] & bit(cell)) != 0;
    }

    void insert(std::size_t cell) {
        const std::size_t word = cell >> shift;
        const bool was_empty = cells_[word] == 0;
        cells_[word] |= bit(cell);
        if (was_empty) {
            groups_[word >> shift] |= bit(word);
            regions_[word >> (2 * shift)] |= bit(word >> shift);
        }
    }

    void remove(std::size_t cell) {
        const std::size_t word = cell >> shift;
        cells_[word] &= ~bit(cell);
        if (cells_[word] != 0) return;
        groups_[word >> shift] &= ~bit(word);
        if (groups_[word >> shift] == 0) regions_[word >> (2 * shift)] &= ~bit(word >> shift);
    }

    /// The smallest member that is `from` or more; `none` if there is none.
    [[nodiscard]] std::size_t next(std::size_t from) const {
        std::size_t word = from >> shift;
        if (word >= cells_.size()) return none;
        const std::uint64_t here = cells_[word] & not_below(from);
        if (here != 0) return (word << shift) + first(here);
        word = next_word(word + 1);
        return word == none ? none : (word << shift) + first(cells_[word]);
    }

  private:
    static constexpr unsigned shift = 6;

    static std::size_t words(std::size_t bits) { return (bits + 63) >> shift; }
    static std::uint64_t bit(std::size_t number) { return std::uint64_t{1} << (number & 63U); }
    static std::uint64_t not_below(std::size_t number) {
        return ~std::uint64_t{0} << (number & 63U);
    }
    static std::size_t first(std::uint64_t word) {
        return static_cast<std::size_t>(std::countr_zero(word));
    }

    /// The next word of cells, from this one on, that is not empty.
    [[nodiscard]] std::size_t next_word(std::size_t from) const {
        std::size_t group = from >> shift;
        if (group >= groups_.size()) return none;
        const std::uint64_t here = groups_[group] & not_below(from);
        if (here != 0) return (group << shift) + first(here);
        ++group;
        std::size_t region = group >> shift;
        if (region >= regions_.size()) return none;
        std::uint64_t left = regions_[region] & not_below(group);
        while (left == 0) {
            if (++region == regions_.size()) return none;
            left = regions_[region];
        }
        group = (region << shift) + first(left);
        return (group << shift) + first(groups_[group]);
    }

    std::vector<std::uint64_t> cells_;
    std::vector<std::uint64_t> groups_;   ///< which words of cells_ are not empty
    std::vector<std::uint64_t> regions_;  ///< which words of groups_ are not empty
};

}  // namespace fumon
