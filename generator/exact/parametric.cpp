// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/exact/parametric.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <utility>

#include "generator/exact/integers.hpp"
#include "generator/exact/number_value.hpp"
#include "generator/support/error.hpp"

namespace hvi::gen {
namespace {

using Polynomial = IntegerMultivariate;

/// The generators of a field that occur in some numbers, and which of EntireGenerators they are.
class Translation {
public:
    explicit Translation(const std::vector<Number>& numbers) {
        for (const Number& number : numbers) { note(number); }
        HVI_CHECK(field_ != nullptr);
        for (std::size_t i = 0; i < field_->transcendentals().size(); ++i) { set_parameter(i); }
        for (const std::size_t i : transcendentals_) { add_transcendental(i); }
        for (const std::size_t i : algebraics_) { add_algebraic(i); }
    }

    [[nodiscard]] const std::string& parameter() const { return name_; }
    [[nodiscard]] const EntireGenerators& generators() const { return generators_; }
    [[nodiscard]] Number exact(Element element) const { return number(std::move(element), field_); }
    [[nodiscard]] Number pi() const { return exact(field_->pi()); }
    [[nodiscard]] const Field& field() const { return *field_; }

    /// The variables of polynomials: of w itself, and of each phase, t = x/y.
    [[nodiscard]] std::size_t parameter_variable() const { return parameter_; }
    [[nodiscard]] const std::vector<std::size_t>& phase_variables() const { return phases_; }
    /// The place of a constant in EntireGenerators::constants.
    [[nodiscard]] std::size_t constant(std::size_t variable) const {
        return constants_.at(variable);
    }
    [[nodiscard]] std::size_t algebraic_constant(std::size_t index) const {
        return algebraic_constants_.at(index);
    }
    [[nodiscard]] std::vector<std::size_t> angles() const {
        std::vector<std::size_t> result;
        for (const std::size_t t : phases_) {
            if (is_angle(t)) { result.push_back(t); }
        }
        return result;
    }
    [[nodiscard]] bool is_angle(std::size_t variable) const {
        return field_->transcendentals()[variable].angle.has_value();
    }
    [[nodiscard]] std::optional<std::size_t> phase_of(std::size_t variable) const {
        const auto found = std::find(phases_.begin(), phases_.end(), variable);
        if (found == phases_.end()) { return std::nullopt; }
        return static_cast<std::size_t>(found - phases_.begin());
    }

private:
    void note(const Number& number) {
        const Element* const element = number.value().element();
        HVI_CHECK(element != nullptr);
        if (number.value().field != nullptr) { field_ = number.value().field; }
        note_transcendentals(element->denominator());
        for (const auto& [monomial, coefficient] : element->numerator()) {
            note_transcendentals(coefficient);
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
    }

    void note_transcendentals(const Polynomial& polynomial) {
        if (polynomial.is_constant()) { return; }
        for (std::size_t i = 0; i < field_->transcendentals().size(); ++i) {
            if (polynomial.contains(i)) { insert(transcendentals_, i); }
        }
    }

    static void insert(std::vector<std::size_t>& sorted, std::size_t value) {
        const auto place = std::lower_bound(sorted.begin(), sorted.end(), value);
        if (place == sorted.end() || *place != value) { sorted.insert(place, value); }
    }

    [[noreturn]] static void refuse() {
        throw InputError("a stepper takes a free parameter w as it stands, in sin and cos of "
                         "constant multiples of w, and in exp of them",
                         {}, "give the parameter a value with --param");
    }

    void set_parameter(std::size_t index) {
        const Transcendental& generator = field_->transcendentals()[index];
        const bool is_symbol = generator.form.kind == Expression::Kind::symbol;
        if (!generator.is_parameter || !is_symbol) { return; }
        if (!name_.empty()) {
            throw InputError("a stepper takes one free parameter, and here are `" + name_ +
                                 "` and `" + generator.form.name + "`",
                             {}, "give a value to all but one: --param " + name_ + "=1");
        }
        name_ = generator.form.name;
        parameter_ = index;
    }

    /// argument / w, which is to be a constant.
    [[nodiscard]] Number rate(const Element& argument) const {
        const Number w = exact(Element::variable(parameter_, field_.get()));
        Number result = exact(argument) / w;
        if (result.has_parameters()) { refuse(); }
        return result;
    }

    void add_transcendental(std::size_t index) {
        const Transcendental& generator = field_->transcendentals()[index];
        if (index == parameter_) { return; }
        if (!generator.is_parameter) {
            constants_[index] = generators_.constants.size();
            generators_.constants.push_back(exact(Element::variable(index, field_.get())));
        } else if (generator.angle) {
            // NOTE: t = tan(angle/2) makes rational functions of cos and sin.
            phases_.push_back(index);
            generators_.phases.push_back({Phase::Kind::angle, rate(*generator.angle) / Number(2),
                                          exact(*generator.angle) / Number(2)});
        } else if (generator.exponent) {
            phases_.push_back(index);
            generators_.phases.push_back(
                {Phase::Kind::exponential, rate(*generator.exponent), exact(*generator.exponent)});
        } else {
            refuse();
        }
    }

    void add_algebraic(std::size_t index) {
        Monomial monomial(index + 1);
        monomial[index] = 1;
        algebraic_constants_[index] = generators_.constants.size();
        generators_.constants.push_back(exact(Element::product(monomial, field_.get())));
    }

    std::shared_ptr<Field> field_;
    std::string name_;
    std::size_t parameter_ = 0;
    std::vector<std::size_t> transcendentals_, algebraics_;  ///< that occur, sorted
    std::vector<std::size_t> phases_;
    std::map<std::size_t, std::size_t> constants_, algebraic_constants_;
    EntireGenerators generators_;
};

// ---- from cos and sin to tangents ----

Polynomial power(const Polynomial& base, unsigned exponent) {
    Polynomial result(1);
    for (; exponent > 0; --exponent) { result = result * base; }
    return result;
}

/// 1 + sign t^2: the numerator of cos = (1 - t^2)/(1 + t^2), and its denominator.
Polynomial one_and_square(long sign, std::size_t t) {
    Polynomial result = Polynomial(sign) * power(Polynomial::variable(t), 2);
    result += Polynomial(1);
    return result;
}

Polynomial secant_squared(std::size_t t) { return one_and_square(1, t); }

/// A polynomial in cosines, of which each is a variable, and in sines, which stand in monomials.
class InTangents {
public:
    explicit InTangents(const Translation& translation) : translation_(translation) {}

