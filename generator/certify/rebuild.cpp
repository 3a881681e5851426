// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/certify/rebuild.hpp"

#include <algorithm>
#include <utility>

#include "generator/exact/algebra/matrix.hpp"
#include "generator/exact/methods/collocation.hpp"
#include "generator/exact/methods/galerkin.hpp"
#include "generator/exact/methods/nodes.hpp"
#include "generator/exact/methods/properties.hpp"
#include "generator/exact/numbers/rounded.hpp"
#include "generator/read/catalogue.hpp"
#include "generator/support/progress.hpp"

namespace hvi::gen {
namespace {

/// Whether wrong entries, or different nodes, are few: at most a third.
bool are_few(std::size_t wrong, std::size_t all) { return 3 * wrong <= all; }

/// The question about a tableau.
struct Question {
    const Coefficients& coefficients;
    const GivenTableau& given;
};

/// A tableau that may have been meant.
struct Candidate {
    std::optional<Tableau> tableau;
    NodesAndMethod right;
    NodesAndMethod possible;  ///< entries for all nodes that the given ones may be
};

// ---- entries ----

/// An entry of the file with its right value.
struct Entry {
    std::string place;
    const Coefficient* text;
    const Number* written;
    const Number* enclosed;
    const Number* right;
    const Number* possible;
};

class Entries {
public:
    Entries(const Question& question, const NodesAndMethod& right, const NodesAndMethod& possible)
        : question_(question), right_(right), possible_(possible) {
        const Coefficients& texts = question.coefficients;
        append("c", texts.c, [](const NodesAndMethod& numbers) { return &numbers.c; });
        append("b", texts.b, [](const NodesAndMethod& numbers) { return &numbers.method.b; });
        if (texts.b_tilde) {
            append("b_tilde", *texts.b_tilde,
                   [](const NodesAndMethod& numbers) { return &numbers.method.b_tilde; });
        }
        append("A", texts.A, &PartitionedMethod::A);
        if (texts.A_tilde) { append("A_tilde", *texts.A_tilde, &PartitionedMethod::A_tilde); }
    }

    [[nodiscard]] const std::vector<Entry>& all() const { return all_; }

private:
    template <class Part>
    void append(const std::string& name, const CoefficientVector& texts, Part part) {
        const GivenTableau& given = question_.given;
        for (std::size_t i = 0; i < texts.size(); ++i) {
            const auto at = [&](const NodesAndMethod& numbers) { return &(*part(numbers))[i]; };
            all_.push_back({name + "[" + std::to_string(i + 1) + "]", &texts[i], at(given.written),
                            at(given.enclosed), at(right_), at(possible_)});
        }
    }

    void append(const std::string& name, const CoefficientMatrix& texts,
                NumberMatrix PartitionedMethod::*matrix) {
        for (std::size_t i = 0; i < texts.size(); ++i) {
            append(name + "[" + std::to_string(i + 1) + "]", texts[i],
                   [&](const NodesAndMethod& numbers) { return &(numbers.method.*matrix)[i]; });
        }
    }

