#include "numerics/expression.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "base/elementary.h"
#include "base/elementary_angle.h"
#include "base/elementary_power.h"
#include "base/error.h"
#include "base/nearest_name.h"

namespace fumon {

namespace {

constexpr std::size_t longest_text = 1000;
constexpr int deepest = 100;

bool is_letter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}

bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

std::string_view name_at(std::string_view text, std::size_t at) {
    std::size_t end = at;
    while (end < text.size() && (is_letter(text[end]) || (end > at && is_digit(text[end])))) ++end;
    return text.substr(at, end - at);
}

std::string_view trimmed(std::string_view text) {
    while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
    while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
    return text;
}

}  // namespace

/// Reads by recursive descent, and writes operands before their operators.
class Expression::Reader {
  public:
    Reader(std::string_view text, const std::vector<NamedNumber>& constants,
           std::string_view variable, std::vector<Instruction>& instructions)
        : text_(text), constants_(constants), variable_(variable), instructions_(instructions) {}

    void read() {
        if (text_.size() > longest_text)
            fail(longest_text, fmt::format("a formula has up to {} letters", longest_text));
        sum();
        if (at_ == text_.size()) return;
        if (next() == ')') fail(at_, "this closing parenthesis has no opening one");
        fail(at_,
             fmt::format("\"{}\" follows without an operator; write * between factors", rest()));
    }

  private:
    [[noreturn]] static void fail(std::size_t at, const std::string& what) {
        throw InputError(fmt::format("column {}: {}", at + 1, what));
    }

    [[nodiscard]] std::string rest() const {
        const std::string_view name = name_at(text_, at_);
        return std::string(name.empty() ? text_.substr(at_, 1) : name);
    }

    char next() {
        while (at_ < text_.size() && text_[at_] == ' ') ++at_;
        return at_ < text_.size() ? text_[at_] : '\0';
    }

    bool takes(char letter) {
        if (next() != letter) return false;
        ++at_;
        return true;
    }

    void write(Step step, double value = 0.0) { instructions_.push_back({step, value}); }

    void sum() {
        if (++depth_ > deepest) fail(at_, "nested too deeply");
        product();
        for (;;) {
            if (takes('+')) {
                product();
                write(Step::add);
            } else if (takes('-')) {
                product();
                write(Step::subtract);
            } else {
                break;
            }
        }
        --depth_;
    }

    void product() {
        signed_power();
        for (;;) {
            if (next() == '*' && at_ + 1 < text_.size() && text_[at_ + 1] == '*')
                fail(at_, "powers are written with ^");
            if (takes('*')) {
                signed_power();
                write(Step::multiply);
            } else if (takes('/')) {
                signed_power();
                write(Step::divide);
            } else {
                return;
            }
        }
    }

    void signed_power() {
        if (++depth_ > deepest) fail(at_, "nested too deeply");
        if (takes('-')) {
            signed_power();
            write(Step::negate);
        } else if (takes('+')) {
            signed_power();
        } else {
            operand();
            if (takes('^')) {
                signed_power();
                write(Step::power);
            }
        }
        --depth_;
    }

    void operand() {
        const char first = next();
        if (first == '\0') fail(at_, "a number, a name or a parenthesis is missing at the end");
        if (takes('(')) {
            const std::size_t open = at_ - 1;
            sum();
            if (!takes(')')) fail(open, "this parenthesis is not closed");
        } else if (is_digit(first) || first == '.') {
            number();
        } else if (is_letter(first)) {
            name();
        } else {
            fail(at_,
                 fmt::format("\"{}\" found where a number, a name or a parenthesis is expected",
                             first));
        }
    }

    void number() {
        double value = 0.0;
        const char* begin = text_.data() + at_;
        const auto [end, error] = std::from_chars(begin, text_.data() + text_.size(), value);
        if (error != std::errc() || !std::isfinite(value)) fail(at_, "this is not a number");
        at_ += static_cast<std::size_t>(end - begin);
        write(Step::number, value);
    }