    void add(const Monomial& monomial, const Polynomial& coefficient) {
        Monomial constants = monomial;
        std::map<std::size_t, unsigned> sines;  // by the variable of the angle
        for (std::size_t i = 0; i < monomial.size(); ++i) {
            const Algebraic& generator = translation_.field().algebraic(i);
            if (!generator.is_parameter) { continue; }
            sines[generator.cosine] = std::exchange(constants[i], 0);
        }
        while (!constants.empty() && constants.back() == 0) { constants.pop_back(); }
        for (Polynomial::Term& term : coefficient.terms()) {
            terms_.push_back({constants, std::move(term), sines});
        }
    }

    /// How often 1 + t^2 stands below.
    [[nodiscard]] unsigned degree(std::size_t t) const {
        unsigned degree = 0;
        for (const Summand& summand : terms_) { degree = std::max(degree, summand.degree(t)); }
        return degree;
    }

    /// The numerator.
    [[nodiscard]] Element::Terms numerator() const {
        Element::Terms result;
        for (const Summand& summand : terms_) {
            Polynomial::Term term = summand.term;
            Polynomial product(1);
            for (const std::size_t t : translation_.angles()) {
                const unsigned cosines = std::exchange(term.powers[t], 0);
                const unsigned sines = summand.sines_of(t);
                const Polynomial sine = Polynomial(2) * Polynomial::variable(t);
                product = product * power(one_and_square(-1, t), cosines) * power(sine, sines) *
                          power(secant_squared(t), degree(t) - cosines - sines);
            }
            result[summand.constants] += Polynomial::of(term) * product;
        }
        std::erase_if(result, [](const auto& entry) { return entry.second.is_zero(); });
        return result;
    }

private:
    struct Summand {
        Monomial constants;
        Polynomial::Term term;
        std::map<std::size_t, unsigned> sines;

        [[nodiscard]] unsigned sines_of(std::size_t t) const {
            const auto found = sines.find(t);
            return found == sines.end() ? 0 : found->second;
        }
        [[nodiscard]] unsigned degree(std::size_t t) const { return term.powers[t] + sines_of(t); }
    };

