#pragma once

#include <algorithm>
#include <cstddef>
#include <initializer_list>
#include <memory>
#include <vector>

namespace fumon {

/// Values that come one after the other. A copy shares them and keeps its length when more are
/// added to what it was copied from, so that one may be handed out with every frame of a run. One
/// thread at a time adds to those that share; others may read their copies meanwhile.
class MeasuredValues {
  public:
    MeasuredValues() = default;
    MeasuredValues(std::initializer_list<double> values) { assign(values); }
    explicit MeasuredValues(const std::vector<double>& values) { assign(values); }

    void push_back(double value) {
        if (!store_ || size_ == store_->capacity || size_ != store_->used) grow();
        store_->values[size_] = value;
        store_->used = ++size_;
    }

    [[nodiscard]] std::size_t size() const { return size_; }
    [[nodiscard]] bool empty() const { return size_ == 0; }
    [[nodiscard]] const double* data() const { return store_ ? store_->values.get() : nullptr; }
    [[nodiscard]] const double* begin() const { return data(); }
    [[nodiscard]] const double* end() const { return data() + size_; }
    [[nodiscard]] double back() const { return data()[size_ - 1]; }
    [[nodiscard]] double operator[](std::size_t i) const { return data()[i]; }
    [[nodiscard]] std::vector<double> copied() const { return {begin(), end()}; }

  private:
    struct Store {
        explicit Store(std::size_t size) : capacity(size), values(new double[size]) {}
        std::size_t capacity;
        std::size_t used = 0;  ///< by the longest of those that share it; for who adds
        std::unique_ptr<double[]> values;
    };

    template <class Values>
    void assign(const Values& values) {
        for (const double value : values) push_back(value);
    }

    /// Moves to a store of its own with room for more.
    void grow() {
        constexpr std::size_t least = 64;
        auto larger = std::make_shared<Store>(std::max(least, 2 * size_));
        std::copy(begin(), end(), larger->values.get());
        larger->used = size_;
        store_ = std::move(larger);
    }

    std::shared_ptr<Store> store_;
    std::size_t size_ = 0;
};

}  // namespace fumon
