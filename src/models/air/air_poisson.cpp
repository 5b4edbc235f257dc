#include "models/air/air_poisson.h"

#include <Eigen/LU>
#include <algorithm>
#include <cstddef>
#include <map>

#include "base/cancellation.h"
#include "models/air/air_vectors.h"
#include "numerics/eigen_blocks.h"
#include "numerics/plane_loop.h"

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

namespace {

/// What the equation of the lowest air node of column i has beyond the rectangle's, as it is where
/// neither bed nor lid is near.
std::vector<PressureTerm> departure(const AirPlane& plane, BedPressure bed, int i) {
    const int k = plane.under_bed[static_cast<std::size_t>(i)] + 1;
    std::vector<PressureTerm> terms = pressure_equation(plane, bed, i, k);
    terms.push_back({i, k, 4.0});
    terms.push_back({plane.left(i), k, -1.0});
    terms.push_back({plane.right(i), k, -1.0});
    if (k > 1) terms.push_back({i, k - 1, -1.0});
    terms.push_back({i, k + 1, -1.0});
    return terms;
}

}  // namespace

AirPoisson::AirPoisson(const AirPlane& plane, BedPressure bed, WorkerPool& pool)
    : plane_(plane),
      pool_(pool),
      rectangle_(plane.nx, plane.nz - 1, pool),
      near_bed_(*std::max_element(plane.under_bed.begin(), plane.under_bed.end()) + 3),
      b_(rectangle_.size()),
      p_(rectangle_.size()),
      strengths_(static_cast<std::size_t>(plane.nx)) {
    for (int i = 0; i < plane.nx; ++i) departures_.push_back(departure(plane, bed, i));
    departures_.front().push_back({0, lowest(0), 1.0});
    invert_departures();
    solve_pinned(std::vector<double>(plane.at(plane.nx, 0), 1.0));
    of_constant_ = p_;
}

/// The matrix is the rectangle's A and what departs from it at the lowest air nodes, A + E D, so
/// its inverse is A⁻¹ − A⁻¹E (1 + D A⁻¹E)⁻¹ D A⁻¹ (Woodbury 1950).
void AirPoisson::invert_departures() {
    const auto count = static_cast<Eigen::Index>(plane_.nx);
    Eigen::MatrixXd capacitance = Eigen::MatrixXd::Identity(count, count);
    std::map<int, std::vector<int>> columns_of;  // by the height of their lowest air node
    for (int i = 0; i < plane_.nx; ++i) columns_of[lowest(i)].push_back(i);
    for (const auto& [node, columns] : columns_of) {
        std::fill(b_.begin(), b_.end(), 0.0);
        b_[at(0, node)] = 1.0;
        rectangle_.begin(b_, near_bed_);
        rectangle_.write(p_, near_bed_);
        for (const int source : columns) {
            throw_if_cancelled();
            for (int i = 0; i < plane_.nx; ++i) {
                double sum = 0.0;
                for (const PressureTerm& term : departures_[static_cast<std::size_t>(i)]) {
                    const int shifted = term.i - source;
                    sum +=
                        term.weight * p_[at(shifted < 0 ? shifted + plane_.nx : shifted, term.k)];
                }
                capacitance(i, source) += sum;
            }
        }
    }
    same_eigen_blocks_everywhere();
    const Eigen::MatrixXd inverse = capacitance.partialPivLu().inverse();
    inverse_.assign(inverse.data(), inverse.data() + inverse.size());
    std::fill(b_.begin(), b_.end(), 0.0);
}

void AirPoisson::solve_pinned(std::span<const double> right_side) {
    over_plane(pool_, plane_.nx, rectangle_.size(), [&](int begin, int end) {
        for (int i = begin; i < end; ++i) {
            std::fill(&b_[at(i, 1)], &b_[at(i, lowest(i))], 0.0);
            std::copy(&right_side[plane_.at(i, lowest(i))], &right_side[plane_.at(i, plane_.nz)],
                      &b_[at(i, lowest(i))]);
        }
    });
    rectangle_.begin(b_, plane_.nz);
    throw_if_cancelled();
    rectangle_.write(p_, near_bed_);
    std::vector<double> departing(static_cast<std::size_t>(plane_.nx));
    for (int i = 0; i < plane_.nx; ++i) {
        double sum = 0.0;
        for (const PressureTerm& term : departures_[static_cast<std::size_t>(i)])
            sum += term.weight * p_[at(term.i, term.k)];
        departing[static_cast<std::size_t>(i)] = sum;
    }
    over_plane(pool_, plane_.nx, inverse_.size(), [&](int begin, int end) {
        air::multiply(inverse_.data(), departing.data(), departing.size(),
                      static_cast<std::size_t>(begin), static_cast<std::size_t>(end),
                      strengths_.data());
    });
    throw_if_cancelled();
    const std::size_t seen = rectangle_.nodes_read(near_bed_);
    for (int i = 0; i < plane_.nx; ++i) {
        std::fill_n(&b_[at(i, 1)], seen, 0.0);
        b_[at(i, lowest(i))] = -strengths_[static_cast<std::size_t>(i)];
    }
    rectangle_.add(b_, near_bed_);
    rectangle_.write(p_, plane_.nz);
}

void AirPoisson::solve(std::span<const double> right_side, std::span<double> pressure) {
    solve_pinned(right_side);
    const std::size_t pinned = at(0, lowest(0));
    const double constant = p_[pinned] / of_constant_[pinned];
    over_plane(pool_, plane_.nx, rectangle_.size(), [&](int begin, int end) {
        for (int i = begin; i < end; ++i) {
            air::subtract_multiple(&p_[at(i, lowest(i))], constant, &of_constant_[at(i, lowest(i))],
                                   plane_.nz - lowest(i), &pressure[plane_.at(i, lowest(i))]);
        }
    });
}

}  // namespace fumon
