#include "models/sand/profile_creep.h"

#include <algorithm>
#include <cstddef>
#include <vector>

#include "base/worker_pool.h"

namespace fumon {

namespace {

struct Rates {
    double creep;
    double flank;
};

/// What a sweep carries from site to site: the site it comes from and the one it stands on.
struct Carried {
    double left;
    double here;
    friend bool operator==(const Carried&, const Carried&) = default;
};

/// One site gives; returns the height that the right neighbour has then.
inline double visit(const Rates& rates, Carried& carried, double right) {
    const double here = carried.here;
    if (here > carried.left) {
        if (here > right) {
            const double given = rates.creep * here;
            carried.left += given * 0.5;
            carried.here = here - given;
            return right + given * 0.5;
        }
        const double given = rates.flank * here;
        carried.left += given;
        carried.here = here - given;
    } else if (here > right) {
        const double given = rates.flank * here;
        carried.here = here - given;
        return right + given;
    }
    return right;
}

/// Sites [begin, end) of a sweep that comes to `begin` with `start`. Writes the sites
/// begin … end − 2 and the gift to begin − 1, and carries `stop` to `end`.
struct Part {
    int begin = 0;
    int end = 0;
    Carried start{};
    Carried stop{};
    double before_begin = 0.0;  ///< height of site begin − 1 when this part has passed

    /// Replaces a start that was guessed: sweeps again until the guess would have carried the same.
    void start_again(const Carried& found, const double* before, const Rates& rates,
                     double* after) {
        Carried guessed = start;
        Carried carried = found;
        start = found;
        for (int x = begin; x < end; ++x) {
            if (carried == guessed) return;
            const double right = before[x + 1];
            const double next_guessed = visit(rates, guessed, right);
            const double next = visit(rates, carried, right);
            (x == begin ? before_begin : after[x - 1]) = carried.left;
            guessed = {guessed.here, next_guessed};
            carried = {carried.here, next};
        }
        stop = carried;
    }
};

/// The sites of two parts in turn: those of one alone would each wait for the one before it.
void sweep_both(Part& one, Part& other, const double* before, const Rates& rates, double* after) {
    struct Sweep {
        Part& part;
        int x;
        Carried carried;
    };
    Sweep a{one, one.begin, one.start};
    Sweep b{other, other.begin, other.start};
    const auto visit_next = [&](Sweep& sweep, double& left) {
        const double next = visit(rates, sweep.carried, before[sweep.x + 1]);
        left = sweep.carried.left;
        sweep.carried = {sweep.carried.here, next};
        ++sweep.x;
    };
    const auto visit_next_site = [&](Sweep& sweep) { visit_next(sweep, after[sweep.x - 1]); };
    for (Sweep* sweep : {&a, &b}) {
        if (sweep->x < sweep->part.end) visit_next(*sweep, sweep->part.before_begin);
    }
    const int together = std::min(one.end - a.x, other.end - b.x);
    for (int k = 0; k < together; ++k) {
        visit_next_site(a);
        visit_next_site(b);
    }
    for (Sweep* sweep : {&a, &b}) {
        while (sweep->x < sweep->part.end) visit_next_site(*sweep);
        sweep->part.stop = sweep->carried;
    }
}

/// Two sites or fewer: each is its own neighbour or twice the other's.
void plain_sweep(std::span<double> row, const Rates& rates) {
    const std::size_t nx = row.size();
    for (std::size_t x = 0; x < nx; ++x) {
        double& left = row[(x + nx - 1) % nx];
        double& right = row[(x + 1) % nx];
        const double here = row[x];
        if (here > left && here > right) {
            left += rates.creep * here * 0.5;
            right += rates.creep * here * 0.5;
            row[x] -= rates.creep * here;
        } else if (here > left) {
            left += rates.flank * here;
            row[x] -= rates.flank * here;
        } else if (here > right) {
            right += rates.flank * here;
            row[x] -= rates.flank * here;
        }
    }
}

int threads_for(int nx, const WorkerPool* pool) {
    constexpr int worth_a_thread = 1 << 14;  // sites; waking a thread costs about 20 µs
    return pool == nullptr ? 1 : std::clamp(nx / worth_a_thread, 1, pool->size());
}

/// [1, nx − 1) in two parts for each thread.
std::vector<Part> parts_of(int nx, int threads) {
    const int count = 2 * threads;
    std::vector<Part> parts(static_cast<std::size_t>(count));
    const auto border = [&](int part) { return 1 + static_cast<int>((nx - 2LL) * part / count); };
    for (int part = 0; part < count; ++part) {
        parts[static_cast<std::size_t>(part)].begin = border(part);
        parts[static_cast<std::size_t>(part)].end = border(part + 1);
    }
    return parts;
}

}  // namespace

void profile_creep(std::span<double> before, double creep_rate, double flank_rate,
                   std::span<double> after, WorkerPool* pool) {
    const Rates rates{creep_rate, flank_rate};
    const int nx = static_cast<int>(before.size());
    constexpr int smallest = 4;
    if (nx < smallest) {
        plain_sweep(before, rates);
        std::copy(before.begin(), before.end(), after.begin());
        return;
    }
    double* from = before.data();
    double* to = after.data();

    Carried first{from[nx - 1], from[0]};  // site 0 gives to the last site, whose turn comes last
    const double second = visit(rates, first, from[1]);
    from[nx - 1] = first.left;

    const int threads = threads_for(nx, pool);
    std::vector<Part> parts = parts_of(nx, threads);
    for (Part& part : parts) part.start = {from[part.begin - 1], from[part.begin]};
    parts.front().start = {first.here, second};
    const auto sweep = [&](int begin, int end) {
        for (auto thread = static_cast<std::size_t>(begin); thread < static_cast<std::size_t>(end);
             ++thread) {
            sweep_both(parts[2 * thread], parts[2 * thread + 1], from, rates, to);
        }
    };
    if (threads == 1) {
        sweep(0, 1);
    } else {
        pool->for_ranges(threads, sweep);
    }
    to[0] = parts.front().before_begin;
    for (std::size_t k = 1; k < parts.size(); ++k) {
        parts[k].start_again(parts[k - 1].stop, from, rates, to);
        to[parts[k].begin - 1] = parts[k].before_begin;
    }

    Carried last = parts.back().stop;
    to[0] = visit(rates, last, to[0]);
    to[nx - 2] = last.left;
    to[nx - 1] = last.here;
}

}  // namespace fumon