    void name() {
        struct Function {
            std::string_view name;
            Step step;
        };
        static constexpr std::array<Function, 10> functions{{{"sqrt", Step::sqrt},
                                                             {"exp", Step::exp},
                                                             {"ln", Step::ln},
                                                             {"log10", Step::log10},
                                                             {"sin", Step::sin},
                                                             {"cos", Step::cos},
                                                             {"tan", Step::tan},
                                                             {"tanh", Step::tanh},
                                                             {"atan", Step::atan},
                                                             {"abs", Step::abs}}};
        const std::size_t at = at_;
        const std::string name(name_at(text_, at_));
        at_ += name.size();
        if (next() == '(') {
            const auto known = std::ranges::find(functions, name, &Function::name);
            if (known == functions.end()) {
                std::vector<std::string> names;
                names.reserve(functions.size());
                for (const Function& function : functions) names.emplace_back(function.name);
                fail(at, name == "log" ? "log is ambiguous; write ln or log10"
                                       : fmt::format("there is no function \"{}\"; {}", name,
                                                     suggestion(name, names)));
            }
            operand();
            write(known->step);
            return;
        }
        const auto known = std::ranges::find(constants_, name, &NamedNumber::first);
        if (name == variable_) {
            write(Step::variable);
        } else if (known != constants_.end()) {
            write(Step::number, known->second);
        } else if (name == "pi") {
            write(Step::number, 3.14159265358979323846);
        } else if (name == "e") {
            write(Step::number, 2.71828182845904523536);
        } else {
            fail(at, fmt::format("\"{}\" is neither {} nor one of the constants; give \"{} = "
                                 "NUMBER\" among them",
                                 name, variable_, name));
        }
    }

    std::string_view text_;
    const std::vector<NamedNumber>& constants_;
    std::string_view variable_;
    std::vector<Instruction>& instructions_;
    std::size_t at_ = 0;
    int depth_ = 0;
};

Expression::Expression(std::string_view text, const std::vector<NamedNumber>& constants,
                       std::string_view variable) {
    Reader(text, constants, variable, instructions_).read();
}

double Expression::applied(Step step, double value) {
    switch (step) {
        case Step::negate:
            return -value;
        case Step::sqrt:
            return std::sqrt(value);
        case Step::exp:
            return elementary::exp(value);
        case Step::ln:
            return elementary::log(value);
        case Step::log10:
            return elementary::log10(value);
        case Step::sin:
            return elementary::sin(value);
        case Step::cos:
            return elementary::cos(value);
        case Step::tan:
            return elementary::sin(value) / elementary::cos(value);
        case Step::tanh:
            return elementary::tanh(value);
        case Step::atan:
            return elementary::atan(value);
        default:
            return std::abs(value);
    }
}

double Expression::joined(Step step, double left, double right) {
    switch (step) {
        case Step::add:
            return left + right;
        case Step::subtract:
            return left - right;
        case Step::multiply:
            return left * right;
        case Step::divide:
            return left / right;
        default:
            return elementary::pow(left, right);
    }
}

double Expression::at(double variable) const {
    std::vector<double> stack;
    for (const Instruction& instruction : instructions_) {
        const Step step = instruction.step;
        if (step == Step::number || step == Step::variable) {
            stack.push_back(step == Step::number ? instruction.value : variable);
        } else if (step <= Step::power) {
            const double right = stack.back();
            stack.pop_back();
            stack.back() = joined(step, stack.back(), right);
        } else {
            stack.back() = applied(step, stack.back());
        }
    }
    return stack.back();
}

NamedNumber read_named_number(std::string_view text) {
    const std::size_t equals = std::min(text.find('='), text.size());
    const std::string_view name = trimmed(text.substr(0, equals));
    const std::string_view number =
        equals < text.size() ? trimmed(text.substr(equals + 1)) : std::string_view();
    double value = 0.0;
    const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), value);
    const bool is_number = error == std::errc() && end == number.data() + number.size() &&
                           !number.empty() && std::isfinite(value);
    if (name.empty() || name_at(name, 0) != name || !is_number) {
        throw InputError(fmt::format(
            "\"{}\" is not a constant; write a name and its number: \"g = 9.81\"", text));
    }
    return {std::string(name), value};
}

}  // namespace fumon
