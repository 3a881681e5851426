// The properties of the general Galerkin form (4.6), each with its evidence.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <variant>

#include "generator/certify/certificate.hpp"
#include "generator/exact/methods/rule_properties.hpp"

namespace hvi::gen {

/// The certificate for H = p^T K p/2 + U(q), where the form is a Nystrom method; `stages` are its
/// nodes. It is not known whether the trees of partitioned methods have conditions for it.
struct RuleCertificate : Findings {
    std::size_t functions = 0;
    Verdict symplectic;
    Verdict symmetric;
    OrderConditions nystrom;
    std::vector<ExceptionalValue> exceptions;  ///< values of a parameter with a higher order
    bool is_explicit = false;  ///< no position needs a force at itself or at a later one

    [[nodiscard]] bool is_proved() const;
};

/// Certifies a rule. Preconditions as for orders().
[[nodiscard]] RuleCertificate certify(const GalerkinRule& rule, int max_order);

/// A certificate of a METHOD of either kind, with the exceptional values of a free parameter.
using AnyCertificate = std::variant<Certificate, RuleCertificate>;
[[nodiscard]] AnyCertificate certify(const Method& method, int max_order);

}  // namespace hvi::gen
