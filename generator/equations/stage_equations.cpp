// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/equations/stage_equations.hpp"

#include <algorithm>
#include <set>
#include <tuple>
#include <utility>

#include "generator/stages/stage_graph.hpp"

namespace hvi::gen {

namespace {

/// Returns the names of the values of coordinates, momenta, and the time where it occurs, in the
/// stages.
std::vector<StageNames> names_in_stages(const Hamiltonian& H, std::size_t stages) {
    std::vector<std::string> varying = variables(H);
    if (depends_on_time(H)) varying.push_back("t");
    std::set<std::string> taken = symbols_in(H.expression);
    taken.insert(varying.begin(), varying.end());
    return stage_names(varying, taken, stages);
}

class Writer {
public:
    Writer(const ButcherPair& pair, const Hamiltonian& H, const Gradient& gradient)
        : H_(H),
          gradient_(gradient),
          terms_(names_in_stages(H, pair.stages())),
          method_(partitioned_method(pair)),
          nodes_(pair.c) {
        for (const NumberVector& row : pair.A) A_.push_back(terms_.written(row));
        for (const NumberVector& row : pair.A_tilde) A_tilde_.push_back(terms_.written(row));
        b_ = terms_.written(pair.b);
    }

    [[nodiscard]] StageEquations equations();

private:
    [[nodiscard]] Expression value(std::size_t variable, const Row& for_q, const Row& for_p);
    [[nodiscard]] bool is_needed(const std::string& variable) const;
    [[nodiscard]] SlopePattern slopes() const;
    void set_stages(StageEquations& result);

    const Hamiltonian& H_;
    const Gradient& gradient_;
    StageTerms terms_;
    PartitionedMethod method_;
    NumberVector nodes_;
    std::vector<Row> A_, A_tilde_;
    Row b_;
};

/// Returns q + h sum_j a_j dH/dp(Q^j, P^j), or p - h sum_j a~_j dH/dq(Q^j, P^j).
Expression Writer::value(std::size_t variable, const Row& for_q, const Row& for_p) {
    const std::size_t n = H_.degrees_of_freedom();
    if (variable < n)
        return terms_.moved(Expression::symbol(H_.coordinates[variable]),
                            gradient_.by_momenta[variable], for_q, false);
    return terms_.moved(Expression::symbol(H_.momenta[variable - n]),
                        gradient_.by_coordinates[variable - n], for_p, true);
}

bool Writer::is_needed(const std::string& variable) const {
    return occurs_in(variable, gradient_.by_coordinates) ||
           occurs_in(variable, gradient_.by_momenta);
}

/// Returns the variables that each derivative depends on.
SlopePattern Writer::slopes() const {
    const auto pattern = [](const std::vector<Expression>& derivatives,
                            const std::vector<std::string>& names) {
        Pattern result;
        for (const Expression& derivative : derivatives) {
            const std::set<std::string> symbols = symbols_in(derivative);
            std::vector<bool>& row = result.emplace_back();
            for (const std::string& name : names) row.push_back(symbols.count(name) != 0);
        }
        return result;
    };
    return {pattern(gradient_.by_momenta, H_.coordinates),
            pattern(gradient_.by_momenta, H_.momenta),
            pattern(gradient_.by_coordinates, H_.coordinates),
            pattern(gradient_.by_coordinates, H_.momenta)};
}

/// Adds the stage values that a derivative depends on.
void Writer::set_stages(StageEquations& result) {
    std::vector<StageNode> values;
    result.is_explicit = true;
    for (const std::vector<StageNode>& group : groups_in_order(stage_pattern(method_, slopes()))) {
        result.is_explicit = result.is_explicit && group.size() == 1;
        values.insert(values.end(), group.begin(), group.end());
    }
    if (!result.is_explicit)
        std::sort(values.begin(), values.end(), [](const StageNode& a, const StageNode& b) {
            return std::tie(a.kind, a.variable, a.index) < std::tie(b.kind, b.variable, b.index);
        });
    const std::vector<std::string> all = variables(H_);
    for (const StageNode& node : values) {
        const bool is_q = node.kind == StageNode::Kind::Q;
        if (!is_q && node.kind != StageNode::Kind::P) continue;
        const std::size_t k = is_q ? node.variable : H_.degrees_of_freedom() + node.variable;
        const std::size_t i = node.index;
        if (is_needed(all[k]))
            result.stages.push_back({terms_.name(all[k], i), value(k, A_[i], A_tilde_[i])});
    }
}

/// NOTE: an H that depends on time is one without: H(q, p, t) + e, with t as one more coordinate
/// and e for its momentum. Then t' = 1, and (4.18) gives t + h sum_j a_ij = t + c_i h in the
/// stages, since constants are in the span of the basis. Nothing else depends on e.
StageEquations Writer::equations() {
    StageEquations result;
    if (is_needed("t"))
        for (std::size_t i = 0; i < nodes_.size(); ++i)
            result.stages.push_back(terms_.time(i, nodes_[i]));
    set_stages(result);
    const std::vector<std::string> all = variables(H_);
    for (std::size_t k = 0; k < all.size(); ++k)
        result.update.push_back({all[k], value(k, b_, b_)});
    result.is_exact = terms_.is_exact();
    return result;
}

}  // namespace

StageEquations stage_equations(const ButcherPair& pair, const Hamiltonian& hamiltonian,
                               const Gradient& gradient) {
    return Writer(pair, hamiltonian, gradient).equations();
}

}  // namespace hvi::gen
