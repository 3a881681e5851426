// `hvi-gen tableau`: the exact tableau of a method, in one of five formats.
// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/cli/commands.hpp"
#include "generator/cli/method.hpp"
#include "generator/render/render.hpp"
#include "generator/support/progress.hpp"

namespace hvi::gen {

namespace {

std::string rendered(const Tableau& tableau, const TableauOptions& options) {
    const Progress::Stage stage("writing the tableau");
    using Format = TableauOptions::Format;
    switch (options.format) {
    case Format::text: return render_text(tableau, options.digits);
    case Format::json: return render_json(tableau, options.digits);
    case Format::latex: return render_latex(tableau, options.digits);
    case Format::markdown: return render_markdown(tableau, options.digits);
    case Format::csv: return render_csv(tableau, options.digits);
    }
    HVI_CHECK(false);
    return {};
}

}  // namespace

void run(const TableauOptions& options) {
    write_result(options.output, rendered(tableau_of(options.method), options));
}

}  // namespace hvi::gen
