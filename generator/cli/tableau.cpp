// `hvi-gen tableau`: the exact tableau of a method, in one of five formats.
// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/cli/commands.hpp"
#include "generator/cli/method.hpp"
#include "generator/exact/methods/galerkin_rule.hpp"
#include "generator/render/render.hpp"
#include "generator/support/progress.hpp"

namespace hvi::gen {

namespace {

std::string rendered(const auto& method, const TableauOptions& options) {
    const Progress::Stage stage("writing the tableau");
    using Format = TableauOptions::Format;
    switch (options.format) {
    case Format::text: return render_text(method, options.digits);
    case Format::json: return render_json(method, options.digits);
    case Format::latex: return render_latex(method, options.digits);
    case Format::markdown: return render_markdown(method, options.digits);
    case Format::csv: return render_csv(method, options.digits);
    }
    HVI_CHECK(false);
    return {};
}

}  // namespace

void run(const TableauOptions& options) {
    write_result(options.output,
                 std::visit([&](const auto& method) { return rendered(method, options); },
                            derive_any(method_of(options.method))));
}

}  // namespace hvi::gen
