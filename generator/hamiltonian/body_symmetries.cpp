// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/hamiltonian/body_symmetries.hpp"

#include <algorithm>
#include <set>
#include <utility>

#include "generator/hamiltonian/affine_fields.hpp"
#include "generator/hamiltonian/body_motion.hpp"
#include "generator/hamiltonian/ginac_functions.hpp"
#include "generator/hamiltonian/lie_algebra.hpp"
#include "generator/hamiltonian/normal_form.hpp"
#include "generator/hamiltonian/relations.hpp"
#include "generator/support/progress.hpp"

namespace hvi::gen {

namespace {

using GiNaC::ex;

/// The unknowns of a symmetry in their order: d and C of the coordinates, then the omega of all
/// rotations, then the eta.
class BodyUnknowns {
public:
    explicit BodyUnknowns(const BodyMotion& motion)
        : affine_(motion.coordinates()), rotations_(motion.rotations()) {}

    [[nodiscard]] const AffineUnknowns& affine() const { return affine_; }
    [[nodiscard]] std::size_t count() const { return affine_.count() + 6 * rotations_; }

    struct Turn {
        bool is_of_body;
        std::size_t rotation, axis;
    };
    /// Precondition: number >= affine().count().
    [[nodiscard]] Turn turn(std::size_t number) const {
        const std::size_t k = number - affine_.count();
        const bool is_of_body = k >= 3 * rotations_;
        const std::size_t l = is_of_body ? k - 3 * rotations_ : k;
        return {is_of_body, l / 3, l % 3};
    }

private:
    AffineUnknowns affine_;
    std::size_t rotations_;
};

/// Changes of H along unit fields, one for each unknown, and velocities of the entries of R.
class BodyFields {
public:
    explicit BodyFields(const BodyMotion& motion) : motion_(motion), unknowns_(motion) {}

    [[nodiscard]] const BodyUnknowns& unknowns() const { return unknowns_; }

    [[nodiscard]] ex change(std::size_t number) const {
        const ex& H = motion_.algebra().function();
        const std::size_t n = motion_.coordinates();
        if (number < n) return motion_.by(H, motion_.q(number));
        if (number < unknowns_.affine().count()) {
            const auto [i, j] = unknowns_.affine().entry(number);
            return motion_.by(H, motion_.q(i)) * motion_.q(j) -
                   motion_.by(H, motion_.p(j)) * motion_.p(i);
        }
        const auto [is_of_body, r, a] = unknowns_.turn(number);
        if (!is_of_body) {
            ex sum;
            for (std::size_t i = 0; i < 3; ++i)
                for (std::size_t j = 0; j < 3; ++j)
                    sum += motion_.by(H, motion_.R(r, i, j)) * velocity(number, r, i, j);
            return sum;
        }
        const std::size_t b = (a + 1) % 3, c = (a + 2) % 3;
        const BodyMotion::Triple Omega = motion_.by_momentum(H, r);
        return motion_.by_turns(H, r)[a] + Omega[b] * motion_.L(r, c) - Omega[c] * motion_.L(r, b);
    }

    /// Returns the velocity of entry i, j of rotation r: the entry of hat(e_a) R, or of R hat(e_a).
    [[nodiscard]] ex velocity(std::size_t number, std::size_t r, std::size_t i,
                              std::size_t j) const {
        const auto [is_of_body, rotation, a] = unknowns_.turn(number);
        if (rotation != r) return 0;
        const std::size_t b = (a + 1) % 3, c = (a + 2) % 3;
        if (is_of_body) {
            if (j == b) return motion_.R(r, i, c);
            return j == c ? ex(-motion_.R(r, i, b)) : ex(0);
        }
        if (i == c) return motion_.R(r, b, j);
        return i == b ? ex(-motion_.R(r, c, j)) : ex(0);
    }

    [[nodiscard]] ex momentum_map(std::size_t number) const {
        if (number < motion_.coordinates()) return motion_.p(number);
        if (number < unknowns_.affine().count()) {
            const auto [i, j] = unknowns_.affine().entry(number);
            return motion_.p(i) * motion_.q(j);
        }
        const auto [is_of_body, r, a] = unknowns_.turn(number);
        if (is_of_body) return motion_.L(r, a);
        ex sum;
        for (std::size_t k = 0; k < 3; ++k) sum += motion_.R(r, a, k) * motion_.L(r, k);
        return sum;
    }

