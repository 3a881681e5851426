// Headers for quadratic Hamiltonians: a step is one linear map.
// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/emit/steps/curve_tables.hpp"
#include "generator/emit/steps/implicit_parts.hpp"
#include "generator/emit/steps/system_part.hpp"
#include "src/hvi/version.hpp"

namespace hvi::gen {

namespace {

/// Returns the words for numbers. NOTE: under -std=c++17 std::numeric_limits and std::abs do not
/// know __float128.
Holes words_for_numbers(const SceneWishes& wishes) {
    const bool quad = wishes.float128;
    return {{"library", std::string(library(wishes))},
            {"abs", quad ? "hvi::detail::abs" : "std::abs"},
            {"infinity",
             quad ? "hvi::detail::infinity<Scalar>" : "std::numeric_limits<Scalar>::infinity()"},
            {"is_finite",
             quad ? "< hvi::detail::infinity<Scalar>" : "<= std::numeric_limits<Scalar>::max()"}};
}

/// The tables as constants, as arguments of the map's constructor, and the header that they need.
struct Tables {
    std::string constants, arguments, include;
};

Tables tables_of(const Step& step, const RoundedCoefficients& coefficients) {
    return {coefficients_text(step, coefficients),
            fmt::format("m, {}, {}, {}", table_mt(step), weights_q(step), weights_p(step)), ""};
}

Tables tables_of(const Step& step, const TabulatedCurve& curve) {
    Writer writer(1);
    writer.insert(curve_tables(step, curve.form, curve.rounded, "(4.6)"));
    writer.insert(gamma_table(curve.steps));
    return {writer.str(), curve.steps.empty() ? "X, A, D, B, b" : "X, A, D, B, b, gamma",
            "#include <hvi/detail/coefficients/curve_coefficients.hpp>"};
}

}  // namespace

std::string emit_one(const OneStepMethod& method, const Step& step, const TabulatedStep& form,
                     const EmitOptions& options) {
    const SystemPart system = system_part(method, step, options);
    const System& H = *options.system;
    const Tables tables =
        std::visit([&](const auto& of) { return tables_of(step, of); }, form.tables);
    Holes holes = holes_of(system);
    holes.merge(
        Holes{{"format", std::to_string(hvi::runtime_format)},
              {"coefficients", tables.include},
              {"math", options.wishes.float128 ? "#include <hvi/detail/numbers/math.hpp>" : ""},
              {"constants", with_rounding(tables.constants)},
              {"tables", tables.arguments},
              {"n", std::to_string(H.degrees_of_freedom())}});
    if (form.as == TabulatedStep::As::matrix) { return fill("increments.hpp.in", holes); }
    holes["shifted"] = has_linear_part(H.structure) ? "true" : "false";
    holes.merge(words_for_numbers(options.wishes));
    return fill("linear.hpp.in", holes);
}

}  // namespace hvi::gen
