// Hamiltonians of one degree of freedom whose derivatives are compared in several ways.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <array>

namespace hvi::gen {

/// Functions of q, p and parameters; together they call most functions and have all kinds of
/// powers.
inline constexpr std::array hamiltonians{
    "p^2/2 + w^2*q^2/2",
    "p^2/2 - cos(q)",
    "q*p",
    "p^2/(2*m) + k*q^4/4 - a*q^3/3",
    "exp(-a*q)*p^2",
    "d*(1-exp(-a*(q-r)))^2 + p^2/2",
    "sqrt(p^2 + m^2) + log(q)",
    "tan(q)*atan(p)",
    "asin(q)*acos(p)",
    "sinh(q)+cosh(p*q)+tanh(q/3)*p",
    "q^n*p^a",
    "a^q + q^p",
    "(q^2-1)^2/4 + p^2/2",
    "(p-q)^3*(q-p)^2 + sin((q-p)^3)",
    "1/(1-q*p)^2",
    "sqrt(1-q^2)*exp(sin(q*p))",
    "e^(q*p) + pi*q",
    "(q+p)^(-3/2)*(2*q+4*p)^5",
    "q^(1/3)*p^(2/5)/(q+p^2)^(7/4)",
    "exp(q)^3*exp(-q)*p",
    "log(exp(q)*p^2)",
    "sin(asin(q))+cos(acos(p))",
    "0.1*q^10 - 1e-3*p^7",
    "((q+1)^2+(p-2)^2)^2",
    "(a*q+b*p)^3/(a-b)^3",
    "q*(p-q)*(q-2*p)*(3*p-6*q)",
    "exp(1)*q+e^2*p+exp(3)*q*p",
    "sqrt(sqrt(q)+sqrt(p))",
    "cos(pi/12)*q + sqrt(2)*sqrt(3)*q*p/sqrt(5)",
    "q^-n/p^-2",
};

}  // namespace hvi::gen
