// `hvi-gen scheme`: the equations of a step for a Hamiltonian.
// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/cli/commands.hpp"
#include "generator/cli/method.hpp"
#include "generator/hamiltonian/legendre.hpp"
#include "generator/read/no_loops.hpp"
#include "generator/read/own_functions.hpp"
#include "generator/render/equations.hpp"

namespace hvi::gen {

namespace {

std::string printed(const SchemeOptions& options);

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

template <class Function>
std::string printed(const Method& method, const Function& function, const SchemeOptions& options) {
    refuse_own_functions(function.expression, function.source, "the exact equations of a step");
    return equations(method, function, options);
}

/// Writes equations of sums that stay loops; what these turn out not to have is written out, where
/// that is left open.
std::string printed(const Method& method, const LargeSystem& system, const SchemeOptions& options) {
    const UnrollWish& wish = options.system.sums;
    try {
        if (!wish.needed_for.empty()) {
            throw NoLoops(wish.needed_for + " is not built where sums stay loops",
                          whole(system.scene.function.source));
        }
        return rendered(loop_equations(method, system.scene, system.values), options.format);
    } catch (const NoLoops&) {
        if (!may_write_out(system.scene, wish.choice)) throw;
    }
    SchemeOptions written = options;
    written.system.sums.choice = Unroll::yes;
    return printed(written);
}

std::string printed(const SchemeOptions& options) {
    const auto [method, system] = read_system(options.method, options.system);
    return std::visit(
        [&, &read = method](const auto& function) { return printed(read, function, options); },
        system);
}

}  // namespace

void run(const SchemeOptions& options) { write_result(options.output, printed(options)); }

}  // namespace hvi::gen
