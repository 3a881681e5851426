// `hvi-gen check`: proved properties of a method.
// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/cli/commands.hpp"
#include "generator/cli/keeping.hpp"
#include "generator/cli/method.hpp"
#include "generator/plan/starting_values.hpp"
#include "generator/render/certificate.hpp"
#include "generator/render/stability_svg.hpp"
#include "generator/render/statements.hpp"
#include "generator/support/error.hpp"
#include "generator/support/progress.hpp"
#include "generator/symmetry/watched.hpp"

namespace hvi::gen {

namespace {

std::string plot(const Findings& findings, const Given& file) {
    const Place place = whole(file);
    if (!findings.oscillator) {
        throw MathError("there is no picture of coefficients that are too long, or known to some "
                        "digits only",
                        place, "give exact ones, or those of a known method to the last digit");
    }
    if (!findings.stability) {
        throw InputError("a picture needs a value for the parameter " + findings.parameters.front(),
                         place, "for example --param " + findings.parameters.front() + "=1");
    }
    const std::string& name = findings.name.empty() ? findings.origin : findings.name;
    return stability_svg(name, *findings.oscillator, *findings.stability);
}

KeepingFacts facts_of(const Certificate& certificate) {
    return {certificate.symplectic, certificate.common_weights, certificate.runge_kutta, false};
}

KeepingFacts facts_of(const RuleCertificate& certificate) {
    return {certificate.symplectic, {}, {false, true}, true};
}

SceneStatements statements_of(const CheckOptions& options, const Scene& scene, const Method& method,
                              KeepingFacts facts) {
    SceneStatements of_scene;
    of_scene.name = title(scene);
    of_scene.left_out = "--no-symmetries is given";
    if (options.symmetries) {
        of_scene.found = symmetries_within_a_second(scene, options.system->sums);
        of_scene.left_out = symmetry_work_is_spent;
    }
    if (!of_scene.found) return of_scene;
    add_parts(facts, method, scene, options.system->sums, *of_scene.found);
    of_scene.statements = statements(*of_scene.found, facts);
    if (options.sweeps.choice > 0) {
        of_scene.exception = ", but for the last change of each step";
    }
    return of_scene;
}

/// Writes `whole`, the result that contains `findings`. `method`: an empty one for a tableau.
void write(const CheckOptions& options, const std::optional<Scene>& scene, const Method& method,
           const KeepingFacts& facts, const auto& findings, const auto& whole) {
    const Progress::Stage stage("writing the certificate");
    std::optional<SceneStatements> of_scene;
    if (scene) { of_scene = statements_of(options, *scene, method, facts); }
    const bool as_json = options.format == CheckOptions::Format::json;
    const std::string text = as_json ? render_json(whole, of_scene) : render_text(whole, of_scene);
    if (options.plot) { write_result(options.plot->text, plot(findings, options.plot)); }
    write_result(options.output, text);
}

[[noreturn]] void refuse_sweeps(const CheckOptions& options, const std::string& obstacle) {
    throw InputError("--sweeps does not go with this method: " + obstacle, options.sweeps.place,
                     "leave it out");
}

/// Returns the polynomial that a stepper extrapolates slopes by. Coefficients for each value of a
/// parameter are not built.
std::optional<ExtrapolatedSlopes> extrapolated_slopes(const Tableau& tableau) {
    if (!tableau.parameters.empty()) { return {}; }
    const auto polynomial = starting_polynomial({tableau.c, tableau.b});
    if (!polynomial) { return {}; }
    return ExtrapolatedSlopes{polynomial->sizes.size(), polynomial->degree};
}

void check_sweeps(const CheckOptions& options, const std::optional<Scene>& scene,
                  const Method& method) {
    const DerivedMethod derived = derive_any(method);
    const auto* const tableau = std::get_if<Tableau>(&derived);
    if (!method.splitting.empty()) { refuse_sweeps(options, "nothing is iterated by a splitting"); }
    if (tableau == nullptr) {
        refuse_sweeps(options,
                      "it is not built for steps that are solved for the velocities of a curve");
    }
    const SweptCertificate found = certify_sweeps(method, *tableau, options.sweeps.choice,
                                                  options.max_order, extrapolated_slopes(*tableau));
    if (found.is_empty()) {
        refuse_sweeps(options, "nothing is iterated, or not all stages at once");
    }
    write(options, scene, method, keeping_facts(derived), found, found);
}

}  // namespace

void run(const CheckOptions& options) {
    std::optional<Scene> scene;
    if (options.tableau) {
        if (options.system) { scene = read_scene_alone({}, *options.system); }
        const Audit found =
            audit(coefficients_of(*options.tableau, options.method), options.max_order);
        write(options, scene, {}, facts_of(found.certificate), found.certificate, found);
        return;
    }
    Method method;
    if (options.system) {
        MethodAndScene both = read_both(options.method, *options.system);
        method = std::move(both.method);
        scene = std::move(both.scene);
    } else {
        method = method_of(options.method);
    }
    if (options.sweeps.choice > 0) {
        check_sweeps(options, scene, method);
        return;
    }
    std::visit(
        [&](const auto& certificate) {
            write(options, scene, method, facts_of(certificate), certificate, certificate);
        },
        certify(method, options.max_order));
}

}  // namespace hvi::gen
