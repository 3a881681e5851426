// `hvi-gen scheme`: the equations of a step for a Hamiltonian.
// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/cli/commands.hpp"
#include "generator/cli/method.hpp"
#include "generator/hamiltonian/legendre.hpp"
#include "generator/read/own_functions.hpp"
#include "generator/render/equations.hpp"

namespace hvi::gen {

namespace {

template <class Equations>
std::string rendered(const Equations& step, SchemeOptions::Format format) {
    using Format = SchemeOptions::Format;
    switch (format) {
    case Format::text: return render_text(step);
    case Format::json: return render_json(step);
    case Format::latex: return render_latex(step);
    }
    HVI_CHECK(false);
    return {};
}

/// H itself, or that of L.
Hamiltonian hamiltonian_of(const Hamiltonian& hamiltonian) { return hamiltonian; }
Hamiltonian hamiltonian_of(const Lagrangian& lagrangian) { return legendre_transform(lagrangian); }

/// For a function that is H or L.
template <class Function>
std::string equations(const Method& method, const Function& function,
                      const SchemeOptions& options) {
    if (options.lagrangian) return rendered(lagrangian_equations(method, function), options.format);
    return rendered(
        step_equations(method, hamiltonian_of(function), options.generating, options.series),
        options.format);
}

}  // namespace

void run(const SchemeOptions& options) {
    const auto [method, system] = read_system(options.method, options.system);
    std::visit(
        [](const auto& function) {
            refuse_own_functions(function.expression, function.source,
                                 "the exact equations of a step");
        },
        system);
    const auto write = [&, &read = method](const auto& function) {
        write_result(options.output, equations(read, function, options));
    };
    std::visit(write, system);
}

}  // namespace hvi::gen
