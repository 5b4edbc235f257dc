#pragma once

#include <cmath>

namespace fumon {

/// A number as the unevaluated sum of two doubles, `high` being the sum rounded: about 106 bits.
/// Plain IEEE double arithmetic in a fixed order (Dekker 1971; Knuth 1969), so the same bits on
/// every processor. Within the range in which no product over- or underflows.
struct DoubleDouble {
    double high = 0.0;
    double low = 0.0;
};

/// a + b, exactly.
inline DoubleDouble exact_sum(double a, double b) {
    const double sum = a + b;
    const double of_b = sum - a;
    return {sum, (a - (sum - of_b)) + (b - of_b)};
}

/// high + low, exactly, for |high| ≥ |low|.
inline DoubleDouble normalised(double high, double low) {
    const double sum = high + low;
    return {sum, low - (sum - high)};
}

/// a · b, exactly, for factors below 2^990.
inline DoubleDouble exact_product(double a, double b) {
    constexpr double splitter = 0x1p27 + 1.0;
    const auto split = [](double x) {
        const double scaled = splitter * x;
        const double upper = scaled - (scaled - x);
        return DoubleDouble{upper, x - upper};
    };
    const DoubleDouble x = split(a);
    const DoubleDouble y = split(b);
    const double product = a * b;
    return {product,
            ((x.high * y.high - product) + x.high * y.low + x.low * y.high) + x.low * y.low};
}

/// Relative error below 2^-104 where the terms have one sign.
inline DoubleDouble operator+(const DoubleDouble& a, const DoubleDouble& b) {
    const DoubleDouble high = exact_sum(a.high, b.high);
    const DoubleDouble low = exact_sum(a.low, b.low);
    const DoubleDouble sum = normalised(high.high, high.low + low.high);
    return normalised(sum.high, sum.low + low.low);
}

/// Relative error below 2^-102.
inline DoubleDouble operator*(const DoubleDouble& a, const DoubleDouble& b) {
    const DoubleDouble product = exact_product(a.high, b.high);
    return normalised(product.high, product.low + (a.high * b.low + a.low * b.high));
}

inline DoubleDouble operator*(const DoubleDouble& a, double b) {
    const DoubleDouble product = exact_product(a.high, b);
    return normalised(product.high, product.low + a.low * b);
}

/// Relative error below 2^-100.
inline DoubleDouble operator/(const DoubleDouble& a, const DoubleDouble& b) {
    const double quotient = a.high / b.high;
    const DoubleDouble back = b * quotient;
    const DoubleDouble rest = a + DoubleDouble{-back.high, -back.low};
    return normalised(quotient, (rest.high + rest.low) / b.high);
}

}  // namespace fumon
