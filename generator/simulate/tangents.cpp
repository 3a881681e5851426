// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/simulate/tangents.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Eigenvalues>

namespace hvi::gen {

namespace {

/// Returns the eigenvalues of a matrix, given row by row, the largest first. Returns none where an
/// entry is no finite number.
std::vector<std::complex<double>> eigenvalues(const std::vector<double>& entries) {
    const bool is_finite = std::all_of(entries.begin(), entries.end(),
                                       [](double entry) { return std::isfinite(entry); });
    if (!is_finite) return {};
    const auto size = std::lround(std::sqrt(static_cast<double>(entries.size())));
    Eigen::MatrixXd matrix(size, size);
    for (Eigen::Index row = 0; row < size; ++row)
        for (Eigen::Index column = 0; column < size; ++column)
            matrix(row, column) = entries[static_cast<std::size_t>(row * size + column)];
    const Eigen::EigenSolver<Eigen::MatrixXd> solver(matrix, false);
    if (solver.info() != Eigen::Success) return {};
    std::vector<std::complex<double>> result(solver.eigenvalues().begin(),
                                             solver.eigenvalues().end());
    // NOTE: conjugate eigenvalues have equal moduli, and stay side by side.
    std::stable_sort(result.begin(), result.end(),
                     [](const auto& a, const auto& b) { return std::norm(a) > std::norm(b); });
    return result;
}

/// NOTE: the derivative maps into the tangent space of the event's surface, so that one eigenvalue
/// is 0. It belongs to directions that leave the surface at the start.
void add_event(const Answers& answers, TangentFindings& found) {
    found.event_time = answers.numbers("event_time");
    found.event_state = answers.numbers("event_state");
    if (found.event_time.empty() || !answers.has("surface")) return;
    found.return_multipliers = eigenvalues(found.event_state);
    if (!found.return_multipliers.empty()) found.return_multipliers.pop_back();
}

}  // namespace

TangentFindings find_tangents(const Target& target, const TangentWishes& wishes,
                              const std::function<void(double)>& on_progress) {
    const Answers answers = ask(target, wishes, on_progress);
    TangentFindings found;
    if (answers.has("fault")) found.fault = answers.text("fault");
    const auto number = [&](const char* key, std::optional<double>& into) {
        if (answers.has(key)) into = answers.number(key);
    };
    number("lyapunov", found.lyapunov);
    number("megno", found.megno);
    number("sali", found.sali);
    found.exponents = answers.numbers("exponent");
    std::sort(found.exponents.rbegin(), found.exponents.rend());
    found.entries = answers.numbers("entry");
    found.own = answers.numbers("component");
    if (answers.has("form")) found.form = answers.number("form");
    if (!found.entries.empty()) found.multipliers = eigenvalues(found.entries);
    add_event(answers, found);
    return found;
}

}  // namespace hvi::gen