    const Question& question_;
    const NodesAndMethod& right_;
    const NodesAndMethod& possible_;
    std::vector<Entry> all_;
};

std::string trimmed(const std::string& text) {
    const std::size_t begin = std::min(text.find_first_not_of(" \t\r\n"), text.size());
    return text.substr(begin, text.find_last_not_of(" \t\r\n") + 1 - begin);
}

Rebuilt compared(const Question& question, Candidate candidate) {
    const Precision bits = question.given.bits;
    const Entries entries(question, candidate.right, candidate.possible);
    Rebuilt result;
    Verdict verdict;
    for (const Entry& entry : entries.all()) {
        const Verdict agrees = can_agree(*entry.enclosed, *entry.possible, bits);
        verdict = verdict && agrees;
        if (!agrees.holds) {
            result.wrong.push_back({entry.place, trimmed(entry.text->source->text), *entry.right});
        }
        const auto places = common_places(*entry.written, *entry.possible, bits);
        if (places) { result.places = std::min(*places, result.places.value_or(*places)); }
    }
    result.compared = entries.all().size();
    result.proved = verdict.holds && verdict.proved;
    result.tableau = std::move(candidate.tableau);
    result.right = std::move(candidate.right);
    return result;
}

// ---- pairs of matrices ----

NodesAndMethod with_matrices(const NodesAndMethod& numbers, Matrix A, Matrix A_tilde) {
    const auto matrix = [&](Matrix which) {
        return which == Matrix::A ? numbers.method.A : numbers.method.A_tilde;
    };
    NodesAndMethod result = numbers;
    result.method.A = matrix(A);
    result.method.A_tilde = matrix(A_tilde);
    return result;
}

struct Pair {
    Matrix A, A_tilde;
};

/// Returns the pairs that may be meant, the method itself first. NOTE: without A~ in the file, A
/// stands for it, and only a method with A == A~ is such a pair.
std::vector<Pair> pairs(const Question& question, const Candidate& candidate) {
    const Pair itself{Matrix::A, Matrix::A_tilde};
    const Pair twice{Matrix::A, Matrix::A};
    const Pair partner_twice{Matrix::A_tilde, Matrix::A_tilde};
    if (question.coefficients.A_tilde) {
        return {itself, {Matrix::A_tilde, Matrix::A}, twice, partner_twice};
    }
    if (is_runge_kutta(*candidate.tableau).holds) { return {itself}; }
    return {twice, partner_twice};
}

/// Keeps the better one of `best` and a candidate: the first of those with the fewest wrong
/// entries.
void keep_better(std::optional<Rebuilt>& best, const Question& question,
                 const Candidate& candidate) {
    for (const auto [A, A_tilde] : pairs(question, candidate)) {
        Rebuilt next =
            compared(question, {candidate.tableau, with_matrices(candidate.right, A, A_tilde),
                                with_matrices(candidate.possible, A, A_tilde)});
        next.A = A;
        next.A_tilde = A_tilde;
        if (!best || next.wrong.size() < best->wrong.size()) { best = std::move(next); }
    }
}

// ---- methods with names ----

Method method_of(const std::string& name) {
    return named_method(std::make_shared<const Source>(Source{"--method", name}));
}

/// Returns the methods with this number of stages. The name that the file gives itself comes first,
/// then single methods, for `stormer-verlet` says more than `lobatto:2`.
std::vector<Method> methods_of_size(std::size_t stages, const std::string& file_name) {
    std::vector<Method> result;
    for (const MethodEntry& entry : named_methods()) {
        Method method = method_of(std::string(entry.name));
        if (method.nodes.items.size() == stages) { result.push_back(std::move(method)); }
    }
    const auto size = static_cast<long>(stages);
    for (const FamilyEntry& entry : node_families()) {
        if (size < entry.smallest) { continue; }
        try {
            result.push_back(method_of(std::string(entry.name) + ":" + std::to_string(size)));
        } catch (const MathError&) { continue; }  // Chebyshev's nodes are not real
    }
    std::stable_partition(result.begin(), result.end(),
                          [&](const Method& method) { return method.name == file_name; });
    return result;
}

/// Returns the number of the method's node for each given node. Nodes without a match take the
/// remaining numbers, if they are few. NOTE: decides by enclosures alone. Most methods have other
/// nodes, which then leave no generators in the field of the tableau.
std::optional<std::vector<std::size_t>> permutation(const Method& method,
                                                    const GivenTableau& given) {
    const NumberVector nodes = on_new_ground(
        [&](const Ground& ground) { return quadrature_nodes(method.nodes, ground).c; });
    const NumberVector& c = given.enclosed.c;
    constexpr std::size_t none = static_cast<std::size_t>(-1);
    std::vector<std::size_t> result(c.size(), none);
    std::vector<bool> taken(c.size());
    std::size_t unknown = 0;
    for (std::size_t i = 0; i < c.size(); ++i) {
        for (std::size_t k = 0; k < c.size() && result[i] == none; ++k) {
            if (!taken[k] && overlap(c[i], nodes[k], given.bits)) { result[i] = k; }
        }
        if (result[i] != none) { taken[result[i]] = true; }
        unknown += result[i] == none ? 1 : 0;
        if (!are_few(unknown, c.size())) { return std::nullopt; }
    }
    for (std::size_t& image : result) {
        if (image != none) { continue; }
        image =
            static_cast<std::size_t>(std::find(taken.begin(), taken.end(), false) - taken.begin());
        taken[image] = true;
    }
    return result;
}

NumberVector permuted(const NumberVector& numbers, const std::vector<std::size_t>& order) {
    NumberVector result;
    for (const std::size_t i : order) { result.push_back(numbers[i]); }
    return result;
}

NumberMatrix permuted(const NumberMatrix& rows, const std::vector<std::size_t>& order) {
    NumberMatrix result;
    for (const std::size_t i : order) { result.push_back(permuted(rows[i], order)); }
    return result;
}

/// Returns the result of `work`, or nothing where there is no such method.
template <class Work>
auto if_possible(Work work) -> std::optional<decltype(work())> {
    try {
        return work();
    } catch (const MathError&) { return std::nullopt; } catch (const InputError&) {
        return std::nullopt;
    }  // beyond what a method may need
}

void look_at_names(std::optional<Rebuilt>& best, const Question& question, const Ground& ground) {
    for (const Method& method :
         methods_of_size(question.given.stages(), question.coefficients.name)) {
        const auto order = permutation(method, question.given);
        if (!order) { continue; }
        auto tableau = if_possible([&] { return derive_on(ground, method).tableau; });
        if (!tableau) { continue; }
        const NodesAndMethod right{permuted(tableau->c, *order),
                                   {permuted(tableau->b, *order), permuted(tableau->b, *order),
                                    permuted(tableau->A, *order),
                                    permuted(tableau->A_tilde, *order)}};
        keep_better(best, question, {std::move(tableau), right, right});
        if (best->is_right()) { return; }
    }
}

// ---- the given nodes, and the given A ----

/// Whether enough digits of the entries are known for a comparison.
bool are_known(const NodesAndMethod& possible, const NodesAndMethod& right,
               const GivenTableau& given) {
    const auto is_known = [&](const Number& number, const Number& value) {
        const auto places = common_places(number, value, given.bits);
        return !places || *places >= given.digits / 2;
    };
    const auto row_known = [&](const NumberVector& row, const NumberVector& values) {
        return std::equal(row.begin(), row.end(), values.begin(), is_known);
    };
    const auto known = [&](const NumberMatrix& rows, const NumberMatrix& values) {
        return std::equal(rows.begin(), rows.end(), values.begin(), row_known);
    };
    return row_known(possible.method.b, right.method.b) &&
           known(possible.method.A, right.method.A) &&
           known(possible.method.A_tilde, right.method.A_tilde);
}

Method collocation_at(const CoefficientVector& c) {
    const auto source = [](const char* name, std::string text) {
        return std::make_shared<const Source>(Source{name, std::move(text)});
    };
    std::string nodes;
    for (const Coefficient& node : c) {
        nodes += (nodes.empty() ? "" : ", ") + to_text(node.value);
    }
    return method_from_text(source("--basis", "monomials:" + std::to_string(c.size())),
                            source("--nodes", std::move(nodes)));
}

bool are_rounded(const CoefficientVector& numbers) {
    return std::any_of(numbers.begin(), numbers.end(),
                       [](const Coefficient& number) { return number.rounded.has_value(); });
}

void look_at_nodes(std::optional<Rebuilt>& best, const Question& question, const Ground& ground) {
    const Coefficients& coefficients = question.coefficients;
    const GivenTableau& given = question.given;
    auto tableau = if_possible([&] {
        Method method = collocation_at(coefficients.c);
        method.parameters = coefficients.parameters;
        return derive_on(ground, method).tableau;
    });
    if (!tableau) { return; }
    NodesAndMethod right{given.written.c, partitioned_method(*tableau)};
    NodesAndMethod possible = right;
    if (are_rounded(coefficients.c)) {
        auto enclosed = enclosed_collocation(given.enclosed.c, given.bits);
        if (!enclosed) { return; }
        possible.method = *std::move(enclosed);
        if (!are_known(possible, right, given)) { return; }
        // NOTE: a closed form would have more digits than the nodes.
        PartitionedMethod& method = right.method;
        method = {without_closed_form(method.b), without_closed_form(method.b),
                  without_closed_form(method.A), without_closed_form(method.A_tilde)};
    }
    keep_better(best, question, {std::move(tableau), right, possible});
}

/// Compares A~ with the symplectic partner of the given A.
std::optional<Rebuilt> partner_of_A(const Question& question) {
    const auto& [coefficients, given] = question;
    NodesAndMethod right = given.written;
    right.method.b_tilde = right.method.b;
    NodesAndMethod possible = right;
    const auto written = symplectic_partner(right.method.b, right.method.A, given.bits);
    const auto enclosed =
        symplectic_partner(given.enclosed.method.b, given.enclosed.method.A, given.bits);
    if (!written || !enclosed) { return std::nullopt; }
    right.method.A_tilde = given.rounded == 0 ? *written : without_closed_form(*written);
    possible.method.A_tilde = *enclosed;
    Rebuilt result = compared(question, {std::nullopt, right, possible});
    const std::size_t s = given.stages();
    result.compared = s * s + (coefficients.b_tilde ? s : 0);
    return result;
}

}  // namespace

std::optional<Rebuilt> rebuild(const Coefficients& coefficients, const GivenTableau& given,
                               const Ground& ground) {
    if (!given.parameters.empty()) { return std::nullopt; }
    const Progress::Stage stage("comparing with known methods");
    const Question question{coefficients, given};
    const auto is_good = [](const std::optional<Rebuilt>& found) {
        return found && are_few(found->wrong.size(), found->compared);
    };
    std::optional<Rebuilt> best;
    look_at_names(best, question, ground);
    const bool rounded = are_rounded(coefficients.c);
    if (!is_good(best) || !(rounded || best->is_right())) {
        std::optional<Rebuilt> by_nodes = rounded ? std::nullopt : best;
        look_at_nodes(by_nodes, question, ground);
        if (by_nodes && rounded) { by_nodes->determined = false; }
        if (by_nodes) { best = std::move(by_nodes); }
    }
    if (is_good(best)) { return best; }
    if (!coefficients.A_tilde) { return std::nullopt; }
    best = partner_of_A(question);
    if (best) { best->determined = given.rounded == 0; }
    return is_good(best) ? best : std::nullopt;
}

}  // namespace hvi::gen
