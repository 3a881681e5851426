// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/certify/swept_certificate.hpp"

#include <algorithm>

#include "generator/exact/numbers/budget.hpp"
#include "generator/stages/stage_graph.hpp"

namespace hvi::gen {

namespace {

bool is_any(const NumberVector& row) {
    return std::any_of(row.begin(), row.end(),
                       [](const Number& entry) { return entry.known_zero() != true; });
}

/// Returns whether all stage values but those at the start of the step are solved for at once.
bool are_all_iterated(const PartitionedMethod& method, bool separable) {
    const auto groups = coupled_stages(method, separable);
    if (groups.size() != 1) { return false; }
    const auto has = [&](StageNode::Kind kind, std::size_t i) {
        const StageNode node{kind, i};
        return std::find(groups.front().begin(), groups.front().end(), node) !=
               groups.front().end();
    };
    for (std::size_t i = 0; i < method.stages(); ++i) {
        if (is_any(method.A[i]) && !has(StageNode::Kind::Q, i)) { return false; }
        if (is_any(method.A_tilde[i]) && !has(StageNode::Kind::P, i)) { return false; }
    }
    return true;
}

void set_oscillator_of_sweeps(SweptCertificate& result, const Tableau& tableau) {
    constexpr int most = 20;  // of more the intervals of stability take minutes
    if (!result.nystrom || result.sweeps > most || takes_long(tableau)) { return; }
    result.oscillator = swept_oscillator(tableau, result.sweeps);
    result.growth = first_of_determinant(*result.oscillator);
    if (result.parameters.empty()) {
        result.stability = linear_stability(*result.oscillator, stability_limit);
    }
}

SweptCertificate certified_sweeps(const Tableau& tableau, int sweeps, int max_order,
                                  std::optional<ExtrapolatedSlopes> extrapolated) {
    SweptCertificate result;
    result.name = tableau.provenance.name;
    result.origin = tableau.provenance.origin;
    result.parameters = tableau.parameters;
    result.stages = tableau.stages();
    result.sweeps = sweeps;
    const PartitionedMethod method = partitioned_method(tableau);
    const auto family = [&](SweepForm form, TreeFamily of) {
        return swept_family(tableau, form, of, sweeps, max_order);
    };
    if (are_all_iterated(method, false)) {
        result.in_turn = family(SweepForm::in_turn, TreeFamily::general);
        result.at_once = family(SweepForm::at_once, TreeFamily::general);
    }
    if (are_all_iterated(method, true)) {
        result.separable = family(SweepForm::in_turn, TreeFamily::separable);
        result.nystrom = family(SweepForm::positions, TreeFamily::nystrom);
    }
    if (result.is_empty()) { return result; }
    set_oscillator_of_sweeps(result, tableau);
    if (extrapolated) {
        result.extrapolated = extrapolated;
        result.starting_order =
            std::min(static_cast<int>(extrapolated->degree), stage_order(tableau)) + 1;
    }
    return result;
}

}  // namespace

bool SweptCertificate::is_proved() const {
    bool proved = Findings::is_proved();
    for (const auto* family : {&in_turn, &at_once, &separable, &nystrom}) {
        proved = proved && (!*family || (*family)->order.proved);
    }
    return proved;
}

SweptCertificate certify_sweeps(const Method& method, const Tableau& tableau, int sweeps,
                                int max_order, std::optional<ExtrapolatedSlopes> extrapolated) {
    try {
        return certified_sweeps(tableau, sweeps, max_order, extrapolated);
    } catch (const TooLarge& error) {
        throw MathError(error.what(), whole(method.basis.source), error.help());
    }
}

int power_for_any(const SweptCertificate& certificate) {
    return certificate.starting_order + certificate.sweeps;
}
int power_for_separable(const SweptCertificate& certificate) {
    return certificate.starting_order + 2 * certificate.sweeps - 1;
}
int power_for_nystrom(const SweptCertificate& certificate) {
    return certificate.starting_order + 2 * certificate.sweeps;
}

}  // namespace hvi::gen
