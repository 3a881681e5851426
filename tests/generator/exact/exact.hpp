// Numbers and methods from text, as a user gives them.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "generator/exact/expressions/evaluate.hpp"
#include "generator/exact/methods/galerkin.hpp"
#include "generator/read/method.hpp"
#include "tests/generator/read/refusal.hpp"

namespace hvi::gen {

inline Number read(const std::string& text, const Ground& ground) {
    const auto given = source(text);
    return evaluate_number(parse_expression(given), given, ground);
}

inline Number number(const std::string& text) {
    return on_new_ground([&](const Ground& ground) { return read(text, ground); });
}

/// The closed form, or `none`.
inline std::string text(const Number& number) {
    const auto form = number.closed_form();
    return form ? to_text(*form) : "none";
}

inline std::vector<std::string> texts(const NumberVector& numbers) {
    std::vector<std::string> result;
    for (const Number& entry : numbers) result.push_back(text(entry));
    return result;
}

/// The closed form of the number that a text stands for.
inline std::string normal(const std::string& given) { return text(number(given)); }

/// Whether two lists of texts stand for equal numbers, decided in one field.
inline bool same(const std::vector<std::string>& left, const std::vector<std::string>& right) {
    return left.size() == right.size() && on_new_ground([&](const Ground& ground) {
               for (std::size_t i = 0; i < left.size(); ++i) {
                   if (!(read(left[i], ground) - read(right[i], ground)).is_zero()) return false;
               }
               return true;
           });
}

inline bool same(const std::string& left, const std::string& right) {
    return same(std::vector{left}, std::vector{right});
}

/// Whether exact numbers, through their closed forms, equal the numbers in the texts.
inline bool same(const NumberVector& numbers, const std::vector<std::string>& expected) {
    return same(texts(numbers), expected);
}

inline Method method(const std::string& name) { return named_method(source(name, "--method")); }

inline Method method(const std::string& basis, const std::string& nodes) {
    return method_from_text(source(basis, "--basis"), source(nodes, "--nodes"));
}

/// A method in one text for lists of them: `gauss:2`, or `1, tau | 0, 1`.
inline Method any_method(const std::string& given) {
    const std::size_t bar = given.find('|');
    return bar == std::string::npos ? method(given)
                                    : method(given.substr(0, bar), given.substr(bar + 1));
}

inline Tableau tableau(const std::string& method) { return derive(any_method(method)); }

inline Number sum(const NumberVector& terms) {
    Number result;
    for (const Number& term : terms) result = result + term;
    return result;
}

/// |number| < 10^-60
inline bool is_tiny(const Number& number) {
    const Number bound = Number(1) / power(Number(10), 60);
    return (bound - number).sign() == 1 && (bound + number).sign() == 1;
}

/// All entries of a tableau, row after row.
inline NumberVector all_entries(const Tableau& tableau) {
    NumberVector result;
    const Galerkin& galerkin = tableau.galerkin.value();
    for (const NumberVector* vector : {&tableau.c, &tableau.b, &tableau.c_tilde, &galerkin.B})
        result.insert(result.end(), vector->begin(), vector->end());
    for (const NumberMatrix* matrix :
         {&tableau.A, &tableau.A_tilde, &galerkin.M, &galerkin.M_inverse, &galerkin.A_psi}) {
        for (const NumberVector& row : *matrix) result.insert(result.end(), row.begin(), row.end());
    }
    return result;
}

}  // namespace hvi::gen
