// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/exact/methods/galerkin_rule.hpp"
#include "generator/exact/methods/tableau.hpp"
#include "generator/exact/numbers/number_text.hpp"

namespace hvi::gen {
namespace {

std::string line(const std::string& name, const NumberVector& row) {
    std::string result = name + ":";
    for (const Number& entry : row) { result += " " + dump(entry); }
    return result + "\n";
}

std::string lines(const std::string& name, const NumberMatrix& rows) {
    std::string result;
    for (const NumberVector& row : rows) { result += line(name, row); }
    return result;
}

std::string text(const Galerkin& galerkin) {
    return lines("M", galerkin.M) + lines("M^-1", galerkin.M_inverse) + line("B", galerkin.B) +
           lines("A_psi", galerkin.A_psi);
}

std::string heading(const Provenance& provenance, const std::vector<std::string>& parameters) {
    std::string result = "method: " + provenance.title() + "\n";
    for (const Expression& function : provenance.basis) {
        result += "psi: " + to_text(function) + "\n";
    }
    for (const std::string& name : parameters) { result += "parameter: " + name + "\n"; }
    return result;
}

}  // namespace

std::string dump(const GalerkinRule& rule) {
    return heading(rule.provenance, rule.parameters) + line("c", rule.c) + line("b", rule.b) +
           line("B", rule.B) + lines("Psi", rule.Psi) + lines("A_psi", rule.A_psi) +
           lines("G", rule.gram) + lines("n", rule.n);
}

std::string dump(const Tableau& tableau) {
    std::string result = heading(tableau.provenance, tableau.parameters);
    result += line("c", tableau.c) + line("b", tableau.b) + lines("A", tableau.A) +
              lines("A~", tableau.A_tilde) + line("c~", tableau.c_tilde);
    return tableau.galerkin ? result + text(*tableau.galerkin) : result;
}

}  // namespace hvi::gen
