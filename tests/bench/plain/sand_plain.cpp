#include "plain/sand_plain.h"

#include <algorithm>
#include <utility>

#include "base/elementary.h"
#include "base/random.h"

namespace fumon::plain {

Sand::Sand(const SandParameters& parameters, Grid bed, std::uint64_t seed, Draw draw)
    : parameters_(parameters),
      nx_(bed.nx()),
      ny_(bed.ny()),
      seed_(seed),
      draw_(draw),
      random_(seed),
      bed_(std::move(bed)),
      next_(nx_, ny_),
      lengths_(static_cast<std::size_t>(nx_)),
      amounts_(static_cast<std::size_t>(nx_)) {}

void Sand::step() {
    if (parameters_.order == HopOrder::synchronous) {
        hop_all_at_once();
    } else if (draw_ == Draw::row_by_row) {
        hop_row_by_row();
    } else {
        hop_over_whole_grid();
    }
    switch (parameters_.creep) {
        case Creep::every_cell:
            creep_every_cell();
            break;
        case Creep::maxima_only:
            creep_maxima();
            break;
        case Creep::profile:
            creep_profile();
            break;
        case Creep::none:
            break;
    }
    ++steps_;
}

/// Linear hops to the nearest cell, those of slopes, and exponential ones.
void Sand::hop_all_at_once() {
    const SandParameters& p = parameters_;
    const double rate = elementary::log(p.exponential_base) * 2.0 * p.exponential_height;
    const double scale = p.exponential_length / 10.0 / (elementary::exp(rate) - 1.0);
    for (int y = 0; y < ny_; ++y) {
        const double* h = bed_.row(y).data();
        double* row = next_.row(y).data();
        int* length = lengths_.data();
        double* amount = amounts_.data();
        switch (p.hop_length) {
            case HopLength::linear:
                for (int x = 0; x < nx_; ++x) {
                    length[x] = static_cast<int>(p.hop_base + p.hop_per_height * h[x] + 0.5);
                    amount[x] = std::min(p.amount, std::max(h[x], 0.0));
                    row[x] = h[x] - amount[x];
                }
                break;
            case HopLength::slope:
                for (int x = 0; x < nx_; ++x) {
                    const double west = h[(x + nx_ - 1) % nx_];
                    const double east = h[(x + 1) % nx_];
                    const double slope = elementary::tanh(0.5 * (east - west));
                    length[x] = static_cast<int>(p.hop_base - p.hop_slope_factor * slope);
                    amount[x] = std::min(std::max(p.amount + p.amount_slope_factor * slope, 0.0),
                                         std::max(h[x], 0.0));
                    row[x] = h[x] - amount[x];
                }
                break;
            default:
                for (int x = 0; x < nx_; ++x) {
                    const double reach = scale * (elementary::exp(rate * h[x]) - 1.0) + 0.5;
                    length[x] = static_cast<int>(reach);
                    amount[x] = std::min(p.amount, std::max(h[x], 0.0));
                    row[x] = h[x] - amount[x];
                }
                break;
        }
        land(row);
    }
    std::swap(bed_, next_);
}

void Sand::land(double* row) const {
    for (int x = 0; x < nx_; ++x) {
        const int to = x + lengths_[static_cast<std::size_t>(x)];
        row[to % nx_] += amounts_[static_cast<std::size_t>(x)];
    }
}

/// A linear hop that carries q0, if there is sand.
void Sand::hop(double* row, int x) const {
    const SandParameters& p = parameters_;
    if (!(row[x] > 0.0)) return;
    const int to = x + static_cast<int>(p.hop_base + p.hop_per_height * row[x]);
    row[x] -= p.amount;
    row[to % nx_] += p.amount;
}

void Sand::hop_over_whole_grid() {
    std::uniform_int_distribution<int> column(0, nx_ - 1);
    std::uniform_int_distribution<int> line(0, ny_ - 1);
    for (std::size_t k = 0; k < bed_.size(); ++k)
        hop(bed_.row(line(random_)).data(), column(random_));
}

void Sand::hop_row_by_row() {
    std::vector<std::int64_t> picks(static_cast<std::size_t>(ny_));
    RandomStream of_rows(seed_, 0, steps_, Purpose::picks_per_row);
    multinomial_equal(of_rows, static_cast<std::int64_t>(bed_.size()), picks);
    const auto nx = static_cast<std::uint32_t>(nx_);
    const std::uint32_t biased = (0U - nx) % nx;
    std::vector<std::uint32_t> words;
    for (int y = 0; y < ny_; ++y) {
        double* row = bed_.row(y).data();
        RandomStream stream(seed_, static_cast<std::uint32_t>(y), steps_, Purpose::picks);
        words.resize(static_cast<std::size_t>(picks[static_cast<std::size_t>(y)]));
        for (std::uint32_t& word : words) word = stream.next32();
        for (const std::uint32_t word : words) {
            std::uint64_t product = static_cast<std::uint64_t>(word) * nx;
            while (static_cast<std::uint32_t>(product) < biased)
                product = static_cast<std::uint64_t>(stream.next32()) * nx;
            hop(row, static_cast<int>(product >> 32));
        }
    }
}

void Sand::creep_every_cell() {
    const double rate = parameters_.creep_rate;
    for (int y = 0; y < ny_; ++y) {
        const double* s = bed_.row((y + ny_ - 1) % ny_).data();
        const double* h = bed_.row(y).data();
        const double* n = bed_.row((y + 1) % ny_).data();
        double* out = next_.row(y).data();
        for (int x = 0; x < nx_; ++x) {
            const int w = (x + nx_ - 1) % nx_;
            const int e = (x + 1) % nx_;
            const double nearest = (h[w] + h[e]) + (s[x] + n[x]);
            const double diagonal = (s[w] + n[w]) + (s[e] + n[e]);
            out[x] = h[x] + rate * ((1.0 / 6.0) * nearest + (1.0 / 12.0) * diagonal - h[x]);
        }
    }
    std::swap(bed_, next_);
}

void Sand::creep_maxima() {
    const double rate = parameters_.creep_rate;
    for (int y = 0; y < ny_; ++y) {
        double* s = bed_.row((y + ny_ - 1) % ny_).data();
        double* h = bed_.row(y).data();
        double* n = bed_.row((y + 1) % ny_).data();
        for (int x = 0; x < nx_; ++x) {
            const int w = (x + nx_ - 1) % nx_;
            const int e = (x + 1) % nx_;
            const double here = h[x];
            if (!(here > h[w] && here > h[e] && here > s[x] && here > n[x] && here > s[w] &&
                  here > n[w] && here > s[e] && here > n[e])) {
                continue;
            }
            const double given = rate * here * 0.25;
            for (double* side : {h + w, h + e, s + x, n + x}) *side += given * (2.0 / 3.0);
            for (double* corner : {s + w, n + w, s + e, n + e}) *corner += given * (1.0 / 3.0);
            h[x] -= rate * here;
        }
    }
}

void Sand::creep_profile() {
    const double creep = parameters_.creep_rate;
    const double flank = parameters_.flank_rate;
    double* row = bed_.row(0).data();
    for (int x = 0; x < nx_; ++x) {
        double& left = row[(x + nx_ - 1) % nx_];
        double& right = row[(x + 1) % nx_];
        const double here = row[x];
        if (here > left && here > right) {
            left += creep * here * 0.5;
            right += creep * here * 0.5;
            row[x] -= creep * here;
        } else if (here > left) {
            left += flank * here;
            row[x] -= flank * here;
        } else if (here > right) {
            right += flank * here;
            row[x] -= flank * here;
        }
    }
}

}  // namespace fumon::plain
