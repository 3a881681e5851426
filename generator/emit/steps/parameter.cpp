// Headers of methods with a free parameter: coefficients that the constructor computes.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <cmath>
#include <utility>

#include "generator/emit/steps/header.hpp"
#include "generator/exact/numbers/expansion.hpp"
#include "generator/ir/equal.hpp"
#include "generator/support/error.hpp"

namespace hvi::gen {
namespace {

// ---- struct Functions ----

std::string power(std::string_view base, unsigned exponent) {
    return exponent == 1 ? std::string(base) : fmt::format("{}^{}", base, exponent);
}

/// Returns the names of the generators in comments.
std::vector<std::string> names(const ParametricNumbers& numbers) {
    std::vector<std::string> result{numbers.parameter};
    for (std::size_t p = 1; p <= numbers.generators.phases.size(); ++p) {
        result.push_back(fmt::format("x_{}", p));
        result.push_back(fmt::format("y_{}", p));
    }
    for (const Number& constant : numbers.generators.constants) {
        result.push_back(exact_text(constant));
    }
    return result;
}

std::string formula(const EntireFunction& function, const std::vector<std::string>& names) {
    std::string sum;
    for (const EntireFunction::Term& term : function.terms) {
        std::string product;
        for (std::size_t g = 0; g < names.size(); ++g) {
            if (term.powers[g] == 0) { continue; }
            product +=
                fmt::format("{}{}", product.empty() ? "" : "*", power(names[g], term.powers[g]));
        }
        const bool negative = term.coefficient.sign() < 0;
        const std::string size = exact_text(negative ? -term.coefficient : term.coefficient);
        if (product.empty()) {
            product = size;
        } else if (size != "1") {
            product = size + "*" + product;
        }
        sum += sum.empty() ? (negative ? "-" : "") : (negative ? " - " : " + ");
        sum += product;
    }
    return sum;
}

std::string phases_comment(const ParametricNumbers& numbers) {
    std::string text =
        fmt::format("The coefficients are quotients of functions of {}", numbers.parameter);
    for (std::size_t p = 0; p < numbers.generators.phases.size(); ++p) {
        const Phase& phase = numbers.generators.phases[p];
        const std::string argument =
            fmt::format("({})*{}", exact_text(phase.rate), numbers.parameter);
        text +=
            phase.kind == Phase::Kind::angle
                ? fmt::format(", of x_{0} = sin({1}) and y_{0} = cos({1})", p + 1, argument)
                : fmt::format(", of x_{0} and y_{0} with x_{0}/y_{0} = exp({1})", p + 1, argument);
    }
    return text + ".";
}

std::string parts(const Number& constant) {
    std::string list;
    for (const double part : expansion(constant)) {
        list += list.empty() ? literal(part)
                             : fmt::format(", {}", part == 0.0 ? "0.0" : fmt::format("{:a}", part));
    }
    return "{" + list + "}";
}

void write_generators(Writer& writer, const EntireGenerators& generators) {
    writer.open("static constexpr std::array<hvi::detail::Phase, {}> phases{{{{",
                generators.phases.size());
    for (const Phase& phase : generators.phases) {
        writer.line("{{hvi::detail::Phase::Kind::{}, {}}},",
                    phase.kind == Phase::Kind::angle ? "angle" : "exponential", parts(phase.rate));
    }
    writer.close("}};");
    writer.open("static constexpr std::array<hvi::detail::Expansion, {}> constants{{{{",
                generators.constants.size());
    for (const Number& constant : generators.constants) {
        writer.comment(exact_text(constant)).line("{{{}}},", parts(constant));
    }
    writer.close("}};");
}

/// Writes the terms of a function. Integers of more than 53 bits become several terms. Returns the
/// number of terms.
std::size_t write_terms(Writer& writer, const EntireFunction& function) {
    std::size_t count = 0;
    for (const EntireFunction::Term& term : function.terms) {
        std::string powers;
        for (const unsigned exponent : term.powers) {
            if (exponent > 255) { throw MathError("a coefficient is too long for a stepper"); }
            powers += fmt::format("{}{}", powers.empty() ? "" : ", ", exponent);
        }
        for (const double part : expansion(term.coefficient)) {
            if (part == 0.0) { continue; }
            writer.line("{{{}, {{{}}}}},", literal(part), powers);
            ++count;
        }
    }
    return count;
}

std::string_view role(Zero zero) {
    switch (zero) {
    case Zero::harmless: return "numerator";
    case Zero::pole: return "pole";
    case Zero::weight: return "weight";
    }
    HVI_CHECK(false);
    return {};
}

std::string_view code(Zero zero) {
    switch (zero) {
    case Zero::harmless: return "ok";
    case Zero::pole: return "pole";
    case Zero::weight: return "zero_weight";
    }
    HVI_CHECK(false);
    return {};
}

// ---- struct Coefficients ----

/// The body of the constructor.
class Body {
public:
    Body(Writer& writer, const FromParameter& from) : writer_(writer), from_(from) {}

