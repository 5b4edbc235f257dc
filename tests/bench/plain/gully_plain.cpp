#include "plain/gully_plain.h"

#include <algorithm>
#include <cmath>

#include "base/elementary.h"

namespace fumon::plain {

namespace {

constexpr double dx = 1.0;
constexpr double dy = 1.0;

/// Solves (1 − r δ²) a = b along a periodic line whose cells lie `stride` apart, in place, as
/// DiffusionLine does.
struct PeriodicLine {
    PeriodicLine(int n, double r) : r_(r), inverse_(static_cast<std::size_t>(n)) {
        const double middle = 1.0 + 2.0 * r;
        const double choice = -middle;
        double previous = 0.0;
        for (std::size_t i = 0; i < inverse_.size(); ++i) {
            double diagonal = middle;
            if (i == 0) diagonal = middle - choice;
            if (i + 1 == inverse_.size()) diagonal = middle - r * r / choice;
            inverse_[i] = 1.0 / (diagonal - (i == 0 ? 0.0 : r * r * previous));
            previous = inverse_[i];
        }
        closing_.assign(inverse_.size(), 0.0);
        closing_.front() = choice;
        closing_.back() = -r;
        sweep_row(closing_.data());
        end_ = -r / choice;
        weight_ = 1.0 / (1.0 + closing_.front() + end_ * closing_.back());
    }

    void sweep_row(double* line) const {
        const auto n = static_cast<int>(inverse_.size());
        double last = 0.0;
        for (int i = 0; i < n; ++i) {
            last = (line[i] + r_ * last) * inverse_[static_cast<std::size_t>(i)];
            line[i] = last;
        }
        for (int i = n - 2; i >= 0; --i) {
            last = line[i] + r_ * inverse_[static_cast<std::size_t>(i)] * last;
            line[i] = last;
        }
    }

    void solve_row(double* line) const {
        sweep_row(line);
        const double factor = weight_ * (line[0] + end_ * line[inverse_.size() - 1]);
        for (std::size_t i = 0; i < inverse_.size(); ++i) line[i] += -factor * closing_[i];
    }

    void solve_columns(Grid& z) const {
        const int n = z.ny();
        const auto inverse = [this](int y) { return inverse_[static_cast<std::size_t>(y)]; };
        for (int x = 0; x < n; ++x) z(x, 0) *= inverse(0);
        for (int y = 1; y < n; ++y) {
            for (int x = 0; x < n; ++x) z(x, y) = (z(x, y) + r_ * z(x, y - 1)) * inverse(y);
        }
        for (int y = n - 2; y >= 0; --y) {
            for (int x = 0; x < n; ++x) z(x, y) += r_ * inverse(y) * z(x, y + 1);
        }
        std::vector<double> factors(static_cast<std::size_t>(n));
        for (int x = 0; x < n; ++x)
            factors[static_cast<std::size_t>(x)] = weight_ * (z(x, 0) + end_ * z(x, n - 1));
        for (int y = 0; y < n; ++y) {
            const double closing = -closing_[static_cast<std::size_t>(y)];
            for (int x = 0; x < n; ++x) z(x, y) += closing * factors[static_cast<std::size_t>(x)];
        }
    }

