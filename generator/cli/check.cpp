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

std::string plot(const Certificate& certificate, const Given& file) {
    const Place place = whole(file);
    if (!certificate.oscillator) {
        throw MathError("there is no picture of coefficients that are too long, or known to some "
                        "digits only",
                        place, "give exact ones, or those of a known method to the last digit");
    }
    if (!certificate.stability) {
        throw InputError("a picture needs a value for the parameter " +
                             certificate.parameters.front(),
                         place, "for example --param " + certificate.parameters.front() + "=1");
    }
    const std::string& name = certificate.name.empty() ? certificate.origin : certificate.name;
    return stability_svg(name, *certificate.oscillator, *certificate.stability);
}

void write(const CheckOptions& options, const Certificate& certificate, const auto& whole) {
    const Progress::Stage stage("writing the certificate");
    const bool as_json = options.format == CheckOptions::Format::json;
    if (options.plot) { write_result(options.plot->text, plot(certificate, options.plot)); }
    write_result(options.output, as_json ? render_json(whole) : render_text(whole));
}

}  // namespace

void run(const CheckOptions& options) {
    if (options.tableau) {
        const Audit found =
            audit(coefficients_of(*options.tableau, options.method), options.max_order);
        write(options, found.certificate, found);
    } else {
        const Certificate certificate = certify(method_of(options.method), options.max_order);
        write(options, certificate, certificate);
    }
}

}  // namespace hvi::gen
