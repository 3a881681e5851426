// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/hamiltonian/family_symmetries.hpp"

#include <algorithm>
#include <set>
#include <utility>

#include "generator/hamiltonian/affine_fields.hpp"
#include "generator/hamiltonian/ginac_functions.hpp"
#include "generator/hamiltonian/lie_algebra.hpp"
#include "generator/hamiltonian/normal_form.hpp"
#include "generator/hamiltonian/relations.hpp"
#include "generator/read/hamiltonian.hpp"
#include "generator/support/progress.hpp"

namespace hvi::gen {

namespace {

using GiNaC::ex;
using Element = FamilySummand::Element;

/// Makes an algebra in which these symbols vary, and all others are parameters.
Algebra algebra_of(const std::set<std::string>& variables,
                   const std::shared_ptr<const Source>& source) {
    Hamiltonian none;
    none.source = source;
    none.coordinates.assign(variables.begin(), variables.end());
    return Algebra(none);
}

/// Returns the symbol of a family's element at a place; the element need not occur.
std::string symbol_at(const std::vector<Element>& elements, std::size_t family,
                      const std::string& place, const char* kind) {
    for (const Element& element : elements)
        if (element.family == family && element.place == place) return element.symbol;
    return kind + std::to_string(family) + "@" + place;
}

class FamilySearch {
public:
    FamilySearch(const std::vector<FamilySummand>& summands, const std::vector<std::size_t>& shapes,
                 const std::shared_ptr<const Source>& source)
        : summands_(summands),
          shapes_(shapes),
          source_(source),
          unknowns_(shapes.size()),
          algebra_(algebra_of(all_variables(), source)),
          equations_(algebra_) {}

    [[nodiscard]] FamilySymmetries found() {
        FamilySymmetries result;
        result.masses.resize(shapes_.size());
        try {
            for (std::size_t number = shapes_.size(); number < unknowns_.count(); ++number) {
                const auto [f, g] = unknowns_.entry(number);
                if (shapes_[f] != shapes_[g]) insert({{number, 1}});
            }
            for (const FamilySummand& summand : summands_)
                if (!add_equations(summand)) return result;
            for (const SparseVector& field : equations_.solutions(unknowns_.count()))
                fields_.push_back(without_denominators(algebra_, field));
        } catch (const UndecidedEntry&) { return result; }
        for (const SparseVector& field : fields_) result.fields.push_back(written(field));
        for (std::size_t f = 0; f < shapes_.size(); ++f) result.masses[f] = mass(f);
        result.algebra = name_of(result.masses);
        return result;
    }

private:
    [[nodiscard]] std::set<std::string> all_variables() const {
        std::set<std::string> names;
        for (const FamilySummand& summand : summands_) {
            names.insert(summand.others.begin(), summand.others.end());
            for (const auto& [elements, kind] :
                 {std::pair{&summand.coordinates, "q"}, std::pair{&summand.momenta, "p"}})
                for (const Element& element : *elements) {
                    names.insert(element.symbol);
                    for (std::size_t g = 0; g < shapes_.size(); ++g)
                        if (shapes_[g] == shapes_[element.family])
                            names.insert(symbol_at(*elements, g, element.place, kind));
                }
        }
        return names;
    }

    [[nodiscard]] const GiNaC::symbol& symbol(const std::string& name) const {
        return *std::find_if(
            algebra_.variables().begin(), algebra_.variables().end(),
            [&](const GiNaC::symbol& variable) { return variable.get_name() == name; });
    }

    void insert(SparseVector equation) {
        static_cast<void>(equations_.insert(std::move(equation)));
    }

    /// Adds the equations of a summand. Returns whether it is short enough.
    [[nodiscard]] bool add_equations(const FamilySummand& summand) {
        const ex function = algebra_.read(summand.function, source_);
        const GiNaC::exvector jumps = where_it_may_jump(function);
        return add_equations(summand, function) &&
               std::all_of(jumps.begin(), jumps.end(),
                           [&](const ex& jump) { return add_equations(summand, jump); });
    }

    [[nodiscard]] bool add_equations(const FamilySummand& summand, const ex& function) {
        Monomials monomials(algebra_);
        std::vector<ex> changes(unknowns_.count());
        for (const Element& element : summand.coordinates) {
            const ex slope = algebra_.derivative(function, symbol(element.symbol));
            const std::size_t f = element.family;
            changes[f] += slope;
            for (std::size_t g = 0; g < shapes_.size(); ++g)
                if (shapes_[g] == shapes_[f])
                    changes[unknowns_.number(f, g)] +=
                        slope * symbol(symbol_at(summand.coordinates, g, element.place, "q"));
        }
        for (const Element& element : summand.momenta) {
            const ex slope = algebra_.derivative(function, symbol(element.symbol));
            const std::size_t f = element.family;
            for (std::size_t g = 0; g < shapes_.size(); ++g)
                if (shapes_[g] == shapes_[f])
                    changes[unknowns_.number(g, f)] -=
                        slope * symbol(symbol_at(summand.momenta, g, element.place, "p"));
        }
        std::vector<MonomialSum> sums;
        for (const ex& change : changes) {
            auto sum = monomials.sum(change);
            if (!sum) return false;
            sums.push_back(*std::move(sum));
        }
        static_cast<void>(bring_to_common_powers(monomials, sums));
        std::map<FunctionMonomial, SparseVector, MonomialOrder> rows;
        for (std::size_t k = 0; k < sums.size(); ++k)
            for (const auto& [monomial, coefficient] : sums[k]) rows[monomial][k] = coefficient;
        for (auto& [monomial, row] : rows) insert(std::move(row));
        return true;
    }

