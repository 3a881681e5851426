// `hvi-gen check`: what a method can do, with proof.
// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/cli/commands.hpp"
#include "generator/cli/method.hpp"
#include "generator/render/certificate.hpp"
#include "generator/render/stability_svg.hpp"
#include "generator/support/error.hpp"
#include "generator/support/progress.hpp"

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

void write(const CheckOptions& options, const Findings& findings, const auto& whole) {
    const Progress::Stage stage("writing the certificate");
    const bool as_json = options.format == CheckOptions::Format::json;
    if (options.plot) { write_result(options.plot->text, plot(findings, options.plot)); }
    write_result(options.output, as_json ? render_json(whole) : render_text(whole));
}

}  // namespace

void run(const CheckOptions& options) {
    if (options.tableau) {
        const Audit found =
            audit(coefficients_of(*options.tableau, options.method), options.max_order);
        write(options, found.certificate, found);
    } else {
        std::visit([&](const auto& certificate) { write(options, certificate, certificate); },
                   certify(method_of(options.method), options.max_order));
    }
}

}  // namespace hvi::gen