    /// Returns the velocities of all coordinates, including the entries of rotations.
    [[nodiscard]] std::vector<Expression> generator(const SparseVector& field) const {
        const std::size_t n = motion_.coordinates();
        std::vector<ex> components(n + 9 * motion_.rotations());
        for (const auto& [number, value] : field) {
            if (number < n) {
                components[number] += value;
            } else if (number < unknowns_.affine().count()) {
                const auto [i, j] = unknowns_.affine().entry(number);
                components[i] += value * motion_.q(j);
            } else {
                const std::size_t r = unknowns_.turn(number).rotation;
                for (std::size_t k = 0; k < 9; ++k)
                    components[n + 9 * r + k] += value * velocity(number, r, k / 3, k % 3);
            }
        }
        std::vector<Expression> result;
        for (const ex& component : components)
            result.push_back(motion_.algebra().written(multiplied_out(component)));
        return result;
    }

    [[nodiscard]] Expression momentum_map(const SparseVector& field) const {
        ex sum;
        for (const auto& [number, value] : field) sum += value * momentum_map(number);
        return motion_.algebra().written(multiplied_out(sum));
    }

private:
    const BodyMotion& motion_;
    BodyUnknowns unknowns_;
};

/// Returns the unknowns that relations solve for: all but the last of each relation.
std::vector<std::size_t> solved_for(const std::vector<SparseVector>& basis, std::size_t count) {
    std::set<std::size_t> free;
    for (const SparseVector& relation : basis) free.insert(relation.rbegin()->first);
    std::vector<std::size_t> result;
    for (std::size_t number = 0; number < count; ++number)
        if (free.count(number) == 0) result.push_back(number);
    return result;
}

struct Found {
    std::vector<SparseVector> basis;
    std::string doubt;
};

Found solved(const BodyMotion& motion, const BodyFields& fields) {
    Monomials monomials(motion.algebra());
    std::vector<MonomialSum> sums;
    std::vector<Expression> written;
    for (std::size_t number = 0; number < fields.unknowns().count(); ++number) {
        const ex change = fields.change(number);
        auto sum = monomials.sum(change);
        if (!sum) return {{}, "the derivatives of H have too many terms"};
        sums.push_back(*std::move(sum));
        written.push_back(motion.algebra().written(change));
    }
    Found found{relations(monomials, std::move(sums), nullptr).basis, ""};
    const Sampler at_rotations = [&](const SymbolValues& point) {
        const SymbolValues values = motion.with_rotations(point);
        std::vector<Ball> result;
        for (const Expression& change : written)
            result.push_back(value_at(change, values, nullptr));
        return result;
    };
    if (!are_independent_at_points(motion.algebra(), at_rotations,
                                   solved_for(found.basis, written.size())))
        found.doubt = "that there are no others is not seen at the rotations that were tried";
    return found;
}

/// Returns the bracket of momentum maps. It is that of affine fields for coordinates, omega_1 x
/// omega_2 for turns of space, and its opposite for turns of a body.
SparseVector bracket(const BodyUnknowns& unknowns, const SparseVector& a, const SparseVector& b) {
    const std::size_t count = unknowns.affine().count();
    const auto affine = [&](const SparseVector& all) {
        return SparseVector(all.begin(), all.lower_bound(count));
    };
    SparseVector result = poisson_bracket(unknowns.affine(), affine(a), affine(b));
    const auto at = [](const SparseVector& of, std::size_t number) {
        const auto found = of.find(number);
        return found == of.end() ? ex(0) : found->second;
    };
    for (std::size_t first = count; first < unknowns.count(); first += 3) {
        const int sign = unknowns.turn(first).is_of_body ? -1 : 1;
        for (std::size_t k = 0; k < 3; ++k) {
            const std::size_t l = first + (k + 1) % 3, m = first + (k + 2) % 3;
            const ex value = normal_form(at(a, l) * at(b, m) - at(a, m) * at(b, l));
            if (!value.is_zero()) result[first + k] = sign * value;
        }
    }
    return result;
}

/// Returns nothing where a bracket is not seen to be in the basis.
std::optional<SymmetryAlgebra> algebra_of(const Algebra& algebra, const BodyUnknowns& unknowns,
                                          const std::vector<SparseVector>& basis) try {
    const std::size_t size = basis.size(), behind = unknowns.count();
    SparseEquations span(algebra);
    for (std::size_t i = 0; i < size; ++i) {
        SparseVector tagged = basis[i];
        tagged[behind + i] = -1;
        static_cast<void>(span.insert(std::move(tagged)));
    }
    SymmetryAlgebra result;
    std::vector<StructureConstant> constants;
    StructureConstants numbers(size, std::vector(size, std::vector<GiNaC::numeric>(size)));
    bool are_numbers = true;
    for (std::size_t i = 0; i < size; ++i)
        for (std::size_t j = i + 1; j < size; ++j)
            for (const auto& [number, value] :
                 span.reduced(bracket(unknowns, basis[i], basis[j]))) {
                if (number < behind) return {};
                const std::size_t k = number - behind;
                constants.push_back({i, j, k, algebra.written(value)});
                are_numbers = are_numbers && value.info(GiNaC::info_flags::rational);
                if (!are_numbers) continue;
                numbers[i][j][k] = GiNaC::ex_to<GiNaC::numeric>(value);
                numbers[j][i][k] = -numbers[i][j][k];
            }
    if (are_numbers) result.name = name_of_algebra(numbers);
    result.constants = std::move(constants);
    return result;
} catch (const UndecidedEntry&) { return {}; }

AffineSymmetries named(const BodyMotion& motion, const BodyFields& fields, Found found) {
    struct Named {
        SparseVector field;
        AffineSymmetry symmetry;
    };
    std::vector<Named> all;
    for (const SparseVector& field : found.basis) {
        SparseVector whole = without_denominators(motion.algebra(), field);
        AffineSymmetry symmetry{fields.generator(whole), fields.momentum_map(whole)};
        all.push_back({std::move(whole), std::move(symmetry)});
    }
    std::stable_sort(all.begin(), all.end(), [](const Named& a, const Named& b) {
        return word_count(a.symmetry.momentum_map) < word_count(b.symmetry.momentum_map);
    });
    AffineSymmetries result;
    result.doubt = std::move(found.doubt);
    std::vector<SparseVector> basis;
    for (Named& each : all) {
        basis.push_back(std::move(each.field));
        result.basis.push_back(std::move(each.symmetry));
    }
    if (!basis.empty()) result.algebra = algebra_of(motion.algebra(), fields.unknowns(), basis);
    return result;
}

AffineSymmetries found_with(const Hamiltonian& hamiltonian) {
    const BodyMotion motion(hamiltonian);
    const BodyFields fields(motion);
    return named(motion, fields, solved(motion, fields));
}

/// Whether I is a sum of multiples of the functions and a constant.
bool is_made_of(const Algebra& algebra, const ex& I, const std::vector<ex>& maps) {
    Monomials monomials(algebra);
    std::vector<MonomialSum> sums;
    std::vector<ex> functions{1};
    functions.insert(functions.end(), maps.begin(), maps.end());
    functions.push_back(I);
    for (const ex& function : functions) {
        auto sum = monomials.sum(function);
        if (!sum) return false;
        sums.push_back(*std::move(sum));
    }
    const Relations found = relations(monomials, std::move(sums), nullptr);
    return !found.basis.empty() && found.basis.back().rbegin()->first + 1 == functions.size();
}

}  // namespace

AffineSymmetries body_symmetries(const Hamiltonian& hamiltonian) {
    const Progress::Stage stage("looking for symmetries");
    AffineSymmetries with_values = found_with(hamiltonian);
    if (hamiltonian.parameters.empty()) return with_values;
    Hamiltonian general = hamiltonian;
    general.parameters.clear();
    AffineSymmetries with_symbols = found_with(general);
    if (with_symbols.basis.size() != with_values.basis.size()) return with_values;
    with_symbols.doubt = with_values.doubt;
    return with_symbols;
}

std::vector<QuantityFinding> body_findings(const Hamiltonian& hamiltonian,
                                           const std::vector<Quantity>& quantities,
                                           const std::vector<Expression>& maps) {
    const Progress::Stage stage("looking at invariants");
    BodyMotion motion(hamiltonian);
    std::vector<ex> momentum_maps;
    for (const Expression& map : maps) momentum_maps.push_back(motion.algebra().read(map, nullptr));
    std::vector<QuantityFinding> result;
    for (const Quantity& quantity : quantities) {
        const ex I = motion.algebra().read(quantity.expression, quantity.source);
        QuantityFinding& finding = result.emplace_back();
        finding.bracket = Expression::integer(0);
        finding.is_momentum_map = is_made_of(motion.algebra(), I, momentum_maps);
        // NOTE: such a quantity is conserved as the maps are, so its bracket, which may be long, is
        // not needed.
        if (finding.is_momentum_map) {
            finding.conserved = Vanishing::proved;
            continue;
        }
        const ex bracket = motion.bracket(I);
        finding.conserved = motion.vanishes(bracket);
        // NOTE: derivatives do not see jumps.
        const bool may_jump =
            !where_it_may_jump(I).empty() && !I.is_equal(motion.algebra().function());
        if (may_jump && finding.conserved == Vanishing::proved)
            finding.conserved = Vanishing::unknown;
        if (finding.conserved != Vanishing::proved)
            finding.bracket = motion.algebra().written(multiplied_out(bracket));
    }
    return result;
}

}  // namespace hvi::gen
