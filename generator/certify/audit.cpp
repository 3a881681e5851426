// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/certify/audit.hpp"

#include <utility>

#include "generator/exact/algebra/matrix.hpp"
#include "generator/exact/numbers/rounded.hpp"

namespace hvi::gen {
namespace {

/// Whether two records have equal properties, whatever their evidence.
bool say_the_same(const Properties& left, const Properties& right) {
    const auto same_order = [](const OrderConditions& a, const OrderConditions& b) {
        return a.order == b.order && a.is_at_least == b.is_at_least;
    };
    return left.symplectic.holds == right.symplectic.holds &&
           left.symmetric.holds == right.symmetric.holds &&
           left.runge_kutta.holds == right.runge_kutta.holds &&
           left.common_weights.holds == right.common_weights.holds &&
           same_order(left.orders.general, right.orders.general) &&
           same_order(left.orders.separable, right.orders.separable) &&
           same_order(left.orders.nystrom, right.orders.nystrom);
}

/// Returns the certificate of the method that has the coefficients.
Certificate certificate_of(const Rebuilt& rebuilt, int max_order) {
    return rebuilt.is_method() ? certify(*rebuilt.tableau, max_order)
                               : certify(rebuilt.right, {}, max_order);
}

void set_certificate(Audit& audit, const GivenTableau& given, int max_order) {
    const bool as_written = given.rounded == 0 || (audit.is_known() && audit.rebuilt->proved);
    if (!as_written) { audit.as_written = properties(given.written.method, max_order); }
    if (audit.is_known()) {
        audit.certificate = certificate_of(*audit.rebuilt, max_order);
        audit.certificate.within_digits = !as_written;
    } else if (as_written) {
        audit.certificate = certify(given.written, given.parameters, max_order);
    } else {
        audit.certificate = certify_within_digits(given, max_order);
    }
    const bool digits_count = !as_written && !say_the_same(*audit.as_written, audit.certificate);
    if (!as_written && !digits_count) {
        audit.certificate = certify(given.written, given.parameters, max_order);
        audit.as_written.reset();
    }
}

/// Returns the symplectic defect of the certified coefficients.
std::optional<SymplecticDefect> defect(const Audit& audit, const GivenTableau& given) {
    if (audit.is_known()) { return symplectic_defect(audit.rebuilt->right.method); }
    if (given.rounded == 0) { return symplectic_defect(given.written.method); }
    auto result = symplectic_defect(given.rounded_method());
    if (result) { result->residual = without_closed_form(result->residual); }
    return result;
}

/// Whether c = A 1.
Verdict are_row_sums(const NumberVector& c, const NumberMatrix& A, Precision bits) {
    Verdict verdict;
    for (std::size_t i = 0; i < c.size(); ++i) {
        Number sum;
        for (const Number& entry : A[i]) { sum = sum + entry; }
        verdict = verdict && can_agree(sum, c[i], bits);
    }
    return verdict;
}

Audit audit_on(const Ground& ground, const Coefficients& coefficients, int max_order) {
    const GivenTableau given = given_tableau(coefficients, ground);
    Audit result;
    for_each_coefficient(coefficients, [&](const Coefficient&) { ++result.coefficients; });
    result.rounded = given.rounded;
    result.digits = given.digits;
    result.rebuilt = rebuild(coefficients, given, ground);
    set_certificate(result, given, max_order);
    result.certificate.name = coefficients.name;
    result.certificate.origin = coefficients.origin;
    set_signs(result.certificate, given.written);
    if (!result.certificate.symplectic.holds) { result.defect = defect(result, given); }
    const NodesAndMethod& known = given.enclosed;
    result.c_is_sum_of_A = are_row_sums(known.c, known.method.A, given.bits);
    result.c_is_sum_of_A_tilde = are_row_sums(known.c, known.method.A_tilde, given.bits);
    return result;
}

}  // namespace

Audit audit(const Coefficients& coefficients, int max_order) {
    return on_new_ground(
        [&](const Ground& ground) { return audit_on(ground, coefficients, max_order); });
}

}  // namespace hvi::gen
