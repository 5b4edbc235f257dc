#include "plain/air_plain.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "models/air/air_poisson.h"

namespace fumon::plain {

namespace {

/// By Gauss and Jordan, with pivots from their column.
std::vector<double> inverse_of(std::vector<double> matrix, std::size_t size) {
    std::vector<double> inverse(size * size, 0.0);
    for (std::size_t i = 0; i < size; ++i) inverse[i * size + i] = 1.0;
    const auto subtract = [size](std::vector<double>& of, std::size_t row, std::size_t by,
                                 double factor) {
        for (std::size_t j = 0; j < size; ++j) of[row * size + j] -= factor * of[by * size + j];
    };
    for (std::size_t step = 0; step < size; ++step) {
        std::size_t pivot = step;
        for (std::size_t i = step; i < size; ++i) {
            const double here = std::fabs(matrix[i * size + step]);
            if (here > std::fabs(matrix[pivot * size + step])) pivot = i;
        }
        for (std::size_t j = 0; j < size; ++j) {
            std::swap(matrix[step * size + j], matrix[pivot * size + j]);
            std::swap(inverse[step * size + j], inverse[pivot * size + j]);
        }
        const double scale = 1.0 / matrix[step * size + step];
        for (std::size_t j = 0; j < size; ++j) {
            matrix[step * size + j] *= scale;
            inverse[step * size + j] *= scale;
        }
        for (std::size_t i = 0; i < size; ++i) {
            const double factor = matrix[i * size + step];
            if (i == step || factor == 0.0) continue;
            subtract(matrix, i, step, factor);
            subtract(inverse, i, step, factor);
        }
    }
    return inverse;
}

}  // namespace

Fourier::Fourier(int length) : length_(static_cast<std::size_t>(length)) {
    std::size_t rest = length_;
    for (const std::size_t radix : {4UL, 5UL, 2UL, 3UL, 7UL, 11UL, 13UL}) {
        for (; rest % radix == 0; rest /= radix) radices_.push_back(radix);
    }
    for (std::size_t j = 0; j < length_; ++j) {
        const double angle =
            2.0 * std::numbers::pi * static_cast<double>(j) / static_cast<double>(length_);
        cosine_.push_back(std::cos(angle));
        sine_.push_back(std::sin(angle));
    }
    re_.resize(length_);
    im_.resize(length_);
}

void Fourier::transform(std::vector<double>& re, std::vector<double>& im) {
    std::size_t parts = length_;
    std::size_t stride = 1;
    for (const std::size_t radix : radices_) {
        parts /= radix;
        const std::size_t reach = parts * stride;
        for (std::size_t p = 0; p < parts; ++p) {
            const std::size_t turn = p * stride;
            const auto put = [&](std::size_t t, std::size_t q, double a, double b) {
                const double c = cosine_[t * turn];
                const double s = sine_[t * turn];
                const std::size_t to = (radix * p + t) * stride + q;
                re_[to] = a * c + b * s;
                im_[to] = b * c - a * s;
            };
            for (std::size_t q = 0; q < stride; ++q) {
                const double* x = &re[p * stride + q];
                const double* y = &im[p * stride + q];
                if (radix == 4) {
                    const double sum_re = x[0] + x[2 * reach], sum_im = y[0] + y[2 * reach];
                    const double off_re = x[0] - x[2 * reach], off_im = y[0] - y[2 * reach];
                    const double odd_re = x[reach] + x[3 * reach];
                    const double odd_im = y[reach] + y[3 * reach];
                    const double cross_re = x[reach] - x[3 * reach];
                    const double cross_im = y[reach] - y[3 * reach];
                    put(0, q, sum_re + odd_re, sum_im + odd_im);
                    put(1, q, off_re + cross_im, off_im - cross_re);
                    put(2, q, sum_re - odd_re, sum_im - odd_im);
                    put(3, q, off_re - cross_im, off_im + cross_re);
                } else if (radix == 5) {
                    const std::size_t fifth = length_ / 5;
                    const double c1 = cosine_[fifth], s1 = sine_[fifth];
                    const double c2 = cosine_[2 * fifth], s2 = sine_[2 * fifth];
                    const double t1 = x[reach] + x[4 * reach], u1 = y[reach] + y[4 * reach];
                    const double t2 = x[2 * reach] + x[3 * reach];
                    const double u2 = y[2 * reach] + y[3 * reach];
                    const double d1 = x[reach] - x[4 * reach], e1 = y[reach] - y[4 * reach];
                    const double d2 = x[2 * reach] - x[3 * reach];
                    const double e2 = y[2 * reach] - y[3 * reach];
                    const double r1 = x[0] + (c1 * t1 + c2 * t2), i1 = y[0] + (c1 * u1 + c2 * u2);
                    const double r2 = x[0] + (c2 * t1 + c1 * t2), i2 = y[0] + (c2 * u1 + c1 * u2);
                    const double v1 = s1 * d1 + s2 * d2, z1 = s1 * e1 + s2 * e2;
                    const double v2 = s2 * d1 - s1 * d2, z2 = s2 * e1 - s1 * e2;
                    put(0, q, x[0] + (t1 + t2), y[0] + (u1 + u2));
                    put(1, q, r1 + z1, i1 - v1);
                    put(2, q, r2 + z2, i2 - v2);
                    put(3, q, r2 - z2, i2 + v2);
                    put(4, q, r1 - z1, i1 + v1);
                } else {
                    for (std::size_t t = 0; t < radix; ++t) {
                        double a = 0.0;
                        double b = 0.0;
                        for (std::size_t j = 0; j < radix; ++j) {
                            const std::size_t angle = (j * t) % radix * (length_ / radix);
                            a += x[j * reach] * cosine_[angle] + y[j * reach] * sine_[angle];
                            b += y[j * reach] * cosine_[angle] - x[j * reach] * sine_[angle];
                        }
                        put(t, q, a, b);
                    }
                }
            }
        }
        std::swap(re, re_);
        std::swap(im, im_);
        stride *= radix;
    }
}

BandFactors::BandFactors(const AirPlane& plane, BedPressure bed)
    : plane_(plane),
      band_(static_cast<std::size_t>(2 * (plane.nz - 1) + 2)),
      count_(static_cast<std::size_t>(plane.nx) * static_cast<std::size_t>(plane.nz - 1)),
      matrix_(count_ * (2 * band_ + 1)),
      right_(count_) {
    for (int i = 0; i < plane.nx; ++i) {
        for (int k = 1; k < plane.nz; ++k) {
            const std::size_t row = unknown(i, k);
            if (k <= plane.under_bed[static_cast<std::size_t>(i)]) {
                column(row)[band_] = 1.0;
                continue;
            }
            for (const PressureTerm& term : pressure_equation(plane, bed, i, k)) {
                const std::size_t j = unknown(term.i, term.k);
                column(j)[row + band_ - j] += term.weight;
            }
        }
    }
    column(unknown(0, plane.under_bed.front() + 1))[band_] += 1.0;  // pins the pressure
    factorise();
}

std::size_t BandFactors::unknown(int i, int k) const {
    const int place = 2 * i < plane_.nx ? 2 * i : 2 * (plane_.nx - i) - 1;
    return static_cast<std::size_t>(place) * static_cast<std::size_t>(plane_.nz - 1) +
           static_cast<std::size_t>(k - 1);
}

void BandFactors::factorise() {
    for (std::size_t j = 0; j < count_; ++j) {
        const std::size_t below = std::min(band_, count_ - 1 - j);
        double* lower = column(j) + band_ + 1;
        const double pivot = column(j)[band_];
        for (std::size_t i = 0; i < below; ++i) lower[i] /= pivot;
        for (std::size_t c = 1; c <= below; ++c) {
            double* other = column(j + c) + band_ - c;
            const double upper = *other;
            if (upper == 0.0) continue;
            for (std::size_t i = 0; i < below; ++i) other[1 + i] -= lower[i] * upper;
        }
    }
}

void BandFactors::solve(std::vector<double>& values) {
    const auto each = [&](const auto& body) {
        for (int i = 0; i < plane_.nx; ++i) {
            for (int k = 1; k < plane_.nz; ++k) body(values[plane_.at(i, k)], unknown(i, k));
        }
    };
    each([&](double value, std::size_t at) { right_[at] = value; });
    for (std::size_t j = 0; j < count_; ++j) {
        const double* lower = column(j) + band_ + 1;
        const std::size_t below = std::min(band_, count_ - 1 - j);
        for (std::size_t i = 0; i < below; ++i) right_[j + 1 + i] -= lower[i] * right_[j];
    }
    for (std::size_t j = count_; j-- > 0;) {
        right_[j] /= column(j)[band_];
        const std::size_t above = std::min(band_, j);
        const double* upper = column(j) + band_ - above;
        for (std::size_t i = 0; i < above; ++i) right_[j - above + i] -= upper[i] * right_[j];
    }
    each([&](double& value, std::size_t at) { value = right_[at]; });
}

Air::Air(const AirPlane& plane, const AirflowParameters& parameters, Pressures pressures)
    : plane_(plane),
      parameters_(parameters),
      near_bed_(*std::max_element(plane.under_bed.begin(), plane.under_bed.end()) + 3),
      fourier_(plane.nx),
      u_(plane.at(plane.nx, 0)),
      row_re_(static_cast<std::size_t>(plane.nx)),
      row_im_(row_re_) {
    w_ = p_ = b_ = solution_ = source_re_ = source_im_ = solved_re_ = solved_im_ = u_;
    const int nz = plane_.nz;
    const double above_bed = nz * plane.spacing - plane.largest_height;
    for (int i = 0; i < plane.nx; ++i) {
        for (int k = lowest(i); k <= nz; ++k) {
            const double above = k * plane.spacing - plane.largest_height;
            u_[at(i, k)] = std::max(0.0, parameters.lid_speed * above / above_bed);
        }
        u_[at(i, nz)] = parameters.lid_speed;
    }
    predicted_u_ = u_;
    predicted_w_ = w_;
    if (pressures == Pressures::by_factors) {
        factors_ = std::make_unique<BandFactors>(plane, parameters.bed_pressure);
        for (int i = 0; i < plane.nx; ++i) {
            for (int k = lowest(i); k < nz; ++k) b_[at(i, k)] = 1.0;
        }
        solve();
        of_constant_ = solution_;
        return;
    }
    inverse_pivots_ = u_;
    for (int m = 0; m <= plane.nx / 2; ++m) {
        const double diagonal = -4.0 + 2.0 * std::cos(2.0 * std::numbers::pi * m / plane.nx);
        double inverse = 0.0;
        for (int k = 1; k < nz; ++k) {
            inverse = 1.0 / (diagonal + (k + 1 == nz ? 1.0 : 0.0) - inverse);
            inverse_pivots_[at(m, k)] = inverse;
        }
    }
    invert_departures();
}

/// As AirPoisson does.
void Air::invert_departures() {
    for (int i = 0; i < plane_.nx; ++i) {
        const int k = lowest(i);
        std::vector<Term> terms;
        for (const PressureTerm& term : pressure_equation(plane_, parameters_.bed_pressure, i, k))
            terms.push_back({term.i, term.k, term.weight});
        terms.push_back({i, k, 4.0});
        terms.push_back({plane_.left(i), k, -1.0});
        terms.push_back({plane_.right(i), k, -1.0});
        if (k > 1) terms.push_back({i, k - 1, -1.0});
        terms.push_back({i, k + 1, -1.0});
        departures_.push_back(terms);
    }
    departures_.front().push_back({0, lowest(0), 1.0});
    const auto count = static_cast<std::size_t>(plane_.nx);
    std::vector<double> capacitance(count * count, 0.0);  // by columns
    for (std::size_t i = 0; i < count; ++i) capacitance[i * count + i] = 1.0;
    for (int source = 0; source < plane_.nx; ++source) {
        std::fill(b_.begin(), b_.end(), 0.0);
        std::fill(solution_.begin(), solution_.end(), 0.0);
        std::fill(solved_re_.begin(), solved_re_.end(), 0.0);
        std::fill(solved_im_.begin(), solved_im_.end(), 0.0);
        b_[at(source, lowest(source))] = 1.0;
        add_rectangle(near_bed_);
        transform_rows(solution_, near_bed_, true);
        for (int i = 0; i < plane_.nx; ++i) {
            for (const Term& term : departures_[static_cast<std::size_t>(i)]) {
                capacitance[static_cast<std::size_t>(source) * count +
                            static_cast<std::size_t>(i)] +=
                    term.weight * solution_[at(term.i, term.k)];
            }
        }
    }
    inverse_ = inverse_of(std::move(capacitance), count);
    std::fill(b_.begin(), b_.end(), 1.0);
    for (int i = 0; i < plane_.nx; ++i) {
        for (int k = 0; k < lowest(i); ++k) b_[at(i, k)] = 0.0;
    }
    solve();
    of_constant_ = solution_;
}

/// Two rows as one complex one: of `values` into the modes of the source, or back.
void Air::transform_rows(std::vector<double>& values, int rows, bool back) {
    const int nx = plane_.nx;
    for (int k = 1; k < std::min(rows, plane_.nz); k += 2) {
        const int other = k + 1;  // the lid's row holds nothing
        if (!back) {
            for (int i = 0; i < nx; ++i) {
                row_re_[static_cast<std::size_t>(i)] = values[at(i, k)];
                row_im_[static_cast<std::size_t>(i)] = other < plane_.nz ? values[at(i, other)] : 0;
            }
            fourier_.transform(row_re_, row_im_);
            for (int m = 0; m <= nx / 2; ++m) {
                const auto here = static_cast<std::size_t>(m);
                const auto there = static_cast<std::size_t>(m == 0 ? 0 : nx - m);
                source_re_[at(m, k)] = 0.5 * (row_re_[here] + row_re_[there]);
                source_im_[at(m, k)] = 0.5 * (row_im_[here] - row_im_[there]);
                source_re_[at(m, other)] = 0.5 * (row_im_[here] + row_im_[there]);
                source_im_[at(m, other)] = 0.5 * (row_re_[there] - row_re_[here]);
            }
            continue;
        }
        for (int m = 0; m <= nx / 2;
             ++m) {  // i times the conjugate, whose transform is the inverse
            const auto here = static_cast<std::size_t>(m);
            const auto there = static_cast<std::size_t>(m == 0 ? 0 : nx - m);
            row_im_[there] = solved_re_[at(m, k)] + solved_im_[at(m, other)];
            row_re_[there] = solved_re_[at(m, other)] - solved_im_[at(m, k)];
            row_im_[here] = solved_re_[at(m, k)] - solved_im_[at(m, other)];
            row_re_[here] = solved_re_[at(m, other)] + solved_im_[at(m, k)];
        }
        fourier_.transform(row_re_, row_im_);
        for (int i = 0; i < nx; ++i) {
            values[at(i, k)] = row_im_[static_cast<std::size_t>(i)];
            if (other < plane_.nz) values[at(i, other)] = row_re_[static_cast<std::size_t>(i)];
        }
    }
}

/// Adds the rectangle's solution for b_, which is 0 from that row on, to the modes solved.
void Air::add_rectangle(int rows_of_source) {
    const int nz = plane_.nz;
    const int filled = std::min(rows_of_source + rows_of_source % 2 + 1, nz);
    transform_rows(b_, filled, false);
    std::vector<double> re(static_cast<std::size_t>(nz) + 1);
    std::vector<double> im(re);
    for (int m = 0; m <= plane_.nx / 2; ++m) {
        const double* inverse = &inverse_pivots_[at(m, 0)];
        const double* source_re = &source_re_[at(m, 0)];
        const double* source_im = &source_im_[at(m, 0)];
        double last_re = 0.0;
        double last_im = 0.0;
        for (int k = 1; k < nz; ++k) {
            last_re = ((k < filled ? source_re[k] / plane_.nx : 0.0) - last_re) * inverse[k];
            last_im = ((k < filled ? source_im[k] / plane_.nx : 0.0) - last_im) * inverse[k];
            re[static_cast<std::size_t>(k)] = last_re;
            im[static_cast<std::size_t>(k)] = last_im;
        }
        last_re = last_im = 0.0;
        for (int k = nz - 1; k > 0; --k) {
            last_re = re[static_cast<std::size_t>(k)] - inverse[k] * last_re;
            last_im = im[static_cast<std::size_t>(k)] - inverse[k] * last_im;
            solved_re_[at(m, k)] += last_re;
            solved_im_[at(m, k)] += last_im;
        }
    }
}

/// The pressures for b_, pinned at the first column's lowest air node: into solution_.
void Air::solve() {
    if (!factors_) {
        solve_by_fourier();
        return;
    }
    std::copy(b_.begin(), b_.end(), solution_.begin());
    factors_->solve(solution_);
}

void Air::solve_by_fourier() {
    std::fill(solved_re_.begin(), solved_re_.end(), 0.0);
    std::fill(solved_im_.begin(), solved_im_.end(), 0.0);
    add_rectangle(plane_.nz);
    transform_rows(solution_, near_bed_ + 1, true);
    const auto nx = static_cast<std::size_t>(plane_.nx);
    std::vector<double> departing(nx, 0.0);
    std::vector<double> strengths(nx, 0.0);
    for (std::size_t i = 0; i < nx; ++i) {
        for (const Term& term : departures_[i])
            departing[i] += term.weight * solution_[at(term.i, term.k)];
    }
    for (std::size_t j = 0; j < nx; ++j) {
        for (std::size_t i = 0; i < nx; ++i) strengths[i] += inverse_[j * nx + i] * departing[j];
    }
    std::fill(b_.begin(), b_.end(), 0.0);
    for (int i = 0; i < plane_.nx; ++i)
        b_[at(i, lowest(i))] = -strengths[static_cast<std::size_t>(i)];
    add_rectangle(near_bed_);
    transform_rows(solution_, plane_.nz, true);
}

void Air::step() {
    const int nz = plane_.nz;
    const double spacing = plane_.spacing;
    const double dt = parameters_.time_step;
    const double density = parameters_.density;
    const double courant = dt / spacing;
    const double diffusion = parameters_.viscosity * dt / (spacing * spacing);
    const auto predict = [&](const std::vector<double>& v, std::vector<double>& out) {
        for (int i = 0; i < plane_.nx; ++i) {
            const double* left = &v[at(plane_.left(i), 0)];
            const double* here = &v[at(i, 0)];
            const double* right = &v[at(plane_.right(i), 0)];
            const double* u = &u_[at(i, 0)];
            const double* w = &w_[at(i, 0)];
            double* to = &out[at(i, 0)];
            for (int k = lowest(i); k < nz; ++k) {
                const double centre = here[k];
                const double toward = u[k] > 0.0 ? centre - left[k] : right[k] - centre;
                const double upward = w[k] > 0.0 ? centre - here[k - 1] : here[k + 1] - centre;
                const double around = left[k] + right[k] + here[k - 1] + here[k + 1] - 4.0 * centre;
                to[k] = centre + (diffusion * around - courant * (u[k] * toward + w[k] * upward));
            }
        }
    };
    predict(u_, predicted_u_);
    predict(w_, predicted_w_);
    const double factor = 0.5 * density * spacing / dt;
    const double at_lid = 2.0 * density * parameters_.viscosity / spacing;
    for (int i = 0; i < plane_.nx; ++i) {
        const double* left = &predicted_u_[at(plane_.left(i), 0)];
        const double* right = &predicted_u_[at(plane_.right(i), 0)];
        const double* w = &predicted_w_[at(i, 0)];
        for (int k = 0; k < lowest(i); ++k) b_[at(i, k)] = 0.0;
        for (int k = lowest(i); k < nz; ++k)
            b_[at(i, k)] = factor * (right[k] - left[k] + w[k + 1] - w[k - 1]);
        b_[at(i, nz - 1)] -= at_lid * w[nz - 1];
    }
    solve();
    const std::size_t pinned = at(0, lowest(0));
    const double constant = solution_[pinned] / of_constant_[pinned];
    for (int i = 0; i < plane_.nx; ++i) {
        for (int k = lowest(i); k < nz; ++k)
            p_[at(i, k)] = solution_[at(i, k)] - constant * of_constant_[at(i, k)];
        p_[at(i, nz)] = p_[at(i, nz - 1)] + at_lid * predicted_w_[at(i, nz - 1)];
        const double* p = &p_[at(i, lowest(i))];
        p_[at(i, lowest(i) - 1)] =
            parameters_.bed_pressure == BedPressure::one_sided ? p[0] : 2.0 * p[0] - p[1];
    }
    const double by = dt / (2.0 * density * spacing);
    for (int i = 0; i < plane_.nx; ++i) {
        const double* left = &p_[at(plane_.left(i), 0)];
        const double* here = &p_[at(i, 0)];
        const double* right = &p_[at(plane_.right(i), 0)];
        for (int k = lowest(i); k < nz; ++k) {
            u_[at(i, k)] = predicted_u_[at(i, k)] - by * (right[k] - left[k]);
            w_[at(i, k)] = predicted_w_[at(i, k)] - by * (here[k + 1] - here[k - 1]);
        }
    }
}

}  // namespace fumon::plain
