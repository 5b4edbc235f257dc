#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "models/air/air_vectors.cpp"
#include <hwy/foreach_target.h>
// Those below are included once for each target.
#include "models/air/air_vectors.h"
#include "vectors/rows-inl.h"

HWY_BEFORE_NAMESPACE();
namespace fumon::air {
namespace HWY_NAMESPACE {

using namespace vectors::HWY_NAMESPACE;

/// What both predictions share, at a node and around it.
template <class D>
struct Node {
    using V = hn::Vec<D>;
    V centre, left, right, below, above;

    HWY_INLINE Node(D d, std::size_t k, const Columns& v)
        : centre(hn::LoadU(d, v.here + k)),
          left(hn::LoadU(d, v.left + k)),
          right(hn::LoadU(d, v.right + k)),
          below(hn::LoadU(d, v.here + k - 1)),
          above(hn::LoadU(d, v.here + k + 1)) {}

    HWY_INLINE V moved(D d, V u, V w, V toward, V upward, const Coefficients& by) const {
        const V around = (((left + right) + below) + above) - hn::Set(d, 4.0) * centre;
        return centre + (hn::Set(d, by.diffusion) * around -
                         hn::Set(d, by.courant) * (u * toward + w * upward));
    }
};

struct Upwind {
    Columns u;
    Columns w;
    Coefficients with;
    NewVelocity out;

    template <class D>
    HWY_INLINE void operator()(D d, std::size_t k) const {
        hn::StoreU(moved(d, k, u), d, out.u + k);
        hn::StoreU(moved(d, k, w), d, out.w + k);
    }

    template <class D>
    HWY_INLINE hn::Vec<D> moved(D d, std::size_t k, const Columns& values) const {
        using V = hn::Vec<D>;
        const Node<D> at(d, k, values);
        const V zero = hn::Zero(d);
        const V along_x = hn::LoadU(d, u.here + k);
        const V along_z = hn::LoadU(d, w.here + k);
        const V toward =
            hn::IfThenElse(hn::Gt(along_x, zero), at.centre - at.left, at.right - at.centre);
        const V upward =
            hn::IfThenElse(hn::Gt(along_z, zero), at.centre - at.below, at.above - at.centre);
        return at.moved(d, along_x, along_z, toward, upward, with);
    }
};

struct SecondOrder {
    Columns u;
    Columns w;
    Coefficients with;
    NewVelocity out;

    template <class D>
    HWY_INLINE void operator()(D d, std::size_t k) const {
        hn::StoreU(moved(d, k, u), d, out.u + k);
        hn::StoreU(moved(d, k, w), d, out.w + k);
    }

    template <class D>
    HWY_INLINE hn::Vec<D> moved(D d, std::size_t k, const Columns& values) const {
        using V = hn::Vec<D>;
        const Node<D> at(d, k, values);
        const V zero = hn::Zero(d);
        const V half = hn::Set(d, 0.5);
        const V two = hn::Set(d, 2.0);
        const V along_x = hn::LoadU(d, u.here + k);
        const V along_z = hn::LoadU(d, w.here + k);
        const auto load = [&](const double* row) HWY_ATTR { return hn::LoadU(d, row + k); };
        const V most = hn::Set(d, 1.5) * at.centre;
        const V from_left = (most - two * at.left) + half * load(values.far_left);
        const V from_right = (two * at.right - most) - half * load(values.far_right);
        const V from_below = (most - two * at.below) + half * load(values.here - 2);
        const V from_above = (two * at.above - most) - half * load(values.here + 2);
        const V toward = hn::IfThenElse(hn::Gt(along_x, zero), from_left, from_right);
        const V upward = hn::IfThenElse(hn::Gt(along_z, zero), from_below, from_above);
        return at.moved(d, along_x, along_z, toward, upward, with);
    }
};

struct Diverge {
    const double* u_left;
    const double* u_right;
    const double* w;
    double factor;
    double* out;

    template <class D>
    HWY_INLINE void operator()(D d, std::size_t k) const {
        const auto across = hn::LoadU(d, u_right + k) - hn::LoadU(d, u_left + k);
        const auto divergence = (across + hn::LoadU(d, w + k + 1)) - hn::LoadU(d, w + k - 1);
        hn::StoreU(hn::Set(d, factor) * divergence, d, out + k);
    }
};

struct SubtractMultiple {
    const double* a;
    double factor;
    const double* b;
    double* out;

