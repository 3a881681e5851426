// Converts expressions to GiNaC's.
// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/hamiltonian/algebra.hpp"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>
#include <utility>

#include "generator/exact/expressions/evaluate.hpp"
#include "generator/hamiltonian/ginac_functions.hpp"
#include "generator/read/names.hpp"
#include "generator/read/own_functions.hpp"
#include "generator/scene/start.hpp"
#include "generator/scene/value_at.hpp"

namespace hvi::gen {

namespace {

using GiNaC::ex;
using GiNaC::numeric;
using Kind = Expression::Kind;

/// Limits for expressions: beyond them a slip is likelier than a Hamiltonian.
constexpr long most_exponent = 1000;
constexpr double most_digits = 10000;
constexpr double most_words_of_derivatives = 3e5;

/// Estimated words of an expression, and of all its first derivatives together.
struct Size {
    double words = 1;
    double derivatives = 0;
};

/// Estimates the size. In the derivative of a product each factor stands once for each other
/// factor.
Size size(const Expression& expression) {
    if (expression.kind == Kind::symbol) return {1, 1};
    Size sum;
    std::vector<Size> parts;
    for (const Expression& argument : expression.arguments) {
        parts.push_back(size(argument));
        sum.words += parts.back().words;
        sum.derivatives += parts.back().derivatives;
    }
    if (expression.kind == Kind::sum || expression.kind == Kind::negation) return sum;
    for (const Size& part : parts)
        if (part.derivatives > 0) sum.derivatives += sum.words;
    return sum;
}

/// Returns the decimal digits of the longest coefficient.
double digits_in(const ex& expression) {
    if (GiNaC::is_a<numeric>(expression)) {
        const auto& number = GiNaC::ex_to<numeric>(expression);
        return 0.30103 * (number.numer().int_length() + number.denom().int_length());
    }
    double most = 0;
    if (!GiNaC::is_a<GiNaC::add>(expression) && !GiNaC::is_a<GiNaC::mul>(expression)) return most;
    for (const ex& part : expression) most = std::max(most, digits_in(part));
    return most;
}

bool has_symbols(const ex& expression) {
    return GiNaC::is_a<GiNaC::symbol>(expression) ||
           std::any_of(expression.begin(), expression.end(), has_symbols);
}

/// Converts our expressions to GiNaC's.
class Reader {
public:
    Reader(const Algebra& algebra, std::shared_ptr<const Source> source,
           const std::map<std::string, ex>& symbols)
        : algebra_(algebra), source_(std::move(source)), symbols_(symbols) {}

    [[nodiscard]] ex read(const Expression& expression) const {
        try {
            return value(expression);
        } catch (const Error&) { throw; } catch (const std::exception&) {
            throw InputError("this has no value", place(expression));
        }
    }

private:
    /// Returns the expression's place. NOTE: an expression made of others has no range; the whole
    /// text stands for it.
    [[nodiscard]] Place place(const Expression& expression) const {
        const Range range = expression.range;
        const bool is_known = source_ == nullptr || range.begin < range.end;
        return is_known ? Place{source_, range} : whole(source_);
    }

    [[nodiscard]] ex value(const Expression& expression) const {
        switch (expression.kind) {
        case Kind::number:
            return numeric(expression.numerator.c_str()) / numeric(expression.denominator.c_str());
        case Kind::symbol: return symbol(expression.name);
        case Kind::sum: return GiNaC::add(all(expression.arguments));
        case Kind::product: return product(expression);
        case Kind::negation: return -read(expression.arguments[0]);
        case Kind::reciprocal: return 1 / not_zero(expression.arguments[0]);
        case Kind::power: return power(expression);
        case Kind::call: return call(expression);
        case Kind::element:
        case Kind::sum_over: break;
        }
        HVI_CHECK(false && "every kind of expression has a value");
        return {};
    }

    [[nodiscard]] ex symbol(const std::string& name) const {
        if (name == "pi") return GiNaC::Pi;
        if (name == "e") return GiNaC::exp(ex(1));
        return symbols_.at(name);
    }

    [[nodiscard]] GiNaC::exvector all(const std::vector<Expression>& expressions) const {
        GiNaC::exvector values;
        for (const Expression& expression : expressions) values.push_back(read(expression));
        return values;
    }

    [[nodiscard]] ex product(const Expression& expression) const {
        GiNaC::exvector factors = all(expression.arguments);
        double digits = 0;
        for (const ex& factor : factors) digits += digits_in(factor);
        if (digits > most_digits) refuse_size(expression);
        return GiNaC::mul(std::move(factors));
    }

    [[nodiscard]] ex not_zero(const Expression& divisor) const {
        ex result = read(divisor);
        if (result.is_zero()) throw InputError("division by zero", place(divisor));
        return result;
    }

    [[nodiscard]] ex power(const Expression& expression) const {
        const Expression& base = expression.arguments[0];
        const ex exponent = read(expression.arguments[1]);
        if (base.kind == Kind::symbol && base.name == "e") return GiNaC::exp(exponent);
        const bool is_number = GiNaC::is_a<numeric>(exponent);
        const bool is_positive = exponent.info(GiNaC::info_flags::positive);
        const ex raised = is_positive ? read(base) : not_zero(base);
        if (is_number) check_exponent(raised, GiNaC::ex_to<numeric>(exponent), expression);
        return raised_to(raised, exponent, expression);
    }