    const Translation& translation_;
    std::vector<Summand> terms_;
};

/// The element with t = tan(angle/2) in the place of each cosine, and without sines.
Element in_tangents(const Element& element, const Translation& translation) {
    InTangents above(translation);
    for (const auto& [monomial, coefficient] : element.numerator()) {
        above.add(monomial, coefficient);
    }
    InTangents below(translation);
    below.add({}, element.denominator());
    Element::Terms numerator = above.numerator();
    Polynomial denominator = below.numerator().at({});
    for (const std::size_t t : translation.angles()) {
        for (auto& [constants, polynomial] : numerator) {
            polynomial = polynomial * power(secant_squared(t), below.degree(t));
        }
        denominator = denominator * power(secant_squared(t), above.degree(t));
    }
    return Element::quotient(std::move(numerator), std::move(denominator), element.field());
}

/// Takes out 1 + t^2 as often as it divides all of them, and says how often that is.
unsigned without_secants(Element::Terms& polynomials, std::size_t t) {
    for (unsigned count = 0;; ++count) {
        Element::Terms quotients;
        for (const auto& [constants, polynomial] : polynomials) {
            const auto quotient = polynomial.divided_by(secant_squared(t));
            if (!quotient) { return count; }
            quotients[constants] = *quotient;
        }
        polynomials = std::move(quotients);
    }
}

// ---- functions and quotients ----

bool is_one_power(const std::vector<unsigned>& powers, std::size_t which) {
    for (std::size_t g = 0; g < powers.size(); ++g) {
        if (powers[g] != (g == which ? 1U : 0U)) { return false; }
    }
    return true;
}

bool is_generator(const EntireFunction& function, std::size_t which) {
    return function.terms.size() == 1 && is_one_power(function.terms.front().powers, which);
}

constexpr std::size_t of_w = 0;
std::size_t of_x(std::size_t phase) { return 1 + 2 * phase; }
std::size_t of_y(std::size_t phase) { return 2 + 2 * phase; }

class Conversion {
public:
    explicit Conversion(const std::vector<Number>& numbers) : translation_(numbers) {}

    Quotient add(const Number& number) {
        const Element quotient = in_tangents(*number.value().element(), translation_);
        Element::Terms above = quotient.numerator();
        const std::size_t phases = translation_.generators().phases.size();
        std::vector<int> surplus(phases);  // of the degree below over that above
        Quotient result;
        Polynomial rest = quotient.denominator();
        for (const auto& [base, exponent] : quotient.denominator().factors()) {
            rest /= power(base, exponent);
            for (std::size_t p = 0; p < phases; ++p) {
                surplus[p] += static_cast<int>(exponent * base.degree(variable(p)));
            }
            if (!is_secant(base)) { factor(result, homogeneous({{Monomial{}, base}}), exponent); }
        }
        HVI_CHECK(rest.is_constant());
        result.divisor = translation_.exact(Element(rest.constant()));
        for (std::size_t p = 0; p < phases; ++p) {
            const std::size_t t = variable(p);
            unsigned degree = 0;
            if (translation_.is_angle(t)) { degree = 2 * without_secants(above, t); }
            surplus[p] -= static_cast<int>(degree + degree_of(above, p));
        }
        EntireFunction numerator = homogeneous(above);
        for (std::size_t p = 0; p < phases; ++p) {
            if (surplus[p] < 0) {
                factor(result, generator(of_y(p)), static_cast<unsigned>(-surplus[p]));
            }
            for (EntireFunction::Term& term : numerator.terms) {
                term.powers[of_y(p)] += static_cast<unsigned>(std::max(surplus[p], 0));
            }
        }
        result.numerator = place_of(numerators_, numerator);
        return result;
    }

    ParametricNumbers finish(std::vector<Quotient> weights, std::vector<Quotient> others) {
        ParametricNumbers result;
        result.parameter = translation_.parameter();
        result.generators = translation_.generators();
        for (EntireFunction& function : factors_) {
            const Zero zero = has_zeros(function) ? Zero::pole : Zero::harmless;
            result.functions.push_back({std::move(function), zero, 0});
        }
        for (EntireFunction& function : numerators_) {
            result.functions.push_back({std::move(function), Zero::harmless, 0});
        }
        for (auto* quotients : {&weights, &others}) {
            for (Quotient& quotient : *quotients) {
                quotient.numerator += factors_.size();
                quotient.exponents.resize(factors_.size());
                ParameterFunction& above = result.functions[quotient.numerator];
                const bool is_weight = quotients == &weights && has_zeros(above.function);
                if (is_weight) { above.zero = Zero::weight; }
            }
        }
        result.weights = std::move(weights);
        result.others = std::move(others);
        return result;
    }