    template <class D>
    HWY_INLINE void operator()(D d, std::size_t k) const {
        hn::StoreU(hn::LoadU(d, a + k) - hn::Set(d, factor) * hn::LoadU(d, b + k), d, out + k);
    }
};

/// From node `begin` on.
HWY_INLINE Columns from(const Columns& all, int begin) {
    return {all.far_left + begin, all.left + begin, all.here + begin, all.right + begin,
            all.far_right + begin};
}

void predict_upwind(const Columns& u, const Columns& w, const Coefficients& with, int begin,
                    int end, const NewVelocity& out) {
    for_each_vector_overlapping(
        end - begin, Upwind{from(u, begin), from(w, begin), with, {out.u + begin, out.w + begin}});
}

void predict_second_order(const Columns& u, const Columns& w, const Coefficients& with, int begin,
                          int end, const NewVelocity& out) {
    for_each_vector_overlapping(
        end - begin,
        SecondOrder{from(u, begin), from(w, begin), with, {out.u + begin, out.w + begin}});
}

void diverge(const double* u_left, const double* u_right, const double* w, double factor, int begin,
             int end, double* out) {
    for_each_vector_overlapping(
        end - begin, Diverge{u_left + begin, u_right + begin, w + begin, factor, out + begin});
}

double correct(const Columns& pressure, const Velocity& predicted, double factor, int begin,
               int end, const NewVelocity& out) {
    const hn::ScalableTag<double> doubles;
    const hn::CappedTag<double, 1> one;
    constexpr std::size_t lanes = hn::MaxLanes(doubles);
    const auto last = static_cast<std::size_t>(end);
    const auto node = [&](auto d, std::size_t k) HWY_ATTR {
        const auto by = hn::Set(d, factor);
        const auto load = [&](const double* from) HWY_ATTR { return hn::LoadU(d, from + k); };
        const auto u = load(predicted.u) - by * (load(pressure.right) - load(pressure.left));
        const auto w = load(predicted.w) - by * (load(pressure.here + 1) - load(pressure.here - 1));
        hn::StoreU(u, d, out.u + k);
        hn::StoreU(w, d, out.w + k);
        const auto zero = hn::Zero(d);  // times what is not finite it is no number
        return u * zero + w * zero;
    };
    auto faults = hn::Zero(doubles);
    auto k = static_cast<std::size_t>(begin);
    for (; k + lanes <= last; k += lanes) faults = faults + node(doubles, k);
    double fault = hn::GetLane(hn::SumOfLanes(doubles, faults));
#pragma GCC unroll 1
    for (; k < last; ++k) fault += hn::GetLane(node(one, k));
    return fault;
}

void subtract_multiple(const double* a, double factor, const double* b, int count, double* out) {
    for_each_vector_overlapping(count, SubtractMultiple{a, factor, b, out});
}

/// Adds four columns, one after the other: at once in the registers.
struct AddFourColumns {
    const double* matrix;
    std::size_t size;
    const double* by;
    double* product;

    template <class D>
    HWY_INLINE void operator()(D d, std::size_t i) const {
        auto sum = hn::LoadU(d, product + i);
        for (std::size_t j = 0; j < 4; ++j)
            sum = sum + hn::LoadU(d, matrix + j * size + i) * hn::Set(d, by[j]);
        hn::StoreU(sum, d, product + i);
    }
};

void multiply(const double* matrix, const double* by, std::size_t size, std::size_t begin,
              std::size_t end, double* product) {
    const auto count = static_cast<int>(end - begin);
    for (std::size_t i = begin; i < end; ++i) product[i] = 0.0;
    std::size_t j = 0;
    for (; j + 4 <= size; j += 4) {
        for_each_vector(count,
                        AddFourColumns{matrix + j * size + begin, size, by + j, product + begin});
    }
    for (; j < size; ++j) {
        for (std::size_t i = begin; i < end; ++i) product[i] += matrix[j * size + i] * by[j];
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace fumon::air
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace fumon::air {

HWY_EXPORT(predict_upwind);
HWY_EXPORT(predict_second_order);
HWY_EXPORT(diverge);
HWY_EXPORT(correct);
HWY_EXPORT(subtract_multiple);
HWY_EXPORT(multiply);

void predict_upwind(const Columns& u, const Columns& w, const Coefficients& with, int begin,
                    int end, const NewVelocity& out) {
    HWY_DYNAMIC_DISPATCH(predict_upwind)(u, w, with, begin, end, out);
}

void predict_second_order(const Columns& u, const Columns& w, const Coefficients& with, int begin,
                          int end, const NewVelocity& out) {
    HWY_DYNAMIC_DISPATCH(predict_second_order)(u, w, with, begin, end, out);
}

void diverge(const double* u_left, const double* u_right, const double* w, double factor, int begin,
             int end, double* out) {
    HWY_DYNAMIC_DISPATCH(diverge)(u_left, u_right, w, factor, begin, end, out);
}

double correct(const Columns& pressure, const Velocity& predicted, double factor, int begin,
               int end, const NewVelocity& out) {
    return HWY_DYNAMIC_DISPATCH(correct)(pressure, predicted, factor, begin, end, out);
}

void subtract_multiple(const double* a, double factor, const double* b, int count, double* out) {
    HWY_DYNAMIC_DISPATCH(subtract_multiple)(a, factor, b, count, out);
}

void multiply(const double* matrix, const double* by, std::size_t size, std::size_t begin,
              std::size_t end, double* product) {
    HWY_DYNAMIC_DISPATCH(multiply)(matrix, by, size, begin, end, product);
}

}  // namespace fumon::air
#endif
