// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/interpret/tape.hpp"

#include <bit>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include <hvi/detail/numbers/more_math.hpp>

#include "generator/emit/system/scene_code.hpp"
#include "generator/support/error.hpp"

namespace hvi::gen {

namespace {

using Arguments = std::array<double, 4>;
using FunctionOfNumbers = double (*)(const Arguments&);

/// Returns functions by their names in a graph. NOTE: the functions that code of write_code()
/// calls.
const std::map<std::string, FunctionOfNumbers>& known_functions() {
    static const std::map<std::string, FunctionOfNumbers> functions = {
#define HVI_FUNCTION(name, latex, domain, cuts, parity, runtime, derivative)                       \
    {#name, [](const Arguments& x) { return std::name(x[0]); }},
#define HVI_FUNCTION_OF_TWO(name, latex, by_a, by_b)                                               \
    {#name, [](const Arguments& x) { return std::name(x[0], x[1]); }},
#define HVI_KINK(name, latex, derivative)                                                          \
    {#name, [](const Arguments& x) { return math::name<double>(x[0]); }},
#define HVI_CHOICE(name, latex, written)                                                           \
    {#name, [](const Arguments& x) { return math::name<double>(x[0], x[1]); }},
#include "generator/expr/functions.def"
        {"pow", [](const Arguments& x) { return std::pow(x[0], x[1]); }},
        {"if<", [](const Arguments& x) { return math::if_less<double>(x[0], x[1], x[2], x[3]); }},
        {"if<=",
         [](const Arguments& x) { return math::if_at_most<double>(x[0], x[1], x[2], x[3]); }},
    };
    return functions;
}

double value_of_constant(const Expression& expression) {
    constexpr std::size_t of_double = 1;
    const std::optional<Dyadic> value = rounded_value(expression)[of_double];
    HVI_CHECK(value.has_value());  // or the header of the stepper could not be written
    return value->to_double();
}

}  // namespace

Slot Slots::add(double number) {
    numbers_.push_back(number);
    return static_cast<Slot>(numbers_.size() - 1);
}

Slot Slots::of(double constant) {
    const auto bits = std::bit_cast<std::uint64_t>(constant);
    const auto found = constants_.find(bits);
    return found != constants_.end() ? found->second
                                     : constants_.emplace(bits, add(constant)).first->second;
}

Slot Slots::of(Node node) {
    if (graph_->is_number({{1, 1}, node})) return of(1.0);
    const auto found = nodes_.find(node);
    if (found != nodes_.end()) return found->second;
    const Computation& computation = graph_->at(node);
    const Slot slot = computation.operation == Operation::constant
                          ? of(value_of_constant(computation.constant))
                          : next();
    return nodes_.emplace(node, slot).first->second;
}

/// Writes instructions as KernelWriter writes C++.
class TapeWriter {
public:
    TapeWriter(Tape& tape, const Kernel& kernel, Slots& slots)
        : tape_(tape), kernel_(kernel), slots_(slots), graph_(slots.graph()) {
        for (const Node node : kernel.given) values_[node] = slots.of(node);
        for (const Node node : kernel.nodes)
            if (!kernel.is_divisor(node)) values_[node] = code(graph_.at(node));
        for (const Scaled& result : kernel.results)
            tape.results_.push_back(graph_.is_number(result) ? literal(result.factor)
                                                             : scaled(result));
    }

private:
    using Act = Tape::Act;

    Slot put(Act act, Slot a, Slot b) {
        const Slot out = slots_.next();
        tape_.instructions_.push_back({act, out, a, b});
        return out;
    }

    [[nodiscard]] Slot literal(const SmallFraction& fraction) {
        return slots_.of(static_cast<double>(fraction.above) / static_cast<double>(fraction.below));
    }

    /// Returns the slot of a node. NOTE: a divisor that turns out to be no divisor is computed
    /// where it stands.
    Slot at(Node node) {
        if (graph_.is_number({{1, 1}, node})) return slots_.of(1.0);
        const auto found = values_.find(node);
        if (found != values_.end()) return found->second;
        HVI_CHECK(kernel_.is_divisor(node));
        return code(graph_.at(node));
    }

    Slot code(const Computation& computation) {
        switch (computation.operation) {
        case Operation::sum: return sum(computation.terms);
        case Operation::product:
            return product(computation.arguments.front(), computation.arguments.back());
        case Operation::inverse:
        case Operation::inverse_square_root:
            return put(Act::divide, slots_.of(1.0), below(computation));
        case Operation::square_root: return put(Act::root, at(computation.arguments.front()), 0);
        case Operation::power: return call("pow", computation);
        case Operation::call: return call(computation.name, computation);
        case Operation::constant:
        case Operation::input: break;
        }
        HVI_CHECK(false);
        return 0;
    }

    /// Returns the slot of factor * node, for a positive factor.
    Slot term(const SmallFraction& factor, Node node) {
        if (graph_.is_number({factor, node})) return literal(factor);
        if (factor.is_one()) return at(node);
        const Slot value = at(node);
        return put(Act::multiply, literal(factor), value);
    }

    Slot scaled(const Scaled& a) {
        if (a.factor.above > 0) return term(a.factor, a.node);
        return put(Act::negate, term(-a.factor, a.node), 0);
    }

    Slot sum(const std::vector<Scaled>& terms) {
        if (terms.size() == 1) return scaled(terms.front());
        Slot total = term(terms.front().factor, terms.front().node);
        for (std::size_t k = 1; k < terms.size(); ++k) {
            const bool negative = terms[k].factor.above < 0;
            const Slot next = term(terms[k].factor.size(), terms[k].node);
            total = put(negative ? Act::subtract : Act::add, total, next);
        }
        return total;
    }

    Slot product(Node a, Node b) {
        if (kernel_.is_divisor(a)) std::swap(a, b);
        const Slot left = at(a);
        if (!kernel_.is_divisor(b)) return put(Act::multiply, left, at(b));
        return put(Act::divide, left, below(graph_.at(b)));
    }

    /// Returns the slot of an inverse's divisor.
    Slot below(const Computation& computation) {
        const Slot argument = at(computation.arguments.front());
        return computation.operation == Operation::inverse_square_root ? put(Act::root, argument, 0)
                                                                       : argument;
    }

    Slot call(const std::string& name, const Computation& computation) {
        const auto function = known_functions().find(name);
        HVI_CHECK(function != known_functions().end());
        Tape::Call call{function->second, {}};
        for (std::size_t k = 0; k < computation.arguments.size(); ++k)
            call.arguments.at(k) = at(computation.arguments[k]);
        tape_.calls_.push_back(call);
        return put(Act::call, 0, static_cast<Slot>(tape_.calls_.size() - 1));
    }

    Tape& tape_;
    const Kernel& kernel_;
    Slots& slots_;
    const Graph& graph_;
    std::map<Node, Slot> values_;
};

Tape::Tape(const Kernel& kernel, Slots& slots) { TapeWriter(*this, kernel, slots); }

void Tape::run(double* numbers) const {
    for (const auto& [act, out, a, b] : instructions_) {
        switch (act) {
        case Act::add: numbers[out] = numbers[a] + numbers[b]; break;
        case Act::subtract: numbers[out] = numbers[a] - numbers[b]; break;
        case Act::multiply: numbers[out] = numbers[a] * numbers[b]; break;
        case Act::divide: numbers[out] = numbers[a] / numbers[b]; break;
        case Act::negate: numbers[out] = -numbers[a]; break;
        case Act::root: numbers[out] = std::sqrt(numbers[a]); break;
        case Act::call: {
            const Call& call = calls_[b];
            std::array<double, 4> arguments{};
            for (std::size_t k = 0; k < arguments.size(); ++k)
                arguments[k] = numbers[call.arguments[k]];
            numbers[out] = call.function(arguments);
            break;
        }
        }
    }
}

}  // namespace hvi::gen
