// `hvi-gen scheme`: the equations of a step for a Hamiltonian.
// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/cli/commands.hpp"
#include "generator/cli/method.hpp"
#include "generator/hamiltonian/legendre.hpp"
#include "generator/options/option_table.hpp"
#include "generator/read/names.hpp"
#include "generator/read/own_functions.hpp"
#include "generator/read/unrolling.hpp"
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

/// Returns H itself, or the Hamiltonian of L.
Hamiltonian hamiltonian_of(const Hamiltonian& hamiltonian) { return hamiltonian; }
Hamiltonian hamiltonian_of(const Lagrangian& lagrangian) { return legendre_transform(lagrangian); }

/// Returns the equations for a function that is H or L.
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

/// Returns equations in which sums stay sums.
std::string printed_with_sums(const MethodAndScene& both, const SchemeOptions& options) {
    Scene scene = both.scene;
    const UnrollWish& wish = options.system.sums;
    if (!wish.needed_for.empty()) {
        throw NoLoops(wish.needed_for + " is not built where sums stay loops",
                      whole(scene.function.source));
    }
    const std::vector<std::string> of_method = parameter_names(both.method);
    for (const Parameter& value : both.values)
        if (!contains(of_method, value.name)) scene.origin += parameter_option(value);
    scene.origin += options_for({.unroll = wish.choice});
    return rendered(loop_equations(both.method, scene, both.values), options.format);
}

std::string printed_written_out(const MethodAndScene& both, WrittenOutScene scene,
                                const SchemeOptions& options) {
    function_of(scene).origin += options_for({.unroll = options.system.sums.choice});
    return std::visit([&](const auto& of) { return printed(both.method, of, options); },
                      scene.mechanics);
}

std::string printed(const SchemeOptions& options) {
    if (!options.system.scene) {
        const auto [method, hamiltonian] = read_hamiltonian(options.method, options.system);
        return printed(method, hamiltonian, options);
    }
    const MethodAndScene both = read_both(options.method, options.system);
    refuse_rotations(both.scene, "`scheme`");
    refuse_scale(both.scene, "`scheme`");
    return by_unrolling(
        both.scene, options.system.sums,
        [&](const UnrollDecision&) { return printed_with_sums(both, options); },
        [&](const WrittenOutScene& scene, const UnrollDecision&) {
            return printed_written_out(both, scene, options);
        });
}

}  // namespace

void run(const SchemeOptions& options) { write_result(options.output, printed(options)); }

}  // namespace hvi::gen
