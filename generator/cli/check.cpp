// `hvi-gen check`: what a method can do, with proof.
// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/cli/commands.hpp"
#include "generator/cli/method.hpp"
#include "generator/render/certificate.hpp"

namespace hvi::gen {

void run(const CheckOptions& options) {
    const Certificate certificate = certify(tableau_of(options.method), options.max_order);
    const bool as_json = options.format == CheckOptions::Format::json;
    write_result(options.output, as_json ? render_json(certificate) : render_text(certificate));
}

}  // namespace hvi::gen