    [[nodiscard]] const Translation& translation() const { return translation_; }

private:
    [[nodiscard]] std::size_t variable(std::size_t phase) const {
        return translation_.phase_variables()[phase];
    }

    [[nodiscard]] bool is_secant(const Polynomial& base) const {
        for (const std::size_t t : translation_.phase_variables()) {
            if (translation_.is_angle(t) && base.divided_by(secant_squared(t))) { return true; }
        }
        return false;
    }

    [[nodiscard]] unsigned degree_of(const Element::Terms& polynomials, std::size_t phase) const {
        unsigned degree = 0;
        for (const auto& [constants, polynomial] : polynomials) {
            degree = std::max(degree, polynomial.degree(variable(phase)));
        }
        return degree;
    }

    [[nodiscard]] EntireFunction generator(std::size_t which) const {
        EntireFunction::Term term{1, std::vector<unsigned>(translation_.generators().count())};
        term.powers[which] = 1;
        return {{std::move(term)}};
    }

    /// t^k becomes x^k y^(n-k), n the degree in t.
    [[nodiscard]] EntireFunction homogeneous(const Element::Terms& polynomials) const {
        const EntireGenerators& generators = translation_.generators();
        const std::size_t constants = 1 + 2 * generators.phases.size();
        EntireFunction result;
        for (const auto& [algebraic, polynomial] : polynomials) {
            for (const Polynomial::Term& term : polynomial.terms()) {
                EntireFunction::Term& added = result.terms.emplace_back();
                added.coefficient = translation_.exact(Element(term.coefficient.value()));
                added.powers.resize(generators.count());
                for (std::size_t i = 0; i < term.powers.size(); ++i) {
                    if (term.powers[i] == 0) { continue; }
                    if (i == translation_.parameter_variable()) {
                        added.powers[of_w] = term.powers[i];
                    } else if (const auto phase = translation_.phase_of(i)) {
                        added.powers[of_x(*phase)] = term.powers[i];
                    } else {
                        added.powers[constants + translation_.constant(i)] = term.powers[i];
                    }
                }
                for (std::size_t i = 0; i < algebraic.size(); ++i) {
                    if (algebraic[i] == 0) { continue; }
                    added.powers[constants + translation_.algebraic_constant(i)] = algebraic[i];
                }
                for (std::size_t p = 0; p < generators.phases.size(); ++p) {
                    added.powers[of_y(p)] = degree_of(polynomials, p) - added.powers[of_x(p)];
                }
            }
        }
        return result;
    }

    void factor(Quotient& quotient, const EntireFunction& function, unsigned exponent) {
        const std::size_t place = place_of(factors_, function);
        if (quotient.exponents.size() <= place) { quotient.exponents.resize(place + 1); }
        quotient.exponents[place] += exponent;
    }

    static std::size_t place_of(std::vector<EntireFunction>& known,
                                const EntireFunction& function) {
        const auto found = std::find_if(known.begin(), known.end(), [&](const auto& other) {
            return std::equal(other.terms.begin(), other.terms.end(), function.terms.begin(),
                              function.terms.end(), [](const auto& a, const auto& b) {
                                  return a.powers == b.powers &&
                                         (a.coefficient - b.coefficient).is_zero();
                              });
        });
        if (found != known.end()) { return static_cast<std::size_t>(found - known.begin()); }
        known.push_back(function);
        return known.size() - 1;
    }

    /// NOTE: w = 0 is looked at by itself.
    [[nodiscard]] bool has_zeros(const EntireFunction& function) const {
        const auto& phases = translation_.generators().phases;
        if (is_generator(function, of_w)) { return false; }
        for (std::size_t p = 0; p < phases.size(); ++p) {
            const bool is_phase =
                is_generator(function, of_x(p)) || is_generator(function, of_y(p));
            if (is_phase) { return phases[p].kind == Phase::Kind::angle; }
        }
        return std::any_of(function.terms.begin(), function.terms.end(), [&](const auto& term) {
            return std::any_of(term.powers.begin(),
                               term.powers.begin() + static_cast<long>(1 + 2 * phases.size()),
                               [](unsigned power) { return power != 0; });
        });
    }

