// Headers for quadratic Hamiltonians: a step is one linear map.
// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/emit/steps/banner.hpp"
#include "generator/emit/steps/implicit_parts.hpp"
#include "generator/emit/steps/system_part.hpp"
#include "src/hvi/version.hpp"

namespace hvi::gen {

namespace {

/// NOTE: of __float128 std::numeric_limits and std::abs know nothing under -std=c++17.
Holes words_for_numbers(const SceneWishes& wishes) {
    const bool quad = wishes.float128;
    return {{"library", std::string(library(wishes))},
            {"abs", quad ? "hvi::detail::abs" : "std::abs"},
            {"infinity",
             quad ? "hvi::detail::infinity<Scalar>" : "std::numeric_limits<Scalar>::infinity()"},
            {"is_finite",
             quad ? "< hvi::detail::infinity<Scalar>" : "<= std::numeric_limits<Scalar>::max()"}};
}

}  // namespace

std::string emit_one(const OneStepMethod& method, const Step& step, const TabulatedStep& form,
                     const EmitOptions& options) {
    const SystemPart system = system_part(method, step, options);
    const System& H = *options.system;
    Holes holes = holes_of(system);
    holes.merge(Holes{
        {"banner", banner(method, step, options)},
        {"format", std::to_string(hvi::runtime_format)},
        {"math", options.wishes.float128 ? "#include <hvi/detail/numbers/math.hpp>" : ""},
        {"constants", with_rounding(coefficients_text(step, form.coefficients))},
        {"tables", fmt::format("m, {}, {}, {}", table_mt(step), weights_q(step), weights_p(step))},
        {"n", std::to_string(H.degrees_of_freedom())}});
    if (form.as == TabulatedStep::As::matrix) { return fill("increments.hpp.in", holes); }
    holes["shifted"] = has_linear_part(H.structure) ? "true" : "false";
    holes.merge(words_for_numbers(options.wishes));
    return fill("linear.hpp.in", holes);
}

}  // namespace hvi::gen
