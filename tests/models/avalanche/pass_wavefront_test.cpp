// Passes that go over rows together, in strips with seams, do what one pass after the other does.

#include "models/avalanche/pass_wavefront.h"

#include <gtest/gtest.h>

#include <vector>

namespace fumon::test {
namespace {

/// Rows of a number each: sliding one finds what it and its neighbours come to, settling one adds
/// what it and its neighbours gave.
class Rows {
  public:
    Rows(int count, bool periodic) : slides_(static_cast<std::size_t>(count)), periodic_(periodic) {
        for (int y = 0; y < count; ++y) settled_.push_back(static_cast<unsigned>(y * y + 3));
    }

    void slide(int y) { slides_[index(y)] = around(settled_, y); }
    void settle(int y) { settled_[index(y)] += around(slides_, y); }
    [[nodiscard]] const std::vector<unsigned>& settled() const { return settled_; }

  private:
    [[nodiscard]] int count() const { return static_cast<int>(settled_.size()); }
    [[nodiscard]] std::size_t index(int y) const {
        return static_cast<std::size_t>((y + count()) % count());
    }
    [[nodiscard]] unsigned around(const std::vector<unsigned>& rows, int y) const {
        const int here = static_cast<int>(index(y));
        const auto at = [&](int row) {
            return periodic_ || (row >= 0 && row < count()) ? rows[index(row)] : 7U;
        };
        return at(here - 1) * 5 + at(here) * 3 + at(here + 1);
    }

    std::vector<unsigned> settled_;
    std::vector<unsigned> slides_;
    bool periodic_;
};

void go_together(Rows& rows, int count, bool periodic, int strips, int margin, int passes) {
    const auto go = [&](const PassWavefront& front) {
        front.go(
            passes, [&](int, int y) { rows.slide(y); }, [&](int, int y) { rows.settle(y); });
    };
    const auto begin = [&](int n) { return PassWavefront::strip_begin(count, n, strips); };
    for (int n = 0; n < strips; ++n) {
        go(PassWavefront::of_strip(begin(n), begin(n + 1), n > 0 || periodic,
                                   n + 1 < strips || periodic, margin));
    }
    for (int n = periodic ? 0 : 1; n < strips; ++n) go(PassWavefront::of_seam(begin(n), margin));
}

TEST(PassWavefront, PassesTogetherAreThoseOfOneAfterTheOther) {
    for (const bool periodic : {true, false}) {
        for (const int count : {2, 4, 7, 40, 61}) {
            for (const int strips : {1, 2, 3}) {
                for (const int margin : {0, 1}) {
                    const int rows = count / strips;
                    const bool seams = periodic || strips > 1;
                    const int most = seams ? PassWavefront::most_passes(rows, margin) : 9;
                    for (int passes = 1; rows >= 2 && passes <= most; ++passes) {
                        SCOPED_TRACE(testing::Message()
                                     << count << " rows, periodic " << periodic << ", " << strips
                                     << " strips, margin " << margin << ", passes " << passes);
                        Rows together(count, periodic);
                        go_together(together, count, periodic, strips, margin, passes);
                        Rows one_by_one(count, periodic);
                        for (int pass = 0; pass < passes; ++pass) {
                            for (int y = 0; y < count; ++y) one_by_one.slide(y);
                            for (int y = 0; y < count; ++y) one_by_one.settle(y);
                        }
                        ASSERT_EQ(together.settled(), one_by_one.settled());
                    }
                }
            }
        }
    }
    EXPECT_GE(PassWavefront::most_passes(16, 1), 4);
    EXPECT_EQ(PassWavefront::most_passes(2, 0), 1);
}

}  // namespace
}  // namespace fumon::test
