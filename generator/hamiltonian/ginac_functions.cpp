// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/hamiltonian/ginac_functions.hpp"

#include <algorithm>
#include <map>

#include "generator/expr/functions.hpp"

namespace hvi::gen {

namespace {

using GiNaC::ex;
using Options = GiNaC::function_options;

ex log10_slope(const ex& x, unsigned /*which*/) { return 1 / (x * GiNaC::log(ex(10))); }

ex cbrt_slope(const ex& x, unsigned /*which*/) {
    return 1 / (3 * GiNaC::pow(applied("cbrt", {x}), 2));
}

ex erf_slope(const ex& x, unsigned /*which*/) {
    return 2 * GiNaC::exp(-GiNaC::pow(x, 2)) / GiNaC::sqrt(GiNaC::Pi);
}

ex erfc_slope(const ex& x, unsigned which) { return -erf_slope(x, which); }

ex abs_slope(const ex& x, unsigned /*which*/) { return applied("sign", {x}); }

ex sign_slope(const ex& /*x*/, unsigned /*which*/) { return 0; }

ex chosen(const std::string& function, const ex& a, const ex& b, const ex& yes, const ex& no) {
    return yes.is_equal(no) ? yes : applied(function, {a, b, yes, no});
}

using GiNaC::symbol;

ex min_slope(const ex& a, const ex& b, const symbol& by) {
    return chosen("if<", b, a, b.diff(by), a.diff(by));
}

ex max_slope(const ex& a, const ex& b, const symbol& by) {
    return chosen("if<", a, b, b.diff(by), a.diff(by));
}

ex if_less_slope(const ex& a, const ex& b, const ex& yes, const ex& no, const symbol& by) {
    return chosen("if<", a, b, yes.diff(by), no.diff(by));
}

ex if_at_most_slope(const ex& a, const ex& b, const ex& yes, const ex& no, const symbol& by) {
    return chosen("if<=", a, b, yes.diff(by), no.diff(by));
}

unsigned registered(const Options& options) { return GiNaC::function::register_new(options); }

/// Functions that GiNaC lacks, by their names.
const std::map<std::string, unsigned>& ours() {
    static const std::map<std::string, unsigned> serials{
        {"log10", registered(Options("log10", 1).derivative_func(log10_slope))},
        {"cbrt", registered(Options("cbrt", 1).derivative_func(cbrt_slope))},
        {"erf", registered(Options("erf", 1).derivative_func(erf_slope))},
        {"erfc", registered(Options("erfc", 1).derivative_func(erfc_slope))},
        // NOTE: GiNaC's abs is of complex numbers, and so is its derivative.
        {"abs", registered(Options("abs", 1).derivative_func(abs_slope).overloaded(2))},
        {"sign", registered(Options("sign", 1).derivative_func(sign_slope))},
        {"min", registered(Options("min", 2).expl_derivative_func(min_slope))},
        {"max", registered(Options("max", 2).expl_derivative_func(max_slope))},
        {"if<", registered(Options("if<", 4).expl_derivative_func(if_less_slope))},
        {"if<=", registered(Options("if<=", 4).expl_derivative_func(if_at_most_slope))},
    };
    return serials;
}

}  // namespace

ex applied(const std::string& function, const GiNaC::exvector& arguments) {
    const auto found = ours().find(function);
    const auto count = static_cast<unsigned>(arguments.size());
    const unsigned serial =
        found != ours().end() ? found->second : GiNaC::function::find_function(function, count);
    return GiNaC::function(serial, arguments);
}

bool has_kink_in(const ex& expression, const std::vector<GiNaC::symbol>& symbols) {
    const auto has_symbol = [&](const ex& part) {
        return std::any_of(symbols.begin(), symbols.end(),
                           [&](const GiNaC::symbol& symbol) { return part.has(symbol); });
    };
    if (GiNaC::is_a<GiNaC::function>(expression)) {
        const Function* const function =
            find_function(GiNaC::ex_to<GiNaC::function>(expression).get_name());
        if (function != nullptr && !function->is_smooth() && has_symbol(expression)) return true;
    }
    return std::any_of(expression.begin(), expression.end(),
                       [&](const ex& part) { return has_kink_in(part, symbols); });
}

GiNaC::exvector where_it_may_jump(const ex& expression) {
    GiNaC::exvector result;
    if (GiNaC::is_a<GiNaC::function>(expression)) {
        const std::string name = GiNaC::ex_to<GiNaC::function>(expression).get_name();
        if (name == "sign") result.push_back(expression.op(0));
        if (name == "if<" || name == "if<=") result.push_back(expression.op(0) - expression.op(1));
    }
    for (const ex& part : expression)
        for (const ex& jump : where_it_may_jump(part)) result.push_back(jump);
    return result;
}

}  // namespace hvi::gen
