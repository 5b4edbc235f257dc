#include "models/air_poisson.h"

#include <Eigen/SparseLU>
#include <cstddef>

#include "support/error.h"

namespace fumon {

std::vector<PressureTerm> pressure_equation(const AirPlane& plane, BedPressure bed, int i, int k) {
    std::vector<PressureTerm> terms{{i, k, -4.0}};
    const auto add = [&](int column, int node) {
        if (node == plane.nz) node = plane.nz - 1;
        if (node > plane.under_bed[static_cast<std::size_t>(column)]) {
            terms.push_back({column, node, 1.0});
        } else if (bed == BedPressure::one_sided) {
            terms.push_back({column, node + 1, 1.0});
        } else {
            terms.push_back({column, node + 1, 2.0});
            terms.push_back({column, node + 2, -1.0});
        }
    };
    add(plane.left(i), k);
    add(plane.right(i), k);
    add(i, k - 1);
    add(i, k + 1);
    return terms;
}

class AirPoisson::Factors {
  public:
    using Matrix = Eigen::SparseMatrix<double>;

    Factors(const AirPlane& plane, BedPressure bed) {
        std::vector<int> number(plane.at(plane.nx, 0), -1);
        for (int i = 0; i < plane.nx; ++i) {
            for (int k = plane.under_bed[static_cast<std::size_t>(i)] + 1; k < plane.nz; ++k) {
                number[plane.at(i, k)] = static_cast<int>(nodes_.size());
                nodes_.push_back(plane.at(i, k));
            }
        }
        std::vector<Eigen::Triplet<double>> entries;
        for (int i = 0; i < plane.nx; ++i) {
            for (int k = plane.under_bed[static_cast<std::size_t>(i)] + 1; k < plane.nz; ++k) {
                for (const PressureTerm& term : pressure_equation(plane, bed, i, k)) {
                    entries.emplace_back(number[plane.at(i, k)], number[plane.at(term.i, term.k)],
                                         term.weight);
                }
            }
        }
        entries.emplace_back(0, 0, 1.0);
        const auto count = static_cast<Eigen::Index>(nodes_.size());
        Matrix matrix(count, count);
        matrix.setFromTriplets(entries.begin(), entries.end());
        factors_.compute(matrix);
        if (factors_.info() != Eigen::Success) throw Error("the pressure has no solution");
        of_constant_ = factors_.solve(Eigen::VectorXd::Ones(count));
    }

    void solve(std::span<const double> right_side, std::span<double> pressure) {
        Eigen::VectorXd known(static_cast<Eigen::Index>(nodes_.size()));
        for (std::size_t n = 0; n < nodes_.size(); ++n)
            known[static_cast<Eigen::Index>(n)] = right_side[nodes_[n]];
        const Eigen::VectorXd raw = factors_.solve(known);
        const double constant = raw[0] / of_constant_[0];
        for (std::size_t n = 0; n < nodes_.size(); ++n) {
            const auto at = static_cast<Eigen::Index>(n);
            pressure[nodes_[n]] = raw[at] - constant * of_constant_[at];
        }
    }

  private:
    std::vector<std::size_t> nodes_;  ///< where the air nodes are on the plane
    Eigen::SparseLU<Matrix> factors_;
    Eigen::VectorXd of_constant_;  ///< the solution for 1 everywhere
};

AirPoisson::AirPoisson(const AirPlane& plane, BedPressure bed)
    : factors_(std::make_unique<Factors>(plane, bed)) {}

AirPoisson::~AirPoisson() = default;

void AirPoisson::solve(std::span<const double> right_side, std::span<double> pressure) {
    factors_->solve(right_side, pressure);
}

}  // namespace fumon