    /// Returns the name of the variable that holds a weight.
    std::string weight(std::size_t place) {
        return variable(fmt::format("b_{}", place + 1), from_.numbers.weights[place]);
    }
    std::string other(std::string_view name, std::size_t place) {
        return variable(std::string(name), from_.numbers.others[place]);
    }

private:
    std::string variable(const std::string& name, const Quotient& quotient) {
        for (const auto& [known, written] : written_) {
            if (*written == quotient) { return known; }
        }
        written_.emplace_back(name, &quotient);
        std::string exponents;
        for (const unsigned exponent : quotient.exponents) {
            exponents += fmt::format("{}{}", exponents.empty() ? "" : ", ", exponent);
        }
        writer_.line("const auto {} = at.quotient({}, {}, Exponents{{{}}});", name,
                     quotient.numerator, literal(quotient.divisor.nearest_double()), exponents);
        return name;
    }

    Writer& writer_;
    const FromParameter& from_;
    std::vector<std::pair<std::string, const Quotient*>> written_;
};

void write_weights(Writer& writer, Body& body, std::string_view table,
                   const std::vector<StageValue>& values,
                   const std::vector<std::optional<std::size_t>>& merged) {
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (!values[i].weight.has_parameters()) {
            writer.line("{}[{}] = {};", table, i, initializer(weight(values[i])));
            continue;
        }
        const std::string name = merged[i]
                                     ? body.other(fmt::format("{}_{}", table, i + 1), *merged[i])
                                     : body.weight(values[i].stages.front());
        writer.line("{}[{}] = hvi::detail::to_scalar<Scalar>({});", table, i, name);
    }
}

void write_m(Writer& writer, Body& body, const Step& step) {
    const RoundedCoefficients& constants = std::get<PairStep>(step.form).coefficients;
    for (std::size_t i = 0; i < step.positions.size(); ++i) {
        for (std::size_t j = 0; j < step.momenta.size(); ++j) {
            if (step.partner == Partner::same && j > i) { continue; }
            const auto& ratio = step.from_parameter->m[i][j];
            const std::string m = fmt::format("m[{}][{}]", i, j);
            const std::string mt = fmt::format("{}[{}][{}]", table_mt(step), j, i);
            if (ratio) {
                const std::string a = body.other(fmt::format("a_{}_{}", i + 1, j + 1), ratio->a);
                writer.line("exact = hvi::detail::round_complementary({} / {}, {}, {}) && exact;",
                            a, body.weight(ratio->b), m, mt);
                continue;
            }
            const auto assign = [&](const std::string& entry, const Number& exact,
                                    const Rounded& value) {
                if (equal(exact, 0)) { return; }
                writer.line("{} = {};", entry, initializer({entry, value, exact_text(exact)}));
            };
            assign(m, step.m[i][j], constants.m[i][j]);
            if (m != mt) { assign(mt, Number(1) - step.m[i][j], constants.mt[j][i]); }
        }
    }
}

void write_times(Writer& writer, Body& body, const Step& step) {
    for (std::size_t i = 0; i < step.c.size(); ++i) {
        const auto& place = step.from_parameter->c[i];
        const std::string name = fmt::format("c_{}", i + 1);
        if (place) {
            writer.line("c[{}] = hvi::detail::to_scalar<Scalar>({});", i, body.other(name, *place));
        } else if (!equal(step.c[i], 0)) {
            writer.line("c[{}] = {};", i,
                        initializer({name, nearest(step.c[i]), exact_text(step.c[i])}));
        }
    }
}

/// Returns the tables of weights. NOTE: in an explicit step every m_ij is 0 or 1 and leaves no
/// trace.
std::vector<std::pair<std::string, std::size_t>> weight_tables(const Step& step) {
    if (!step.is_explicit() && weights_p(step) == weights_q(step)) {
        return {{weights_p(step), step.positions.size()}};
    }
    return {{"b_p", step.positions.size()}, {"b_q", step.momenta.size()}};
}

void write_members(Writer& writer, const Step& step) {
    for (const auto& [table, count] : weight_tables(step)) {
        writer.line("Scalar {}[{}]{{}};", table, count);
    }
    if (!step.is_explicit()) {
        const std::size_t rows = step.positions.size();
        const std::size_t columns = step.momenta.size();
        writer.line("Scalar m[{}][{}]{{}};", rows, columns);
        if (step.partner != Partner::same) { writer.line("Scalar mt[{}][{}]{{}};", columns, rows); }
    }
    if (step.depends_on_time()) { writer.line("Scalar c[{}]{{}};", step.c.size()); }
    writer.line("Status status;  ///< ok, or why there is no method at this {}",
                step.from_parameter->numbers.parameter);
}

std::string coefficients_comment(const Step& step) {
    const std::string& w = step.from_parameter->numbers.parameter;
    const std::string_view what =
        step.is_explicit()
            ? "The weights of forces, b_p, and of velocities, b_q,"
            : (step.partner == Partner::same
                   ? "The weights b and m_ij = a_ij/b_j, with m_ij + m_ji = 1 exactly,"
                   : "The weights b, m_ij = a_ij/b_j and mt_ij = a~_ij/b_j, with m_ij + mt_ji = 1 "
                     "exactly,");
    return fmt::format("{}{} at one {}, right to a few units in the last place of the largest one.",
                       what, step.depends_on_time() ? " and the times c" : "", w);
}

std::string functions_text(const Step& step) {
    const ParametricNumbers& numbers = step.from_parameter->numbers;
    Writer writer(1);
    writer.comment(phases_comment(numbers)).open("struct Functions {{");
    write_generators(writer, numbers.generators);
    Writer terms(3);
    std::size_t total = 0;
    std::vector<std::string> functions;
    for (const ParameterFunction& function : numbers.functions) {
        terms.comment(formula(function.function, names(numbers)));
        const std::size_t count = write_terms(terms, function.function);
        functions.push_back(fmt::format("{{hvi::detail::EntireFunction::Role::{}, {}, {}}},",
                                        role(function.zero), count, function.order));
        total += count;
    }
    writer.open("static constexpr std::array<hvi::detail::Term<{}>, {}> terms{{{{",
                numbers.generators.count(), total);
    writer.insert(terms.str()).close("}};");
    writer.comment("Each of the next so many terms, vanishing at 0 to this order.");
    writer.open("static constexpr std::array<hvi::detail::EntireFunction, {}> functions{{{{",
                functions.size());
    for (const std::string& line : functions) { writer.line("{}", line); }
    writer.close("}};");
    writer.line("static constexpr std::size_t length = {};", numbers.series.length);
    writer.line("static constexpr double switch_point = {:a};",
                std::ldexp(1.0, numbers.series.switch_exponent));
    writer.line("static constexpr Status::Code at_zero = Status::Code::{};", code(numbers.at_zero));
    return writer.close("};").str();
}

}  // namespace

