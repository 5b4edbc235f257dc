#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/grid.h"

namespace fumon {

class WorkerPool;

/// Creep as in the program of Sudo (2002, appendix A): in place, row after row from y = 0 and from
/// x = 0, each cell that is strictly higher than its 8 neighbours at that moment gives D·h away, a
/// sixth of it to each side and a twelfth to each corner.
///
/// Only the maxima of the bed before are visited, and the surroundings of cells that gave. Threads
/// sweep parts of the bed side by side, each but the first guessing that the row before its first
/// has given nothing. Then, part by part, rows are swept again as they truly are until a row and
/// the next come out as they did by the guess: what follows is right. Gifts lose themselves within
/// a few rows; where they do not, the whole part is swept again. So the result is the plain
/// sweep's.
class MaximaCreep {
  public:
    /// `scratch` has the bed's size, and other values afterwards.
    void operator()(Grid& bed, Grid& scratch, double rate, WorkerPool& pool);

  private:
    using Word = std::uint64_t;
    using Row = std::vector<double>;

    /// What one sweep visits.
    struct Part {
        int begin = 0;
        int end = 0;
        Row behind;                     ///< row begin − 1, as guessed
        Row ahead;                      ///< row `end`, with what this part gives it
        std::vector<Word> marks_ahead;  ///< of rows `end` and `end` + 1
        std::vector<Row> stages;        ///< of the first rows: each and its next after its visit
        Row sides;                      ///< scratch for marking
        Row column;                     ///< likewise
    };

    /// A row that is visited, with those beside it.
    struct Visited {
        int y;
        double* south;
        double* here;
        double* north;
    };

    void divide(const Grid& bed, int threads);
    void mark(const Grid& bed, int begin, int end, Part& part);
    void prepare(const Grid& bed, Grid& originals, Part& part);
    void sweep(Grid& bed, Part& part, double rate);
    void sweep_again(Grid& bed, Grid& originals, const Part& before, Part& part, double rate);
    void visit(const Visited& row, Part* part, double rate);
    void mark_around(int x, int y, int reach, Part* part);
    void add_marks_ahead(const Part& part);
    Word* marks(int row) { return marks_.data() + static_cast<std::size_t>(row) * words_; }
    Word* marks_for_row(int row, Part* part);

    int nx_ = 0;
    int ny_ = 0;
    std::size_t words_ = 0;    ///< of 64 cells, in a row
    std::vector<Word> marks_;  ///< a bit for each cell that is to be visited
    std::vector<Part> parts_;
};

}  // namespace fumon
