#pragma once

#include <algorithm>
#include <cstdint>

namespace fumon {

/// The rows that passes over a grid go through, where a pass slides rows and then settles them:
/// sliding a row reads it and its neighbours as the pass before has settled them, settling one
/// reads what slides from it and its neighbours. Pass p slides the rows from begin + slant_begin·p
/// to end + slant_end·p and settles as many more at either end as is said, or fewer.
///
/// Passes that go two rows apart do not disturb one another. So strips of rows can be shared out
/// among threads, each with many passes at once: they leave wedges along the seams between them,
/// which are gone through when all strips are done.
struct PassWavefront {
    int begin = 0;
    int end = 0;
    int slant_begin = 0;
    int slant_end = 0;
    int settled_before = 0;
    int settled_beyond = 0;

    static constexpr int rows_apart = 2;

    /// The first row of strip n of so many that share the rows.
    static int strip_begin(int rows, int n, int strips) {
        return static_cast<int>(std::int64_t{rows} * n / strips);
    }

    /// Of a strip with seams at its ends, or with edges of the grid. The first pass keeps `margin`
    /// rows away from seams.
    static PassWavefront of_strip(int begin, int end, bool seam_at_begin, bool seam_at_end,
                                  int margin) {
        return {seam_at_begin ? begin + margin : begin,
                seam_at_end ? end - margin : end,
                seam_at_begin ? rows_apart : 0,
                seam_at_end ? -rows_apart : 0,
                seam_at_begin ? -1 : 0,
                seam_at_end ? -1 : 0};
    }

    /// Of what strips leave along the seam before a row.
    static PassWavefront of_seam(int row, int margin) {
        return {row - margin, row + margin, -rows_apart, rows_apart, 1, 1};
    }

    /// How many passes a strip of so many rows, at least two, has room for between its seams.
    static int most_passes(int rows, int margin) {
        return (rows - 2 * margin + 2) / (2 * rows_apart);
    }

    /// Calls slide(p, y) and settle(p, y) for 0 ≤ p < passes, row after row with all passes in
    /// flight, so that the rows between the first and the last pass stay in the caches.
    template <class Slide, class Settle>
    void go(int passes, const Slide& slide, const Settle& settle) const {
        const int last_pass = passes - 1;
        const int first = std::min(begin, begin + (slant_begin + rows_apart) * last_pass);
        const int last = std::max(end, end + (slant_end + rows_apart) * last_pass) + 2;
        for (int front = first; front < last; ++front) {
            for (int p = 0; p < passes; ++p) {
                const int y = front - rows_apart * p;
                const int from = begin + slant_begin * p;
                const int to = end + slant_end * p;
                if (y >= from && y < to) slide(p, y);
                if (y - 1 >= from - settled_before && y - 1 < to + settled_beyond) settle(p, y - 1);
            }
        }
    }
};

}  // namespace fumon