std::string parameter_text(const Step& step) {
    if (!step.from_parameter) { return {}; }
    const FromParameter& from = *step.from_parameter;
    const std::string& w = from.numbers.parameter;
    Writer writer(1);
    writer.comment(coefficients_comment(step), "/// ").open("struct Coefficients {{");
    write_members(writer, step);
    writer.blank().open("explicit Coefficients(Scalar parameter) {{");
    writer.line("using Exponents = std::array<unsigned char, {}>;",
                from.numbers.weights.front().exponents.size());
    writer.line("const hvi::detail::AtParameter<Functions, Scalar> at(parameter);");
    writer.line("status = at.status();").line("if (!status.ok()) {{ return; }}");
    Body body(writer, from);
    for (const auto& [table, count] : weight_tables(step)) {
        const bool of_q = table == "b_q";
        write_weights(writer, body, table, of_q ? step.momenta : step.positions,
                      of_q ? from.momenta : from.positions);
    }
    write_times(writer, body, step);
    if (!step.is_explicit()) {
        writer.line("bool exact = true;");
        write_m(writer, body, step);
        writer.line("if (!exact) {{ status = Status(Status::Code::pole); }}");
    }
    writer.close().close("};").blank();
    writer.comment(fmt::format("Whether there is a method at this {0}: there is none within "
                               "2^-20 max(1, |{0}|) of the places that are listed above.",
                               w),
                   "/// ");
    writer.line("[[nodiscard]] Status status() const {{ return coefficients_.status; }}").blank();
    writer.comment("What the constructor computed; zeros unless the status is ok.", "/// ");
    writer.line(
        "[[nodiscard]] const Coefficients& coefficients() const {{ return coefficients_; }}");
    return writer.str();
}

std::string functions_of_parameter(const Step& step) {
    const std::string text = functions_text(step);
    return are_rounded(parameter_text(step)) ? with_rounding_declared(text) : text;
}

std::string coefficients_member(const Step& step) {
    return step.from_parameter ? "Coefficients coefficients_;" : "";
}

std::string coefficients_reference(const Step& step) {
    return step.from_parameter ? "const Coefficients& c;" : "";
}

std::string_view coefficients_argument(const Step& step) {
    return step.from_parameter ? "coefficients_, " : "";
}

std::string begins(const Step& step) {
    Writer writer(2);
    if (step.from_parameter) {
        writer.line("if (!coefficients_.status.ok()) {{ return coefficients_.status; }}");
    }
    if (step.container == Container::vectors) {
        writer.line("if (!system_.fits(x.q, x.p)) {{ return "
                    "Status(Status::Code::dimension_mismatch); }}");
    }
    return writer.str();
}

}  // namespace hvi::gen