    [[nodiscard]] ex call(const Expression& expression) const {
        refuse_own_functions(expression, source_, "what is computed exactly");
        const GiNaC::exvector arguments = all(expression.arguments);
        if (expression.name == "sqrt") return raised_to(arguments[0], ex(1) / 2, expression);
        return real(applied(expression.name, arguments), expression);
    }

    [[nodiscard]] ex raised_to(const ex& base, const ex& exponent,
                               const Expression& expression) const {
        const bool counts = exponent.info(GiNaC::info_flags::integer);
        if (base.info(GiNaC::info_flags::negative) && !counts) refuse_complex(expression);
        return real(GiNaC::pow(base, exponent), expression);
    }

    void check_exponent(const ex& base, const numeric& exponent,
                        const Expression& expression) const {
        const numeric size = GiNaC::abs(exponent);
        if (size > most_exponent || exponent.denom() > most_exponent)
            refuse_size(expression.arguments[1]);
        if (digits_in(base) * size.to_double() > most_digits) refuse_size(expression);
    }

    /// Checks that a value is real. NOTE: an expression with symbols may be a number all the same:
    /// q/q - cbrt(3).
    [[nodiscard]] ex real(ex value, const Expression& expression) const {
        if (value.has(GiNaC::I)) refuse_complex(expression);
        if (GiNaC::is_a<numeric>(value) || has_symbols(value)) return value;
        try {
            static_cast<void>(value_at(algebra_.written(value), {}, nullptr));
        } catch (const MathError&) { refuse_complex(expression); }
        return value;
    }

    [[noreturn]] void refuse_complex(const Expression& expression) const {
        throw MathError("this is not real", place(expression));
    }

    [[noreturn]] void refuse_size(const Expression& expression) const {
        throw InputError("this is larger than any Hamiltonian needs", place(expression));
    }

    const Algebra& algebra_;
    std::shared_ptr<const Source> source_;
    const std::map<std::string, ex>& symbols_;
};

void check_size(const Expression& expression, const Place& whole) {
    if (size(expression).derivatives <= most_words_of_derivatives) return;
    throw InputError("the derivatives of this Hamiltonian are too long to be written out", whole);
}

/// Returns text that sorts as the number does.
std::string padded(std::size_t number) {
    std::ostringstream text;
    text << std::setw(4) << std::setfill('0') << number;
    return text.str();
}

}  // namespace

namespace {

const Hamiltonian& without_rotations(const Hamiltonian& hamiltonian) {
    if (hamiltonian.rotations.empty()) return hamiltonian;
    throw InputError("what is computed exactly is not built for scenes with rotations",
                     whole(hamiltonian.source), "`stepper`, `run` and `report` take these");
}

}  // namespace

Algebra::Algebra(const Hamiltonian& hamiltonian)
    : Algebra(without_rotations(hamiltonian).expression, hamiltonian.source, hamiltonian.parameters,
              hvi::gen::variables(hamiltonian)) {}

Algebra Algebra::with_entries(const Hamiltonian& hamiltonian) {
    return {hamiltonian.expression, hamiltonian.source, hamiltonian.parameters,
            hvi::gen::variables(hamiltonian)};
}

Algebra::Algebra(const Lagrangian& lagrangian)
    : Algebra(lagrangian.expression, lagrangian.source, lagrangian.parameters,
              hvi::gen::variables(lagrangian)) {}

Algebra::Algebra(const Expression& function, const std::shared_ptr<const Source>& source,
                 const std::vector<Parameter>& parameters,
                 const std::vector<std::string>& variables)
    : whole_(whole(source)) {
    check_size(function, whole_);
    check_numbers(function, source);
    for (const Parameter& parameter : parameters) {
        on_new_ground([&](const Ground& ground) { return exact_value(parameter, ground); });
        const ex value = Reader(*this, parameter.source, symbols_).read(parameter.value);
        symbols_[parameter.name] = values_[parameter.name] = value;
    }
    for (const std::string& name : parameter_names(function, variables))
        add(name, '1', parameters_);
    if (depends_on_time(function)) add("t", '1', parameters_);
    for (const std::string& name : variables) add(name, '2', variables_);
    function_ = Reader(*this, source, symbols_).read(function);
}

void Algebra::add(const std::string& name, char kind, std::vector<GiNaC::symbol>& list) {
    if (symbols_.count(name) != 0) return;
    ranks_[name] = kind + padded(list.size());
    symbols_[name] = list.emplace_back(name);
}

ex Algebra::read(const Expression& expression, const std::shared_ptr<const Source>& source) {
    check_numbers(expression, source);
    for (const std::string& name : parameter_names(expression, {})) add(name, '1', parameters_);
    if (depends_on_time(expression)) add("t", '1', parameters_);
    return Reader(*this, source, symbols_).read(expression);
}

GiNaC::ex Algebra::derivative(const ex& expression, const GiNaC::symbol& variable) const {
    try {
        return expression.diff(variable);
    } catch (const std::exception&) {
        throw InputError("the derivative by `" + variable.get_name() + "` is not defined", whole_);
    }
}

}  // namespace hvi::gen
