#pragma once

#include <cstddef>
#include <vector>

#include "numerics/fourier_transform.h"

namespace fumon {

class WorkerPool;

/// Solves the compact Laplacian Σ_neighbours p − 4p = b on columns of nodes 0 … rows − 1, periodic
/// in x, with p = 0 below the lowest node and no gradient above the highest: Fourier modes in x,
/// a tridiagonal system in z for each. Columns lie `stride()` apart, node k of column i at
/// i·stride() + k; what lies beyond the nodes must be 0 going in.
class RectanglePoisson {
  public:
    RectanglePoisson(int nx, int nodes, WorkerPool& pool);

    [[nodiscard]] std::size_t stride() const { return stride_; }
    [[nodiscard]] std::size_t size() const { return stride_ * static_cast<std::size_t>(nx_); }
    /// How many nodes of a column are read where it differs from 0 below `rows` only.
    [[nodiscard]] std::size_t nodes_read(int rows) const {
        return static_cast<std::size_t>(chunks(rows)) * FourierTransform::rows;
    }

    /// Begins anew with the solution for b, of which only nodes below `rows` differ from 0.
    void begin(const std::vector<double>& b, int rows);
    /// Adds the solution for b, of which only nodes below `rows` differ from 0.
    void add(const std::vector<double>& b, int rows);
    /// The nodes below `rows` of the solution so far.
    void write(std::vector<double>& p, int rows);

  private:
    void transform(const std::vector<double>& b, int rows);
    void solve_modes(int rows, bool anew);
    [[nodiscard]] int chunks(int rows) const;

    int nx_;
    int nodes_;
    int groups_;  ///< of modes that are solved together
    std::size_t stride_;
    WorkerPool& pool_;
    FourierTransform transform_;
    std::vector<double> inverse_pivots_;  ///< of each group, node after node
    std::vector<double> real_, imaginary_;
    std::vector<double> solved_real_, solved_imaginary_;
};

}  // namespace fumon
