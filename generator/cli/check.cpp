// `hvi-gen check`: what a method can do, with proof.
// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/cli/commands.hpp"
#include "generator/cli/method.hpp"
#include "generator/render/certificate.hpp"
#include "generator/render/stability_svg.hpp"
#include "generator/support/error.hpp"

namespace hvi::gen {

namespace {

std::string plot(const Certificate& certificate) {
    if (!certificate.stability) {
        throw InputError("a picture needs a value for the parameter " +
                             certificate.parameters.front(),
                         {}, "for example --param " + certificate.parameters.front() + "=1");
    }
    const std::string& name = certificate.name.empty() ? certificate.origin : certificate.name;
    return stability_svg(name, certificate.oscillator, *certificate.stability);
}

}  // namespace

void run(const CheckOptions& options) {
    const Certificate certificate = certify(tableau_of(options.method), options.max_order);
    const bool as_json = options.format == CheckOptions::Format::json;
    if (options.plot) { write_result(*options.plot, plot(certificate)); }
    write_result(options.output, as_json ? render_json(certificate) : render_text(certificate));
}

}  // namespace hvi::gen
