// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/equations/quadratic.hpp"

#include <utility>

#include "generator/exact/expressions/evaluate.hpp"
#include "generator/exact/numbers/rational.hpp"
#include "generator/graph/written.hpp"
#include "generator/lower/constancy.hpp"
#include "generator/lower/system.hpp"
#include "generator/support/progress.hpp"

namespace hvi::gen {

namespace {

/// Converts nodes of constants and parameters to numbers of a field.
class Coefficients {
public:
    Coefficients(const Graph& graph, const Ground& ground) : graph_(graph), ground_(ground) {}

    /// Returns 0, and notes an obstacle, for a number that is not in the field of the ground.
    [[nodiscard]] Number number(const Scaled& coefficient) {
        const auto text = written(graph_, coefficient);
        if (!text) {
            obstacle_ = "a coefficient is too long to be written out";
            return Number(0);
        }
        std::string reason = "it has no closed form in our arithmetic";
        try {
            const Number result = evaluate_number(*text, nullptr, ground_);
            if (is_exact(result)) return result;
        } catch (const MathError& error) {
            reason = error.what();
        } catch (const InputError& error) { reason = error.what(); }
        obstacle_ = "the coefficient " + to_text(*text) + ": " + reason;
        return Number(0);
    }

    [[nodiscard]] const std::string& obstacle() const { return obstacle_; }

private:
    const Graph& graph_;
    const Ground& ground_;
    std::string obstacle_;
};

/// Returns the matrix S from its blocks, by the lower triangle.
NumberMatrix matrix(const Hessian& hessian, Coefficients& coefficients) {
    const std::size_t n = hessian.qq.size();
    NumberMatrix S(2 * n, NumberVector(2 * n));
    const auto set = [&](std::size_t i, std::size_t j, const Scaled& entry) {
        S[i][j] = S[j][i] = coefficients.number(entry);
    };
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = 0; j <= i; ++j) {
            set(i, j, hessian.qq[i][j]);
            set(n + i, n + j, hessian.conjugates[i][j]);
        }
        for (std::size_t j = 0; j < n; ++j) set(i, n + j, hessian.mixed[i][j]);
    }
    return S;
}

}  // namespace

QuadraticProof quadratic_form(const Hamiltonian& hamiltonian, const Ground& ground) {
    const Progress::Stage stage("looking whether the Hamiltonian is quadratic");
    System system = system_of(hamiltonian, parameter_names(hamiltonian));
    const Structure& found = system.structure;
    if (!found.has_linear_map) return {};
    const auto constant = at_origin(system.graph, function_of(system));
    if (!constant) return {std::nullopt, "H has no value for q = p = 0 as it is written"};
    Coefficients coefficients(system.graph, ground);
    QuadraticForm form;
    form.S = matrix(hessian_of(system), coefficients);
    for (const auto* slopes : {&found.by_q, &found.by_p})
        for (const Scaled& slope : *slopes) form.g.push_back(coefficients.number(slope));
    form.constant = coefficients.number(*constant);
    if (!coefficients.obstacle().empty()) return {std::nullopt, coefficients.obstacle()};
    return {std::move(form), ""};
}

}  // namespace hvi::gen
