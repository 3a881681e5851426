// `hvi-gen scheme`: the equations of a step for a Hamiltonian.
// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/cli/commands.hpp"
#include "generator/cli/method.hpp"
#include "generator/render/equations.hpp"

namespace hvi::gen {

namespace {

std::string rendered(const StepEquations& step, SchemeOptions::Format format) {
    using Format = SchemeOptions::Format;
    switch (format) {
    case Format::text: return render_text(step);
    case Format::json: return render_json(step);
    case Format::latex: return render_latex(step);
    }
    HVI_CHECK(false);
    return {};
}

}  // namespace

void run(const SchemeOptions& options) {
    const auto [method, hamiltonian] = read_system(options.method, options.system);
    const StepEquations step =
        step_equations(method, hamiltonian, options.generating, options.series);
    write_result(options.output, rendered(step, options.format));
}

}  // namespace hvi::gen
