// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/ir/affine_form.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <utility>

namespace hvi::gen {

namespace {

constexpr long largest = 100'000'000;

bool is_small(const AffineForm& form) {
    if (std::abs(form.constant) > largest) { return false; }
    for (const auto& [name, coefficient] : form.coefficients) {
        if (std::abs(coefficient) > largest) { return false; }
    }
    return true;
}

std::optional<AffineForm> sum(const Expression& written) {
    AffineForm total;
    for (const Expression& term : written.arguments) {
        const auto form = affine_form(term);
        if (!form) { return std::nullopt; }
        total = total + *form;
    }
    return total;
}

std::optional<AffineForm> product(const Expression& written) {
    AffineForm total{1};
    for (const Expression& factor : written.arguments) {
        const auto form = affine_form(factor);
        const bool is_affine = form && (form->is_number() || total.is_number());
        if (!is_affine) { return std::nullopt; }
        total = form->is_number() ? form->constant * total : total.constant * *form;
        if (!is_small(total)) { return std::nullopt; }
    }
    return total;
}

std::optional<AffineForm> any(const Expression& written) {
    switch (written.kind) {
    case Expression::Kind::number:
        if (written.denominator != "1" || written.numerator.size() > 9) { return std::nullopt; }
        return AffineForm{std::stol(written.numerator)};
    case Expression::Kind::symbol: return AffineForm::of(written.name);
    case Expression::Kind::negation: {
        const auto form = affine_form(written.arguments.front());
        return form ? std::optional(-1 * *form) : std::nullopt;
    }
    case Expression::Kind::sum: return sum(written);
    case Expression::Kind::product: return product(written);
    default: return std::nullopt;
    }
}

}  // namespace

long AffineForm::coefficient(const std::string& name) const {
    const auto found = coefficients.find(name);
    return found == coefficients.end() ? 0 : found->second;
}

long AffineForm::at(const std::map<std::string, long>& values) const {
    long result = constant;
    for (const auto& [name, coefficient] : coefficients) {
        result += coefficient * values.at(name);
    }
    return result;
}

AffineForm operator+(const AffineForm& a, const AffineForm& b) {
    AffineForm result = a;
    result.constant += b.constant;
    for (const auto& [name, coefficient] : b.coefficients) {
        const long total = result.coefficients[name] += coefficient;
        if (total == 0) { result.coefficients.erase(name); }
    }
    return result;
}

AffineForm operator-(const AffineForm& a, const AffineForm& b) { return a + -1 * b; }

AffineForm operator*(long factor, const AffineForm& a) {
    if (factor == 0) { return {}; }
    AffineForm result{factor * a.constant, a.coefficients};
    for (auto& [name, coefficient] : result.coefficients) { coefficient *= factor; }
    return result;
}

AffineForm replaced(const AffineForm& form, const std::string& name, const AffineForm& by) {
    const long coefficient = form.coefficient(name);
    AffineForm rest = form;
    rest.coefficients.erase(name);
    return rest + coefficient * by;
}

std::optional<AffineForm> affine_form(const Expression& expression) {
    auto form = any(expression);
    return form && is_small(*form) ? std::move(form) : std::nullopt;
}

Expression as_expression(const AffineForm& form) {
    std::vector<Expression> terms;
    for (const bool is_negative : {false, true}) {
        for (const auto& [name, coefficient] : form.coefficients) {
            if ((coefficient < 0) != is_negative) { continue; }
            const long size = std::abs(coefficient);
            Expression term = Expression::symbol(name);
            if (size != 1) { term = Expression::product({Expression::integer(size), term}); }
            terms.push_back(is_negative ? Expression::negation(std::move(term)) : std::move(term));
        }
    }
    if (form.constant != 0 || terms.empty()) {
        terms.push_back(Expression::integer(form.constant));
    }
    return Expression::sum(std::move(terms));
}

std::string to_text(const AffineForm& form) {
    std::string text;
    const auto add = [&](bool is_negative, const std::string& size) {
        text += text.empty() ? (is_negative ? "-" : "") : (is_negative ? " - " : " + ");
        text += size;
    };
    for (const auto& [name, coefficient] : form.coefficients) {
        const long size = std::abs(coefficient);
        add(coefficient < 0, size == 1 ? name : fmt::format("{}*{}", size, name));
    }
    if (form.constant != 0 || text.empty()) {
        add(form.constant < 0, std::to_string(std::abs(form.constant)));
    }
    return text;
}

}  // namespace hvi::gen
