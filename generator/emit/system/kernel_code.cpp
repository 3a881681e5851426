// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/emit/system/kernel_code.hpp"

#include <utility>

#include "generator/expr/functions.hpp"
#include "generator/expr/own_functions.hpp"
#include "generator/support/error.hpp"

namespace hvi::gen {

namespace {

/// Strength of the outermost operator of a piece of code.
enum class Binding { sum, product, sign, primary };

struct Code {
    std::string text;
    Binding binding = Binding::primary;
};

/// Returns the code as an operand of an operator that binds at least as tightly as `least`.
std::string operand(const Code& code, Binding least) {
    return code.binding < least ? "(" + code.text + ")" : code.text;
}

/// Returns a fraction as a literal where that is exact, else as a quotient that the compiler
/// computes.
Code literal_of(const SmallFraction& fraction) {
    constexpr long most_of_float = 1L << 24;
    const bool is_dyadic = (fraction.below & (fraction.below - 1)) == 0;
    if (is_dyadic && fraction.size().above <= most_of_float) {
        const double value =
            static_cast<double>(fraction.above) / static_cast<double>(fraction.below);
        return {fmt::format("Scalar({})", literal(value))};
    }
    return {fmt::format("Scalar({}) / Scalar({})", fraction.above, fraction.below),
            Binding::product};
}

/// Returns the name that the runtime has for a function.
std::string_view name_of_runtime(std::string_view name) {
    constexpr std::pair<std::string_view, std::string_view> hidden[] = {
        {"if<", "if_less"},
        {"if<=", "if_at_most"},
        {"tan<", "small_tan"},
        {"sin2<", "small_double_sin"},
    };
    for (const auto& [shown, in_runtime] : hidden) {
        if (shown == name) { return in_runtime; }
    }
    return name;
}

class KernelWriter {
public:
    KernelWriter(Writer& writer, const Graph& graph, const Kernel& kernel, NodeNames names,
                 std::string_view library, std::string_view value)
        : writer_(writer), graph_(graph), kernel_(kernel), library_(library), value_(value) {
        codes_[Graph::number(1).node] = literal_of({1, 1});
        for (auto& [node, name] : names) { codes_[node] = {std::move(name)}; }
        for (const Node node : kernel.nodes) { define(node); }
    }

    [[nodiscard]] std::vector<std::string> results() const {
        std::vector<std::string> texts;
        for (const Scaled& result : kernel_.results) {
            texts.push_back(graph_.is_number(result) ? literal_of(result.factor).text
                                                     : scaled(result).text);
        }
        return texts;
    }

private:
    /// Defines a variable for a node. NOTE: a divisor has none, as it stands below the bar where it
    /// is used.
    void define(Node node) {
        constexpr std::size_t longest = 60;
        Code code = this->code(graph_.at(node));
        const bool stays = kernel_.uses[node] == 1 && code.text.size() <= longest;
        if (!stays && !kernel_.is_divisor(node)) {
            const std::string name = fmt::format("t{}", ++locals_);
            writer_.line("const {} {} = {};", value_, name, code.text);
            code = {name};
        }
        codes_[node] = std::move(code);
    }

    [[nodiscard]] const Code& at(Node node) const {
        const auto found = codes_.find(node);
        HVI_CHECK(found != codes_.end());
        return found->second;
    }

    [[nodiscard]] Code code(const Computation& computation) const {
        switch (computation.operation) {
        case Operation::sum: return sum(computation.terms);
        case Operation::product:
            return product(computation.arguments.front(), computation.arguments.back());
        case Operation::inverse:
        case Operation::inverse_square_root:
            return {"Scalar(1.0) / " + below(computation), Binding::product};
        case Operation::square_root: return call("sqrt", computation);
        case Operation::power: return call("pow", computation);
        case Operation::call: return called(computation);
        case Operation::constant:
        case Operation::input: break;
        }
        HVI_CHECK(false);
        return {};
    }