  private:
    double r_;
    std::vector<double> inverse_;
    std::vector<double> closing_;
    double end_;
    double weight_;
};

/// What passes a face between cells of depths here | next, in units of a cell's water.
double through_face(double before, double here, double next, double after, double shift) {
    const double rise = next - here;
    double upwind = here;
    double behind = here - before;
    double reach = 1.0 - shift;
    if (!(shift > 0.0)) {
        upwind = next;
        behind = after - next;
        reach = -1.0 - shift;
    }
    double limited = 0.0;
    if (behind * rise > 0.0) {
        const double twice = behind * behind < rise * rise ? 2.0 * behind : 2.0 * rise;
        const double middle = 0.5 * (behind + rise);
        limited = twice * twice < middle * middle ? twice : middle;
    }
    return shift * (upwind + 0.5 * reach * limited);
}

double gradient_at_start(double low, double high) {
    return 0.5 * (high - low);
}

}  // namespace

Gully::Gully(const GullyParameters& parameters, Grid bed)
    : parameters_(parameters), n_(bed.nx()), slope_(0.04), z_(std::move(bed)), h_(n_, n_) {
    for (double& depth : h_.values()) depth = parameters_.depth;
    const double speed = std::sqrt(parameters_.gravity * parameters_.depth * slope_ /
                                   parameters_.friction_coefficient);
    u_ = next_h_ = next_u_ = next_v_ = next_ux_ = next_uy_ = next_vx_ = next_vy_ = Grid(n_, n_);
    ux_ = uy_ = vx_ = vy_ = gained_u_ = gained_v_ = east_ = north_ = half_way_ = u_;
    v_ = Grid(n_, n_, -speed);
    for (int y = 0; y < n_; ++y) {
        for (int x = 0; x < n_; ++x) {
            ux_(x, y) = gradient_at_start(u_(before(x), y), u_(after(x), y));
            uy_(x, y) = gradient_at_start(u_(x, before(y)), u_(x, after(y)));
            vx_(x, y) = gradient_at_start(v_(before(x), y), v_(after(x), y));
            vy_(x, y) = gradient_at_start(v_(x, before(y)), v_(x, after(y)));
        }
    }
}

void Gully::step() {
    double remaining = parameters_.time_step;
    while (remaining > 0.0) {
        const double limit = parameters_.courant_number / courant_rate();
        const double pieces = std::ceil(remaining / limit * (1.0 - 1e-12));
        const double dt = pieces <= 1.0 ? remaining : remaining / pieces;
        advect_and_accelerate(dt);
        turn(dt, gained_u_, next_ux_, next_uy_);
        turn(dt, gained_v_, next_vx_, next_vy_);
        transport_depth(dt);
        std::swap(h_, next_h_);
        std::swap(u_, next_u_);
        std::swap(v_, next_v_);
        std::swap(ux_, next_ux_);
        std::swap(uy_, next_uy_);
        std::swap(vx_, next_vx_);
        std::swap(vy_, next_vy_);
        incise(dt);
        diffuse(dt);
        remaining = dt == remaining ? 0.0 : remaining - dt;
    }
}

double Gully::courant_rate() const {
    double largest = 0.0;
    for (std::size_t i = 0; i < h_.size(); ++i) {
        const double rate = 1.0 / dx * std::fabs(u_.values()[i]) +
                            1.0 / dy * std::fabs(v_.values()[i]) +
                            (1.0 / dx + 1.0 / dy) * std::sqrt(parameters_.gravity * h_.values()[i]);
        largest = std::max(largest, rate);
    }
    return largest;
}

void Gully::advect_and_accelerate(double dt) {
    const double push_x = -0.5 * dt * parameters_.gravity / dx;
    const double push_y = -0.5 * dt * parameters_.gravity / dy;
    const double pull = dt * (-parameters_.gravity * slope_);
    const double drag = dt * parameters_.friction_coefficient;
    for (int y = 0; y < n_; ++y) {
        const int ys = before(y);
        const int yn = after(y);
        for (int x = 0; x < n_; ++x) {
            const int xw = before(x);
            const int xe = after(x);
            const double sx = u_(x, y) > 0.0 ? -1.0 : 1.0;
            const double sy = v_(x, y) > 0.0 ? -1.0 : 1.0;
            const int ix = u_(x, y) > 0.0 ? xw : xe;  // where the water comes from
            const int iy = v_(x, y) > 0.0 ? ys : yn;
            const double a = -sx * u_(x, y) * (dt / dx);
            const double b = -sy * v_(x, y) * (dt / dy);
            const auto advected = [&](const Grid& f, const Grid& fx, const Grid& fy) {
                const double f0 = f(x, y);
                const double f1 = f(ix, y);
                const double f2 = f(x, iy);
                const double f3 = f(ix, iy);
                const double p0 = sx * fx(x, y);
                const double p1 = sx * fx(ix, y);
                const double p2 = sx * fx(x, iy);
                const double q0 = sy * fy(x, y);
                const double q1 = sy * fy(ix, y);
                const double q2 = sy * fy(x, iy);
                const double c30 = p0 + p1 - 2.0 * (f1 - f0);
                const double c20 = 3.0 * (f1 - f0) - 2.0 * p0 - p1;
                const double c03 = q0 + q2 - 2.0 * (f2 - f0);
                const double c02 = 3.0 * (f2 - f0) - 2.0 * q0 - q2;
                const double twist = (f3 - f1) - (f2 - f0);
                const double c12 = twist - (q1 - q0);
                const double c21 = twist - (p2 - p0);
                const double c11 = (q1 - q0) - c21;
                return Carried{f0 + a * (p0 + a * (c20 + a * c30) + b * (c11 + a * c21 + b * c12)) +
                                   b * (q0 + b * (c02 + b * c03)),
                               sx * (p0 + a * (2.0 * c20 + 3.0 * a * c30) +
                                     b * (c11 + 2.0 * a * c21 + b * c12)),
                               sy * (q0 + b * (2.0 * c02 + 3.0 * b * c03) +
                                     a * (c11 + a * c21 + 2.0 * b * c12))};
            };
            const Carried u = advected(u_, ux_, uy_);
            const Carried v = advected(v_, vx_, vy_);
            next_ux_(x, y) = u.gradient_x;
            next_uy_(x, y) = u.gradient_y;
            next_vx_(x, y) = v.gradient_x;
            next_vy_(x, y) = v.gradient_y;
            const double free_u =
                u.value + push_x * ((h_(xe, y) - h_(xw, y)) + (z_(xe, y) - z_(xw, y)));
            const double free_v =
                v.value + pull + push_y * ((h_(x, yn) - h_(x, ys)) + (z_(x, yn) - z_(x, ys)));
            const double speed = std::sqrt(u.value * u.value + v.value * v.value);
            const double h = h_(x, y);
            const double kept = h > 1e-10 ? h / (h + drag * speed) : 0.0;
            next_u_(x, y) = kept * free_u;
            next_v_(x, y) = kept * free_v;
            gained_u_(x, y) = next_u_(x, y) - u.value;
            gained_v_(x, y) = next_v_(x, y) - v.value;
        }
    }
}

void Gully::turn(double dt, const Grid& gained, Grid& gradient_x, Grid& gradient_y) const {
    const double half_x = 0.5 * dt / dx;
    const double half_y = 0.5 * dt / dy;
    for (int y = 0; y < n_; ++y) {
        const int ys = before(y);
        const int yn = after(y);
        for (int x = 0; x < n_; ++x) {
            const int xw = before(x);
            const int xe = after(x);
            const double along = half_x * gradient_x(x, y);
            const double across = half_y * gradient_y(x, y);
            gradient_x(x, y) +=
                0.5 * (gained(xe, y) - gained(xw, y)) -
                ((u_(xe, y) - u_(xw, y)) * along + (v_(xe, y) - v_(xw, y)) * across);
            gradient_y(x, y) +=
                0.5 * (gained(x, yn) - gained(x, ys)) -
                ((u_(x, yn) - u_(x, ys)) * along + (v_(x, yn) - v_(x, ys)) * across);
        }
    }
}

/// Cells that would give more than they have do not occur in what is measured.
void Gully::transport_depth(double dt) {
    for (int y = 0; y < n_; ++y) {
        const int yn = after(y);
        for (int x = 0; x < n_; ++x) {
            const int xe = after(x);
            const double shift_x = 0.5 * (dt / dx) * (next_u_(x, y) + next_u_(xe, y));
            const double shift_y = 0.5 * (dt / dy) * (next_v_(x, y) + next_v_(x, yn));
            east_(x, y) =
                through_face(h_(before(x), y), h_(x, y), h_(xe, y), h_(after(xe), y), shift_x);
            north_(x, y) =
                through_face(h_(x, before(y)), h_(x, y), h_(x, yn), h_(x, after(yn)), shift_y);
        }
    }
    for (int y = 0; y < n_; ++y) {
        for (int x = 0; x < n_; ++x) {
            next_h_(x, y) = h_(x, y) + ((east_(before(x), y) - east_(x, y)) +
                                        (north_(x, before(y)) - north_(x, y)));
        }
    }
}

/// The first half of the diffusion takes the transport as its source: into half_way_.
void Gully::incise(double dt) {
    const double r = 0.5 * dt * parameters_.bed_diffusion.value / (dy * dy);
    for (int y = 0; y < n_; ++y) {
        const int ys = before(y);
        const int yn = after(y);
        for (int x = 0; x < n_; ++x) {
            const double slope_x = (z_(after(x), y) - z_(before(x), y)) * (0.5 / dx);
            const double slope_y = slope_ + (z_(x, yn) - z_(x, ys)) * (0.5 / dy);
            const double steepness = slope_x * slope_x + slope_y * slope_y;
            const double speed = u_(x, y) * u_(x, y) + v_(x, y) * v_(x, y);
            double stress = 0.0;
            if (speed > 1e-300) {
                const double power = elementary::exp(
                    0.5 * parameters_.velocity_exponent * elementary::log_of_normal(speed) +
                    0.5 * parameters_.slope_exponent *
                        elementary::log_of_normal(steepness > 1e-300 ? steepness : 1e-300));
                stress = parameters_.stress_factor * power - parameters_.critical_stress;
                stress = stress > 0.0 ? stress : 0.0;
            }
            const double change = -dt * (parameters_.transport_factor.value * stress);
            const double here = z_(x, y);
            half_way_(x, y) = here + change + r * ((z_(x, ys) - here) + (z_(x, yn) - here));
        }
    }
}

void Gully::diffuse(double dt) {
    const double r_x = 0.5 * dt * parameters_.bed_diffusion.value / (dx * dx);
    const double r_y = 0.5 * dt * parameters_.bed_diffusion.value / (dy * dy);
    const PeriodicLine along_x(n_, r_x);
    const PeriodicLine along_y(n_, r_y);
    for (int y = 0; y < n_; ++y) {
        along_x.solve_row(half_way_.row(y).data());
        for (int x = 0; x < n_; ++x) {
            const double here = half_way_(x, y);
            z_(x, y) =
                here + r_x * ((half_way_(before(x), y) - here) + (half_way_(after(x), y) - here));
        }
    }
    along_y.solve_columns(z_);
}

}  // namespace fumon::plain
