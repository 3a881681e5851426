// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/exact/methods/splitting.hpp"

#include <memory>
#include <string_view>
#include <vector>

#include "generator/exact/methods/composed_method.hpp"
#include "generator/exact/methods/galerkin.hpp"
#include "generator/exact/numbers/decimal_number.hpp"
#include "generator/support/error.hpp"

namespace hvi::gen {

namespace {

/// Half of the coefficients of a splitting.
struct Entry {
    std::string_view name;
    std::vector<std::string_view> a, b;  ///< without the last ones before the mirror
    bool has_middle;                     ///< whether a flow of B is in the middle, else one of A
};

/// Digits to which sums of these coefficients are known.
constexpr int digits_of_entries = 54;

// NOTE: the digits are computed anew from those that the authors print, by Newton's method on the
// conditions for their orders in 90 digits; these are as many as the coefficients.
const std::vector<Entry>& entries() {
    static const std::vector<Entry> all{
        // McLachlan, BIT 35 (1995) 258.
        {"mclachlan:8.4",
         {"0.075346960269892888416527803683474464372652664554079063141",
          "0.517916854688256782300773978496315644323847447821980915026"},
         {"0.190225939373676619245230762738453897461203619904872644687",
          "0.846524070443526257055080544646775834177113742394682854556"},
         true},
        // ABA1064 of Blanes, Casas, Farres, Laskar, Makazaga & Murua, Appl. Numer. Math. 68 (2013)
        // 58.
        {"blanes:10.6.4",
         {"0.0380944974224121954569753223086375653406600603958069701639",
          "0.145298716116913749294020072660663749744308885146126023663",
          "0.207627695725541250716205611324988206515836968446160915077",
          "0.435909703651526159223154862401065184400688796494327254963"},
         {"0.0958588808370752106107715037714588477693422260407147003278",
          "0.204446153142998780680507783916434477976329958617371067841",
          "0.217070347978991101714338592430633671452975982042108321619"},
         false},
    };
    return all;
}

/// Returns the numbers, then one in the middle or the same twice, then the numbers in reverse. All
/// have the sum 1, exactly.
NumberVector palindrome(const std::vector<std::string_view>& first, bool has_middle) {
    NumberVector all;
    Number sum(0);
    for (const std::string_view text : first) {
        all.push_back(decimal_number(text));
        sum = sum + all.back();
    }
    const NumberVector mirror(all.rbegin(), all.rend());
    const Number rest = Number(1) - sum - sum;
    if (has_middle) {
        all.push_back(rest);
    } else {
        all.insert(all.end(), 2, rest / Number(2));
    }
    all.insert(all.end(), mirror.begin(), mirror.end());
    return all;
}

/// Returns the flows of B at the nodes of Gauss' rule, with its weights (Laskar & Robutel, Celest.
/// Mech. Dyn. Astron. 80 (2001) 39; McLachlan, BIT 35 (1995) 258).
Splitting at_gauss_nodes(const Ground& ground, const std::string& stages) {
    const auto name = std::make_shared<const Source>(Source{"method", "gauss:" + stages});
    const Tableau gauss = derive_on(ground, named_method(name)).tableau;
    Splitting result{{}, gauss.b};
    Number at(0);
    for (const Number& node : gauss.c) {
        result.a.push_back(node - at);
        at = node;
    }
    result.a.push_back(Number(1) - at);
    return result;
}

}  // namespace

Splitting splitting(const Ground& ground, const std::string& name) {
    if (name == "strang") { return at_gauss_nodes(ground, "1"); }
    if (name == "mclachlan:8.2") { return at_gauss_nodes(ground, "4"); }
    constexpr std::string_view saba = "saba:";
    if (name.starts_with(saba)) { return at_gauss_nodes(ground, name.substr(saba.size())); }
    for (const Entry& entry : entries()) {
        if (entry.name != name) { continue; }
        return {palindrome(entry.a, !entry.has_middle), palindrome(entry.b, entry.has_middle),
                digits_of_entries};
    }
    HVI_CHECK(false && "the catalogue has no other splitting");
    return {};
}

NumberVector substeps(const Splitting& splitting) {
    NumberVector steps;
    Number last(0);
    for (std::size_t k = 0; k < splitting.b.size(); ++k) {
        steps.push_back(splitting.a[k] - last);
        last = splitting.b[k] - steps.back();
        steps.push_back(last);
    }
    return steps;
}

Tableau splitting_tableau(const Ground& ground, const Method& method) {
    // NOTE: one stage at the end of the step is a drift, and a kick after it.
    const WeightedStages map{{{Number(1)}}, {Number(1)}};
    const Splitting flows = splitting(ground, method.splitting);
    const Composition composition{.name = method.splitting,
                                  .order = 1,
                                  .with_adjoint = true,
                                  .steps = substeps(flows),
                                  .place = {}};
    const PartitionedMethod stages = partitioned_method(composed(map, composition));
    Tableau result;
    result.provenance = {.name = method.name, .origin = method.origin, .basis = {}};
    result.digits = flows.digits;
    result.b = stages.b;
    result.A = stages.A;
    result.A_tilde = stages.A_tilde;
    const auto row_sums = [](const NumberMatrix& rows) {
        NumberVector sums;
        for (const NumberVector& row : rows) {
            Number sum(0);
            for (const Number& entry : row) { sum = sum + entry; }
            sums.push_back(sum);
        }
        return sums;
    };
    result.c = row_sums(result.A);
    result.c_tilde = row_sums(result.A_tilde);
    return result;
}

}  // namespace hvi::gen