    [[nodiscard]] FamilyField written(const SparseVector& field) const {
        FamilyField result;
        for (const auto& [number, value] : field) {
            FamilyField::Entry entry{number, {}, algebra_.written(value)};
            if (number >= shapes_.size()) {
                const auto [row, column] = unknowns_.entry(number);
                entry.row = row;
                entry.column = column;
            }
            result.entries.push_back(std::move(entry));
        }
        return result;
    }

    /// Returns the mass m if all terms with momenta of the family are p^2/(2 m), over all of its
    /// elements.
    [[nodiscard]] std::optional<Expression> mass(std::size_t family) {
        std::optional<ex> found;
        for (const FamilySummand& summand : summands_)
            for (const Element& element : summand.momenta) {
                if (element.family != family) continue;
                if (found || !summand.is_over_family) return {};
                const GiNaC::symbol p = symbol(element.symbol);
                const ex slope = algebra_.derivative(algebra_.read(summand.function, source_), p);
                const ex inverse = normal_form(slope / p);
                for (const auto* elements : {&summand.coordinates, &summand.momenta})
                    for (const Element& other : *elements)
                        if (inverse.has(symbol(other.symbol))) return {};
                found = normal_form(1 / inverse);
            }
        return found ? std::optional(algebra_.written(*found)) : std::nullopt;
    }

    /// Returns the name of the algebra for two elements of mass 1 in each family. The algebra is
    /// isomorphic for any number of elements, and for all masses whose sum is not 0.
    [[nodiscard]] std::string name_of(const std::vector<std::optional<Expression>>& masses) const {
        constexpr std::size_t most = 16;
        const std::size_t n = shapes_.size();
        const AffineUnknowns both(2 * n);
        std::vector<SparseVector> basis;
        std::vector<std::size_t> translated;
        for (const SparseVector& field : fields_) {
            SparseVector& twice = basis.emplace_back();
            for (const auto& [number, value] : field) {
                if (!value.info(GiNaC::info_flags::rational)) return "";
                if (number < n) {
                    twice[number] = twice[number + n] = value;
                } else {
                    const auto [f, g] = unknowns_.entry(number);
                    twice[both.number(f, g)] = twice[both.number(f + n, g + n)] = value;
                }
            }
            if (field.size() == 1 && field.begin()->first < n)
                translated.push_back(field.begin()->first);
        }
        for (std::size_t a = 0; a < translated.size(); ++a)
            for (std::size_t b = 0; b < a; ++b) {
                const std::size_t f = translated[a], g = translated[b];
                if (shapes_[f] != shapes_[g] || !masses[f] || masses[f] != masses[g]) continue;
                SparseVector& centre = basis.emplace_back();
                for (const std::size_t i : {std::size_t(0), n})
                    for (const std::size_t j : {std::size_t(0), n}) {
                        centre[both.number(f + i, g + j)] = 1;
                        centre[both.number(g + i, f + j)] = -1;
                    }
            }
        if (basis.empty() || basis.size() > most) return "";
        return name_of_span(both, basis);
    }

    [[nodiscard]] std::string name_of_span(const AffineUnknowns& unknowns,
                                           const std::vector<SparseVector>& basis) const try {
        const std::size_t m = basis.size(), behind = unknowns.count();
        SparseEquations span(algebra_);
        for (std::size_t i = 0; i < m; ++i) {
            SparseVector tagged = basis[i];
            tagged[behind + i] = -1;
            static_cast<void>(span.insert(std::move(tagged)));
        }
        StructureConstants constants(m, std::vector(m, std::vector<GiNaC::numeric>(m)));
        for (std::size_t i = 0; i < m; ++i)
            for (std::size_t j = 0; j < m; ++j)
                for (const auto& [number, value] :
                     span.reduced(poisson_bracket(unknowns, basis[i], basis[j]))) {
                    if (number < behind) return "";
                    constants[i][j][number - behind] = GiNaC::ex_to<GiNaC::numeric>(value);
                }
        if (m == 1 && is_rotation(unknowns, basis.front())) return "so(2)";
        return name_of_algebra(constants);
    } catch (const UndecidedEntry&) { return ""; }

    const std::vector<FamilySummand>& summands_;
    const std::vector<std::size_t>& shapes_;
    const std::shared_ptr<const Source>& source_;
    AffineUnknowns unknowns_;
    Algebra algebra_;
    SparseEquations equations_;
    std::vector<SparseVector> fields_;
};

}  // namespace

FamilySymmetries family_symmetries(const std::vector<FamilySummand>& summands,
                                   const std::vector<std::size_t>& shapes,
                                   const std::shared_ptr<const Source>& source) {
    const Progress::Stage stage("looking for symmetries");
    return FamilySearch(summands, shapes, source).found();
}

bool is_combination(const Expression& function, const std::vector<Expression>& others,
                    const std::vector<std::string>& variables,
                    const std::shared_ptr<const Source>& source) {
    Algebra algebra = algebra_of({variables.begin(), variables.end()}, source);
    std::vector<ex> all{1};
    for (const Expression& other : others) all.push_back(algebra.read(other, source));
    all.push_back(algebra.read(function, source));
    Monomials monomials(algebra);
    std::vector<MonomialSum> sums;
    for (const ex& each : all) {
        auto sum = monomials.sum(each);
        if (!sum) return false;
        sums.push_back(*std::move(sum));
    }
    // NOTE: the last sum is free where it depends on those before it.
    const Relations found = relations(monomials, std::move(sums), nullptr);
    return !found.basis.empty() && found.basis.back().rbegin()->first + 1 == all.size();
}

}  // namespace hvi::gen
