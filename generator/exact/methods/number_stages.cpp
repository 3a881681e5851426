// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/exact/methods/number_stages.hpp"

#include <algorithm>
#include <utility>

#include "generator/exact/algebra/matrix.hpp"
#include "generator/exact/numbers/number_value.hpp"
#include "generator/exact/numbers/rational.hpp"

namespace hvi::gen {

namespace {

/// Returns whether some coefficient has the property.
template <class Property>
bool any_coefficient(const PartitionedMethod& method, Property property) {
    const auto in_row = [&](const NumberVector& row) {
        return std::any_of(row.begin(), row.end(), property);
    };
    return in_row(method.b) || in_row(method.b_tilde) ||
           std::any_of(method.A.begin(), method.A.end(), in_row) ||
           std::any_of(method.A_tilde.begin(), method.A_tilde.end(), in_row);
}

/// Returns -1, 0 or 1 in some order of normal forms.
int compare(const Element& left, const Element& right) {
    const auto* const context = IntegerMultivariate::context();
    const auto& a = left.numerator();
    const auto& b = right.numerator();
    auto i = a.begin();
    auto j = b.begin();
    for (; i != a.end() && j != b.end(); ++i, ++j) {
        if (i->first != j->first) { return i->first < j->first ? -1 : 1; }
        const int order = fmpz_mpoly_cmp(i->second.get(), j->second.get(), context);
        if (order != 0) { return order; }
    }
    if (i != a.end() || j != b.end()) { return i == a.end() ? -1 : 1; }
    return fmpz_mpoly_cmp(left.denominator().get(), right.denominator().get(), context);
}

/// Returns the numbers. Throws TooLarge where arithmetic had to leave numbers to their enclosures.
NumberVector exact(NumberVector numbers) {
    for (const Number& number : numbers) {
        if (!is_exact(number)) { throw TooLarge(); }
    }
    return numbers;
}

std::vector<Ball> enclosures(const NumberVector& numbers, Precision bits) {
    std::vector<Ball> result;
    for (const Number& number : numbers) { result.push_back(enclosure(number, bits)); }
    return result;
}

std::vector<std::vector<Ball>> enclosures(const NumberMatrix& rows, Precision bits) {
    std::vector<std::vector<Ball>> result;
    for (const NumberVector& row : rows) { result.push_back(enclosures(row, bits)); }
    return result;
}

Ball dot(const std::vector<Ball>& left, const std::vector<Ball>& right, Precision bits) {
    Ball sum;
    for (std::size_t i = 0; i < left.size(); ++i) {
        arb_addmul(sum.get(), left[i].get(), right[i].get(), bits);
    }
    return sum;
}

}  // namespace

bool PartitionedMethod::is_exact() const {
    return !any_coefficient(*this, [](const Number& entry) { return !hvi::gen::is_exact(entry); });
}

bool PartitionedMethod::has_parameters() const {
    return any_coefficient(*this, [](const Number& entry) { return entry.has_parameters(); });
}

PartitionedMethod partitioned_method(const ButcherPair& pair) {
    return {pair.b, pair.b, pair.A, pair.A_tilde};
}

NumberVector NumberStages::product(const Function& left, const Function& right) const {
    NumberVector result;
    for (std::size_t i = 0; i < left.size(); ++i) { result.push_back(left[i] * right[i]); }
    return exact(std::move(result));
}

Number NumberStages::defect(Colour colour, const Function& function, long times) const {
    const NumberMatrix row{colour == Colour::f ? method_.b : method_.b_tilde};
    NumberVector defect = row * function;
    defect.front() = defect.front() * Number(times) - Number(1);
    return exact(std::move(defect)).front();
}

NumberVector NumberStages::apply(Colour colour, const Function& function, long times) const {
    return exact((colour == Colour::f ? method_.A : method_.A_tilde) * function * Number(times));
}

GalerkinStages::GalerkinStages(const ButcherPair& pair, const Galerkin& galerkin)
    : NumberStages(partitioned_method(pair)),
      to_basis_(transpose(galerkin.M_inverse)),
      A_psi_(galerkin.A_psi),
      moments_(transpose(galerkin.A_psi)),
      from_basis_(galerkin.M_inverse),
      b_(pair.b) {
    for (NumberVector& row : moments_) { row = NumberStages::product(row, b_); }
    for (std::size_t i = 0; i < b_.size(); ++i) {
        from_basis_[i] = from_basis_[i] * (Number(1) / b_[i]);
    }
}

Number GalerkinStages::integral(const Function& function) const {
    const auto [entry, is_new] = integrals_.try_emplace(function);
    if (is_new) { entry->second = (NumberMatrix{b_} * function).front(); }
    return entry->second;
}

Number GalerkinStages::defect(Colour /*colour*/, const Function& function, long times) const {
    return integral(function) * Number(times) - Number(1);
}

NumberVector GalerkinStages::applied(Colour colour, const Function& function) const {
    if (colour == Colour::f) { return A_psi_ * (to_basis_ * function); }
    NumberVector result = from_basis_ * (moments_ * function);
    for (Number& entry : result) { entry = integral(function) - entry; }
    return result;
}

NumberVector GalerkinStages::apply(Colour colour, const Function& function, long times) const {
    const auto [entry, is_new] =
        applied_.at(static_cast<std::size_t>(colour)).try_emplace(function);
    if (is_new) { entry->second = applied(colour, function); }
    return entry->second * Number(times);
}

bool NumberStages::Less::operator()(const Function& left, const Function& right) const {
    for (std::size_t i = 0; i < left.size(); ++i) {
        const int order = compare(*left[i].value().element(), *right[i].value().element());
        if (order != 0) { return order < 0; }
    }
    return false;
}

BallStages::BallStages(const PartitionedMethod& method, Precision bits)
    : b_(enclosures(method.b, bits)),
      b_tilde_(enclosures(method.b_tilde, bits)),
      A_(enclosures(method.A, bits)),
      A_tilde_(enclosures(method.A_tilde, bits)),
      bits_(bits) {}

BallStages::Function BallStages::one() const {
    Ball unit;
    arb_one(unit.get());
    return std::make_shared<const std::vector<Ball>>(b_.size(), unit);
}

BallStages::Function BallStages::product(const Function& left, const Function& right) const {
    std::vector<Ball> result = *left;
    for (std::size_t i = 0; i < result.size(); ++i) {
        arb_mul(result[i].get(), result[i].get(), (*right)[i].get(), bits_);
    }
    return std::make_shared<const std::vector<Ball>>(std::move(result));
}

Ball BallStages::defect(Colour colour, const Function& function, long times) const {
    Ball result = dot(colour == Colour::f ? b_ : b_tilde_, *function, bits_);
    arb_mul_si(result.get(), result.get(), times, bits_);
    arb_sub_si(result.get(), result.get(), 1, bits_);
    return result;
}

BallStages::Function BallStages::apply(Colour colour, const Function& function, long times) const {
    std::vector<Ball> result;
    for (const std::vector<Ball>& row : colour == Colour::f ? A_ : A_tilde_) {
        Ball entry = dot(row, *function, bits_);
        arb_mul_si(entry.get(), entry.get(), times, bits_);
        result.push_back(std::move(entry));
    }
    return std::make_shared<const std::vector<Ball>>(std::move(result));
}

bool RoundedStages::Less::operator()(const Function& left, const Function& right) const {
    for (std::size_t i = 0; i < left->size(); ++i) {
        const arb_srcptr a = (*left)[i].get();
        const arb_srcptr b = (*right)[i].get();
        const int middles = arf_cmp(arb_midref(a), arb_midref(b));
        const int order = middles != 0 ? middles : mag_cmp(arb_radref(a), arb_radref(b));
        if (order != 0) { return order < 0; }
    }
    return false;
}

}  // namespace hvi::gen
