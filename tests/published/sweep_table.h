#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <map>
#include <string>
#include <vector>

namespace fumon::test {

/// sweep.csv of a sweep that the program ran: a row for each run and measured step.
class SweepTable {
  public:
    /// What `fumon sweep` is told: a scene of scenes/ or a path, --over lists, --set settings,
    /// seeds.
    struct Order {
        std::string scene;
        std::vector<std::string> over{};
        std::vector<std::string> settings{};
        int seeds = 5;
    };
    /// Runs it. A failure fails the test.
    explicit SweepTable(const Order& order);

    /// A row by its columns' names; an empty cell is NaN.
    using Row = std::map<std::string, double>;
    using Where = std::function<bool(const Row&)>;
    [[nodiscard]] const std::vector<Row>& rows() const { return rows_; }

    /// The mean of a column over the rows chosen. NaN, which no expectation meets, when there are
    /// none or one of them is NaN.
    [[nodiscard]] double mean(const std::string& column, const Where& where) const;
    [[nodiscard]] double mean(const std::string& column) const {
        return mean(column, [](const Row&) { return true; });
    }

    /// All of run DIR's avalanche sizes.
    [[nodiscard]] std::vector<std::vector<long long>> avalanche_sizes() const { return sizes_; }

  private:
    std::vector<Row> rows_;
    std::vector<std::vector<long long>> sizes_;
};

/// Expects |found − expected| ≤ share · |expected|, and says by how much it is off.
void expect_within(double found, double expected, double share, const std::string& what);

/// Slope and R² of the least-squares line y = a + b x.
struct FittedLine {
    double offset;
    double slope;
    double r_squared;
};
FittedLine line_through(const std::vector<double>& x, const std::vector<double>& y);

}  // namespace fumon::test
