// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/hamiltonian/ginac_functions.hpp"

#include <map>

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

unsigned registered(const Options& options) { return GiNaC::function::register_new(options); }

/// Those that GiNaC has not, by their names.
const std::map<std::string, unsigned>& ours() {
    static const std::map<std::string, unsigned> serials{
        {"log10", registered(Options("log10", 1).derivative_func(log10_slope))},
        {"cbrt", registered(Options("cbrt", 1).derivative_func(cbrt_slope))},
        {"erf", registered(Options("erf", 1).derivative_func(erf_slope))},
        {"erfc", registered(Options("erfc", 1).derivative_func(erfc_slope))},
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

}  // namespace hvi::gen
