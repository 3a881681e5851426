// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/hamiltonian/quadratic.hpp"

#include <cmath>
#include <utility>

#include "generator/exact/expressions/evaluate.hpp"
#include "generator/exact/numbers/rational.hpp"
#include "generator/hamiltonian/algebra.hpp"
#include "generator/support/progress.hpp"

namespace hvi::gen {

namespace {

using GiNaC::ex;

/// What the exact arithmetic refuses: `work` returns it to whoever can do without.
template <class Work>
std::optional<Number> attempted(Work work, std::string* reason = nullptr) {
    try {
        return work();
    } catch (const MathError& error) {
        if (reason != nullptr) { *reason = error.what(); }
    } catch (const InputError& error) {
        if (reason != nullptr) { *reason = error.what(); }
    }
    return std::nullopt;
}

class Proof {
public:
    Proof(const Hamiltonian& hamiltonian, const Ground& ground)
        : algebra_(hamiltonian), ground_(ground) {
        for (const GiNaC::symbol& variable : algebra_.variables()) { origin_[variable] = 0; }
    }

    [[nodiscard]] QuadraticProof run();

private:
    [[nodiscard]] bool has_variables(const ex& expression) const;
    [[nodiscard]] std::optional<ex> at_origin(const ex& expression) const;
    [[nodiscard]] bool seems_affine(const ex& expression) const;
    [[nodiscard]] bool is_constant(const ex& expression, const ex& value) const;
    [[nodiscard]] bool find_coefficients();
    [[nodiscard]] Number number(const ex& expression);

    Algebra algebra_;
    const Ground& ground_;
    GiNaC::exmap origin_;
    std::vector<std::vector<ex>> S_;
    std::vector<ex> g_;
    ex constant_;
    std::string obstacle_;
};

bool Proof::has_variables(const ex& expression) const {
    for (const GiNaC::symbol& variable : algebra_.variables()) {
        if (GiNaC::has(expression, variable)) { return true; }
    }
    return false;
}

/// The value for q = p = 0, where there is a real one.
std::optional<ex> Proof::at_origin(const ex& expression) const {
    try {
        ex value = expression.subs(origin_);
        return value.has(GiNaC::I) ? std::nullopt : std::optional(std::move(value));
    } catch (const std::exception&) { return std::nullopt; }
}

/// NOTE: only to save work, and to refuse is always right: what is bent in floating point along a
/// line is not tried to be proved straight, which can take long.
bool Proof::seems_affine(const ex& expression) const {
    const auto at = [&](int step) {
        GiNaC::exmap point;
        ex value = ex(13) / 10;
        for (const GiNaC::symbol& parameter : algebra_.parameters()) {
            point[parameter] = value += ex(7) / 100;
        }
        for (const GiNaC::symbol& variable : algebra_.variables()) {
            point[variable] = step * (value -= ex(9) / 100);
        }
        const ex result = expression.subs(point).evalf();
        const bool real =
            GiNaC::is_a<GiNaC::numeric>(result) && result.info(GiNaC::info_flags::real);
        return real ? GiNaC::ex_to<GiNaC::numeric>(result).to_double() : std::nan("");
    };
    try {
        constexpr double tolerance = 1e-6;
        const double first = at(0), middle = at(1), last = at(2);
        const double scale = std::abs(first) + 2 * std::abs(middle) + std::abs(last);
        return std::abs(first - 2 * middle + last) <= tolerance * scale;
    } catch (const std::exception&) { return false; }
}

/// Whether an expression has this value for all values of its symbols: in a field in which they
/// are free.
bool Proof::is_constant(const ex& expression, const ex& value) const {
    if (!has_variables(expression)) { return true; }
    const Expression difference = algebra_.written(expression - value);
    return on_new_ground([&](const Ground& ground) {
        const auto rest = attempted([&] { return evaluate_number(difference, nullptr, ground); });
        return rest && is_exact(*rest) && rest->is_zero();
    });
}

/// S, g and the constant as derivatives for q = p = 0; false where H is not proved quadratic.
bool Proof::find_coefficients() {
    const std::vector<GiNaC::symbol>& x = algebra_.variables();
    const auto constant = at_origin(algebra_.hamiltonian());
    if (!constant) { return false; }
    constant_ = *constant;
    for (std::size_t i = 0; i < x.size(); ++i) {
        const ex derivative = algebra_.derivative(algebra_.hamiltonian(), x[i]);
        const auto linear = at_origin(derivative);
        if (!linear || !seems_affine(derivative)) { return false; }
        g_.push_back(*linear);
        S_.emplace_back(x.size());
        for (std::size_t j = 0; j < x.size(); ++j) {
            if (!GiNaC::has(derivative, x[j])) { continue; }
            const ex second = algebra_.derivative(derivative, x[j]);
            const auto entry = at_origin(second);
            if (!entry || !is_constant(second, *entry)) { return false; }
            S_[i][j] = *entry;
        }
    }
    return true;
}

/// The coefficient on the ground; 0, with an obstacle, where it has no place there.
Number Proof::number(const ex& expression) {
    if (expression.is_zero()) { return Number(0); }
    const Expression written = algebra_.written(expression);
    std::string reason = "it has no closed form in our arithmetic";
    const auto result =
        attempted([&] { return evaluate_number(written, nullptr, ground_); }, &reason);
    if (result && is_exact(*result)) { return *result; }
    obstacle_ = "the coefficient " + to_text(written) + ": " + reason;
    return Number(0);
}

QuadraticProof Proof::run() {
    if (!find_coefficients()) { return {}; }
    QuadraticForm form;
    form.constant = number(constant_);
    for (std::size_t i = 0; i < g_.size(); ++i) {
        form.g.push_back(number(g_[i]));
        form.S.emplace_back();
        for (std::size_t j = 0; j < g_.size(); ++j) {
            form.S[i].push_back(j < i ? form.S[j][i] : number(S_[i][j]));
        }
    }
    if (!obstacle_.empty()) { return {std::nullopt, obstacle_}; }
    return {std::move(form), ""};
}

}  // namespace

QuadraticProof quadratic_form(const Hamiltonian& hamiltonian, const Ground& ground) {
    if (depends_on_time(hamiltonian)) return {};
    const Progress::Stage stage("looking whether the Hamiltonian is quadratic");
    return Proof(hamiltonian, ground).run();
}

}  // namespace hvi::gen