    /// Returns factor * node, for a positive factor.
    [[nodiscard]] Code term(const SmallFraction& factor, Node node) const {
        if (graph_.is_number({factor, node})) { return literal_of(factor); }
        if (factor.is_one()) { return at(node); }
        return {literal_of(factor).text + " * " + operand(at(node), Binding::sign),
                Binding::product};
    }

    [[nodiscard]] Code scaled(const Scaled& a) const {
        if (a.factor.above > 0) { return term(a.factor, a.node); }
        return {"-" + operand(term(-a.factor, a.node), Binding::product), Binding::sign};
    }

    /// Returns a sum. NOTE: the first term is positive, unless it is the only one.
    [[nodiscard]] Code sum(const std::vector<Scaled>& terms) const {
        if (terms.size() == 1) { return scaled(terms.front()); }
        std::string text;
        for (const Scaled& part : terms) {
            const bool negative = part.factor.above < 0;
            if (!text.empty()) { text += negative ? " - " : " + "; }
            const Code code = term(part.factor.size(), part.node);
            text += operand(code, text.empty() ? Binding::sum : Binding::product);
        }
        return {std::move(text), Binding::sum};
    }

    [[nodiscard]] Code product(Node a, Node b) const {
        if (kernel_.is_divisor(a)) { std::swap(a, b); }
        if (kernel_.is_divisor(b)) {
            return {operand(at(a), Binding::product) + " / " + below(graph_.at(b)),
                    Binding::product};
        }
        if (at(b).binding == Binding::product && at(a).binding != Binding::product) {
            std::swap(a, b);
        }
        return {operand(at(a), Binding::product) + " * " + operand(at(b), Binding::sign),
                Binding::product};
    }

    /// Returns the divisor of an inverse.
    [[nodiscard]] std::string below(const Computation& computation) const {
        if (computation.operation == Operation::inverse_square_root) {
            return call("sqrt", computation).text;
        }
        return operand(at(computation.arguments.front()), Binding::sign);
    }

    [[nodiscard]] std::string arguments(const Computation& computation) const {
        std::string result;
        for (const Node argument : computation.arguments) {
            result += (result.empty() ? "" : ", ") + at(argument).text;
        }
        return result;
    }

    [[nodiscard]] Code call(const std::string& function, const Computation& computation) const {
        return {fmt::format("{}::{}({})", library_, function, arguments(computation))};
    }

    /// Returns a call. NOTE: functions with kinks are called in the runtime, with their type: they
    /// choose between numbers as well as between numbers side by side, and the library of C++ loses
    /// a NaN.
    [[nodiscard]] Code called(const Computation& computation) const {
        const std::string& name = computation.name;
        if (is_own_function(name)) { return of_user(computation); }
        if (is_smooth(name) && !is_hidden(name)) { return call(name, computation); }
        const std::string_view runtime = library_ == "std" ? "hvi::math" : library_;
        const std::string type = is_smooth(name) ? "" : fmt::format("<{}>", value_);
        return {fmt::format("{}::{}{}({})", runtime, name_of_runtime(name), type,
                            arguments(computation))};
    }

    /// Returns a call of a user's template for one number. NOTE: with its type, so that a function
    /// of the same name that C declares is not meant. Of numbers side by side each is computed
    /// alone.
    [[nodiscard]] Code of_user(const Computation& computation) const {
        const std::string function = fmt::format("::{}<Scalar>", computation.name);
        if (value_ == "Scalar") {
            return {fmt::format("{}({})", function, arguments(computation))};
        }
        return {fmt::format("hvi::detail::of_each<{}>([](const auto&... number) {{ return "
                            "{}(number...); }}, {})",
                            value_, function, arguments(computation))};
    }

    Writer& writer_;
    const Graph& graph_;
    const Kernel& kernel_;
    std::string_view library_, value_;
    std::map<Node, Code> codes_;
    int locals_ = 0;
};

}  // namespace

std::vector<std::string> write_code(Writer& writer, const Graph& graph, const Kernel& kernel,
                                    NodeNames names, std::string_view library,
                                    std::string_view value) {
    return KernelWriter(writer, graph, kernel, std::move(names), library, value).results();
}

}  // namespace hvi::gen
