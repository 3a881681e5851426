// `hvi-gen check`: proved properties of a method.
// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/cli/commands.hpp"
#include "generator/cli/keeping.hpp"
#include "generator/cli/method.hpp"
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
    return of_scene;
}

/// Writes `whole`, the result that contains `findings`. `method`: an empty one for a tableau.
void write(const CheckOptions& options, const std::optional<Scene>& scene, const Method& method,
           const auto& findings, const auto& whole) {
    const Progress::Stage stage("writing the certificate");
    std::optional<SceneStatements> of_scene;
    if (scene) { of_scene = statements_of(options, *scene, method, facts_of(findings)); }
    const bool as_json = options.format == CheckOptions::Format::json;
    const std::string text = as_json ? render_json(whole, of_scene) : render_text(whole, of_scene);
    if (options.plot) { write_result(options.plot->text, plot(findings, options.plot)); }
    write_result(options.output, text);
}

}  // namespace

void run(const CheckOptions& options) {
    std::optional<Scene> scene;
    if (options.tableau) {
        if (options.system) { scene = read_scene_alone({}, *options.system); }
        const Audit found =
            audit(coefficients_of(*options.tableau, options.method), options.max_order);
        write(options, scene, {}, found.certificate, found);
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
    std::visit(
        [&](const auto& certificate) { write(options, scene, method, certificate, certificate); },
        certify(method, options.max_order));
}

}  // namespace hvi::gen
