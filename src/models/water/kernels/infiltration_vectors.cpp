#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "models/water/kernels/infiltration_vectors.cpp"
#include <hwy/foreach_target.h>
// Those below are included once for each target.
#include "models/water/kernels/infiltration_vectors.h"
#include "vectors/functions-inl.h"
#include "vectors/rows-inl.h"

HWY_BEFORE_NAMESPACE();
namespace fumon::infiltration {
namespace HWY_NAMESPACE {

using namespace vectors::HWY_NAMESPACE;

struct Take {
    Rates rates;
    double* depth;
    double* taken;

    template <class D>
    HWY_INLINE void operator()(D d, std::size_t x) const {
        const auto there = hn::LoadU(d, depth + x);
        const auto rate = hn::LoadU(d, rates.rate + x);
        const auto above = hn::LoadU(d, rates.start + x) - rate;
        const auto most = (rate + above * hn::Set(d, rates.fallen)) * hn::Set(d, rates.dt);
        const auto gone = lesser(most, there);
        hn::StoreU(gone, d, taken + x);
        hn::StoreU(there - gone, d, depth + x);
    }
};

struct Horton {
    Capacity capacity;
    double* depth;
    double* fallen;
    double* taken;

    template <class D>
    HWY_INLINE void operator()(D d, std::size_t x) const {
        const auto there = hn::LoadU(d, depth + x);
        const auto rate = hn::LoadU(d, capacity.rate + x);
        const auto before = hn::LoadU(d, fallen + x);
        const auto above = (hn::LoadU(d, capacity.start + x) - rate) * before;
        const auto one = hn::Set(d, 1.0);
        const auto decay = hn::Set(d, capacity.decay);
        const auto whole = rate * hn::Set(d, capacity.dt) + above * hn::Set(d, capacity.lasts);
        const auto gone = lesser(whole, there);
        // k times the time in which that much could be taken, by Newton from below.
        const auto wanted = decay * gone;
        const auto most = hn::Set(d, capacity.decay * capacity.dt);
        const auto least = hn::Set(d, 1e-300);  // m/s, where the ground takes nothing
        auto phase = lesser(wanted / greater(rate + above, least), most);
        constexpr int turns = 5;
        for (int turn = 0; turn < turns; ++turn) {
            const auto kept = above * vectors::HWY_NAMESPACE::exp(hn::Neg(phase));
            const auto missing = wanted - rate * phase - (above - kept);
            phase = lesser(phase + missing / greater(rate + kept, least), most);
            phase = greater(phase, hn::Zero(d));
        }
        const auto slower = before * vectors::HWY_NAMESPACE::exp(hn::Neg(phase));
        const auto recovered = one - (one - before) * hn::Set(d, capacity.stays);
        const auto after = hn::IfThenElse(
            hn::Le(there, hn::Zero(d)), recovered,
            hn::IfThenElse(hn::Lt(gone, whole), slower, before * hn::Set(d, capacity.falls)));
        hn::StoreU(gone, d, taken + x);
        hn::StoreU(after, d, fallen + x);
        hn::StoreU(there - gone, d, depth + x);
    }
};

struct GreenAmpt {
    WettingFront front;
    double* depth;
    double* total;
    double* taken;

    template <class D>
    HWY_INLINE void operator()(D d, std::size_t x) const {
        const auto there = hn::LoadU(d, depth + x);
        const auto before = hn::LoadU(d, total + x);
        const auto conducted = hn::LoadU(d, front.conductivity + x) * hn::Set(d, front.dt);
        const auto suction = hn::LoadU(d, front.suction + x);
        const auto grown = before + conducted;
        const auto root = hn::Sqrt(grown * grown + hn::Set(d, 4.0) * conducted * suction);
        const auto could = hn::Set(d, 0.5) * (grown + root) - before;
        const auto gone = lesser(greater(could, hn::Zero(d)), there);
        hn::StoreU(gone, d, taken + x);
        hn::StoreU(before + gone, d, total + x);
        hn::StoreU(there - gone, d, depth + x);
    }
};

void take_row(const Rates& rates, int count, double* depth, double* taken) {
    for_each_vector(count, Take{rates, depth, taken});
}

void horton_row(const Capacity& capacity, int count, double* depth, double* fallen, double* taken) {
    for_each_vector(count, Horton{capacity, depth, fallen, taken});
}

void green_ampt_row(const WettingFront& front, int count, double* depth, double* total,
                    double* taken) {
    for_each_vector(count, GreenAmpt{front, depth, total, taken});
}

}  // namespace HWY_NAMESPACE
}  // namespace fumon::infiltration
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace fumon::infiltration {

HWY_EXPORT(take_row);
HWY_EXPORT(horton_row);
HWY_EXPORT(green_ampt_row);

void take_row(const Rates& rates, int count, double* depth, double* taken) {
    HWY_DYNAMIC_DISPATCH(take_row)(rates, count, depth, taken);
}

void horton_row(const Capacity& capacity, int count, double* depth, double* fallen, double* taken) {
    HWY_DYNAMIC_DISPATCH(horton_row)(capacity, count, depth, fallen, taken);
}

void green_ampt_row(const WettingFront& front, int count, double* depth, double* total,
                    double* taken) {
    HWY_DYNAMIC_DISPATCH(green_ampt_row)(front, count, depth, total, taken);
}

}  // namespace fumon::infiltration
#endif