    Translation translation_;
    std::vector<EntireFunction> factors_;
    std::vector<EntireFunction> numerators_;
};

// ---- what the functions are like ----

void set_orders(ParametricNumbers& numbers) {
    for (ParameterFunction& function : numbers.functions) {
        function.order = order_at_zero(function.function, numbers.generators);
    }
    const auto order = [&](const Quotient& quotient) {
        long result = numbers.functions[quotient.numerator].order;
        for (std::size_t k = 0; k < quotient.exponents.size(); ++k) {
            result -= static_cast<long>(quotient.exponents[k]) * numbers.functions[k].order;
        }
        return result;
    };
    for (const Quotient& weight : numbers.weights) {
        if (order(weight) > 0) { numbers.at_zero = Zero::weight; }
    }
    for (const auto* quotients : {&numbers.weights, &numbers.others}) {
        for (const Quotient& quotient : *quotients) {
            if (order(quotient) < 0) { numbers.at_zero = Zero::pole; }
        }
    }
}

/// Of x, of y, or of both of a phase.
std::string family(const Number& half_period, bool of_sines, bool of_cosines,
                   const std::string& parameter) {
    const auto text = [](const Number& number) { return to_text(*number.closed_form()); };
    const std::string w = parameter + " = ";
    if (of_sines && of_cosines) { return w + text(half_period) + "*k, k = +-1, +-2, ..."; }
    if (of_sines) { return w + text(Number(2) * half_period) + "*k, k = +-1, +-2, ..."; }
    return w + text(half_period) + "*k, k = +-1, +-3, ...";
}

void add_families(ParametricNumbers& numbers, const Number& pi) {
    const auto occurs = [&](std::size_t which) {
        return std::any_of(numbers.functions.begin(), numbers.functions.end(), [&](const auto& f) {
            return f.zero == Zero::pole && is_generator(f.function, which);
        });
    };
    for (std::size_t p = 0; p < numbers.generators.phases.size(); ++p) {
        const bool sines = occurs(of_x(p));
        const bool cosines = occurs(of_y(p));
        if (!sines && !cosines) { continue; }
        const Number half_period = pi / (Number(2) * numbers.generators.phases[p].rate);
        numbers.zeros.push_back(
            {Zero::pole, family(half_period, sines, cosines, numbers.parameter), {}});
    }
}

void add_places(ParametricNumbers& numbers, Zero zero) {
    ZeroPlaces found{zero, {}, {}};
    for (const ParameterFunction& function : numbers.functions) {
        bool by_family = false;
        for (std::size_t g = of_x(0); g < of_x(numbers.generators.phases.size()); ++g) {
            by_family = by_family || is_generator(function.function, g);
        }
        if (function.zero != zero || by_family) { continue; }
        const auto places =
            real_zeros(function.function, numbers.generators, ParametricNumbers::most_printed);
        found.places.insert(found.places.end(), places.begin(), places.end());
    }
    std::sort(found.places.begin(), found.places.end());
    if (!found.places.empty()) { numbers.zeros.push_back(std::move(found)); }
}

}  // namespace

bool operator==(const Quotient& left, const Quotient& right) {
    return left.numerator == right.numerator && left.exponents == right.exponents &&
           (left.divisor - right.divisor).is_zero();
}

ParametricNumbers parametric(const std::vector<Number>& weights,
                             const std::vector<Number>& others) {
    std::vector<Number> all = weights;
    all.insert(all.end(), others.begin(), others.end());
    Conversion conversion(all);
    const auto converted = [&](const std::vector<Number>& numbers) {
        std::vector<Quotient> result;
        for (const Number& number : numbers) { result.push_back(conversion.add(number)); }
        return result;
    };
    std::vector<Quotient> first = converted(weights);
    std::vector<Quotient> second = converted(others);
    const Number pi = conversion.translation().pi();
    ParametricNumbers result = conversion.finish(std::move(first), std::move(second));
    set_orders(result);
    std::vector<EntireFunction> functions;
    for (const ParameterFunction& function : result.functions) {
        functions.push_back(function.function);
    }
    result.series = series_plan(functions, result.generators);
    add_families(result, pi);
    add_places(result, Zero::pole);
    add_places(result, Zero::weight);
    return result;
}

std::array<double, 5> expansion(const Number& constant) {
    std::array<double, 5> parts{};
    Number rest = constant;
    for (double& part : parts) {
        part = rest.nearest_double();
        int exponent = 0;
        const auto mantissa = static_cast<long>(std::ldexp(std::frexp(part, &exponent), 53));
        const GiNaC::numeric scale = GiNaC::pow(GiNaC::numeric(2), GiNaC::numeric(exponent - 53));
        rest = rest - number(Element(GiNaC::numeric(mantissa) * scale), nullptr);
    }
    return parts;
}

}  // namespace hvi::gen
