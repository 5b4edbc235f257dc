#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace fumon {

/// A number with a name in a formula.
using NamedNumber = std::pair<std::string, double>;

/// A formula of one variable: numbers, named constants (pi and e are known), + - * / ^ (which binds
/// more than a sign before it and joins from the right), parentheses, and the functions sqrt, exp,
/// ln, log10, sin, cos, tan, tanh, atan (radians) and abs. It can do nothing else.
class Expression {
  public:
    /// Throws InputError "column 5: …" without a place where the text is no such formula, is longer
    /// than 1,000 bytes or nested deeper than 100 times. Columns are counted from 1, in bytes.
    explicit Expression(std::string_view text, const std::vector<NamedNumber>& constants = {},
                        std::string_view variable = "x");

    /// Its value; not finite where it has none, as sqrt(-1). The same bits on every processor.
    [[nodiscard]] double at(double variable) const;

  private:
    enum class Step {
        number,
        variable,
        add,
        subtract,
        multiply,
        divide,
        power,
        negate,
        sqrt,
        exp,
        ln,
        log10,
        sin,
        cos,
        tan,
        tanh,
        atan,
        abs
    };
    struct Instruction {
        Step step = Step::number;
        double value = 0.0;
    };
    class Reader;

    static double applied(Step step, double value);
    static double joined(Step step, double left, double right);

    std::vector<Instruction> instructions_;  ///< operands before their operator
};

/// Reads "name = 1.5". Throws InputError without a place where it is no name with a finite number.
NamedNumber read_named_number(std::string_view text);

}  // namespace fumon
