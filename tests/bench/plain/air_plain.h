#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "models/air/air_plane.h"
#include "models/air/airflow_parameters.h"

namespace fumon::plain {

/// Fourier transforms of complex rows by Stockham's method (Cochran et al. 1967), for lengths
/// whose factors are small.
class Fourier {
  public:
    explicit Fourier(int length);

    /// Σ_i f(i) exp(−2πi·mi/n), in place.
    void transform(std::vector<double>& re, std::vector<double>& im);

  private:
    std::size_t length_;
    std::vector<std::size_t> radices_;
    std::vector<double> cosine_, sine_;
    std::vector<double> re_, im_;
};

/// How pressures are solved exactly.
enum class Pressures {
    by_factors,  ///< of the equations' band matrix, as one does first
    by_fourier,  ///< as fumon does: modes, and a dense matrix for the bed
};

/// The pressure equations' matrix as two triangular factors within its band.
class BandFactors {
  public:
    BandFactors(const AirPlane& plane, BedPressure bed);

    /// In place, on the plane's nodes.
    void solve(std::vector<double>& values);

  private:
    /// The column's neighbours in a ring are at most two columns away from it.
    [[nodiscard]] std::size_t unknown(int i, int k) const;
    [[nodiscard]] double* column(std::size_t j) { return &matrix_[j * (2 * band_ + 1)]; }
    void factorise();

    AirPlane plane_;
    std::size_t band_;
    std::size_t count_;
    std::vector<double> matrix_;  ///< by columns: rows j − band … j + band
    std::vector<double> right_;
};

/// The air of fumon's AirProjection with upwind differences and exact pressures as plain loops on
/// one thread: what fumon's rates are measured against. Its velocities are fumon's but for rounding
/// in the pressures.
class Air {
  public:
    Air(const AirPlane& plane, const AirflowParameters& parameters, Pressures pressures);

    void step();
    [[nodiscard]] const std::vector<double>& u() const { return u_; }
    [[nodiscard]] const std::vector<double>& w() const { return w_; }

  private:
    struct Term {
        int i, k;
        double weight;
    };

    void invert_departures();
    void solve();
    void solve_by_fourier();
    void add_rectangle(int rows_of_source);
    void transform_rows(std::vector<double>& values, int rows, bool back);
    [[nodiscard]] int lowest(int i) const {
        return plane_.under_bed[static_cast<std::size_t>(i)] + 1;
    }
    [[nodiscard]] std::size_t at(int i, int k) const { return plane_.at(i, k); }

    AirPlane plane_;
    AirflowParameters parameters_;
    int near_bed_;
    std::unique_ptr<BandFactors> factors_;
    Fourier fourier_;
    std::vector<double> u_, w_, p_, predicted_u_, predicted_w_, b_, solution_;
    std::vector<double> source_re_, source_im_, solved_re_, solved_im_;  // rows of modes
    std::vector<double> inverse_pivots_;
    std::vector<std::vector<Term>> departures_;
    std::vector<double> inverse_;  ///< nx × nx, by columns
    std::vector<double> of_constant_;
    std::vector<double> row_re_, row_im_;
};

}  // namespace fumon::plain
