// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/exact/parameters/parameter_generators.hpp"

#include <algorithm>
#include <utility>

#include "generator/exact/numbers/number_value.hpp"
#include "generator/support/error.hpp"

namespace hvi::gen {

namespace {

void insert(std::vector<std::size_t>& sorted, std::size_t value) {
    const auto place = std::lower_bound(sorted.begin(), sorted.end(), value);
    if (place == sorted.end() || *place != value) { sorted.insert(place, value); }
}

[[noreturn]] void refuse() {
    throw InputError("a stepper takes a free parameter w as it stands, in sin and cos of "
                     "constant multiples of w, and in exp of them",
                     {}, "give the parameter a value with --param");
}

}  // namespace

ParameterGenerators::ParameterGenerators(const std::vector<Number>& numbers) {
    for (const Number& number : numbers) { note(number); }
    HVI_CHECK(field_ != nullptr);
    for (std::size_t i = 0; i < field_->transcendentals().size(); ++i) { set_parameter(i); }
    for (const std::size_t i : transcendentals_) { add_transcendental(i); }
    for (const std::size_t i : algebraics_) { add_algebraic(i); }
}

Number ParameterGenerators::exact(Element element) const {
    return number(std::move(element), field_);
}

std::optional<std::size_t> ParameterGenerators::phase_of(std::size_t variable) const {
    const auto found = std::find(phases_.begin(), phases_.end(), variable);
    if (found == phases_.end()) { return std::nullopt; }
    return static_cast<std::size_t>(found - phases_.begin());
}

bool ParameterGenerators::is_angle(std::size_t variable) const {
    return field_->transcendentals()[variable].angle.has_value();
}

std::vector<std::size_t> ParameterGenerators::angles() const {
    std::vector<std::size_t> result;
    std::copy_if(phases_.begin(), phases_.end(), std::back_inserter(result),
                 [&](std::size_t t) { return is_angle(t); });
    return result;
}

// ---- what occurs ----

void ParameterGenerators::note(const Number& number) {
    const Element* const element = number.value().element();
    HVI_CHECK(element != nullptr);
    if (number.value().field != nullptr) { field_ = number.value().field; }
    note_transcendentals(element->denominator());
    for (const auto& [monomial, coefficient] : element->numerator()) {
        note_transcendentals(coefficient);
        note_monomial(monomial);
    }
}

void ParameterGenerators::note_monomial(const Monomial& monomial) {
    for (std::size_t i = 0; i < monomial.size(); ++i) {
        if (monomial[i] == 0) { continue; }
        const Algebraic& generator = field_->algebraic(i);
        if (!generator.is_parameter) {
            insert(algebraics_, i);
        } else if (generator.kind == Algebraic::Kind::sine) {
            insert(transcendentals_, generator.cosine);
        } else {
            refuse();
        }
    }
}

void ParameterGenerators::note_transcendentals(const IntegerMultivariate& polynomial) {
    if (polynomial.is_constant()) { return; }
    for (std::size_t i = 0; i < field_->transcendentals().size(); ++i) {
        if (polynomial.contains(i)) { insert(transcendentals_, i); }
    }
}

// ---- what it becomes ----

void ParameterGenerators::set_parameter(std::size_t index) {
    const Transcendental& generator = field_->transcendentals()[index];
    const bool is_symbol = generator.form.kind == Expression::Kind::symbol;
    if (!generator.is_parameter || !is_symbol) { return; }
    if (!name_.empty()) {
        throw InputError("a stepper takes one free parameter, and here are `" + name_ + "` and `" +
                             generator.form.name + "`",
                         {}, "give a value to all but one: --param " + name_ + "=1");
    }
    name_ = generator.form.name;
    parameter_ = index;
}

/// Returns argument / w, which has to be a constant.
Number ParameterGenerators::rate(const Element& argument) const {
    const Number w = exact(Element::variable(parameter_, field_.get()));
    Number result = exact(argument) / w;
    if (result.has_parameters()) { refuse(); }
    return result;
}

void ParameterGenerators::add_transcendental(std::size_t index) {
    const Transcendental& generator = field_->transcendentals()[index];
    if (index == parameter_) { return; }
    if (!generator.is_parameter) {
        constants_[index] = entire_.constants.size();
        entire_.constants.push_back(exact(Element::variable(index, field_.get())));
    } else if (generator.angle) {
        // NOTE: t = tan(angle/2) makes rational functions of cos and sin.
        phases_.push_back(index);
        entire_.phases.push_back({Phase::Kind::angle, rate(*generator.angle) / Number(2),
                                  exact(*generator.angle) / Number(2)});
    } else if (generator.exponent) {
        phases_.push_back(index);
        entire_.phases.push_back(
            {Phase::Kind::exponential, rate(*generator.exponent), exact(*generator.exponent)});
    } else {
        refuse();
    }
}

void ParameterGenerators::add_algebraic(std::size_t index) {
    Monomial monomial(index + 1);
    monomial[index] = 1;
    algebraic_constants_[index] = entire_.constants.size();
    entire_.constants.push_back(exact(Element::product(monomial, field_.get())));
}

}  // namespace hvi::gen
