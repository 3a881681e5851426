// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/exact/methods/composition.hpp"

#include <algorithm>

#include "generator/exact/methods/galerkin_form.hpp"
#include "generator/exact/methods/properties.hpp"
#include "generator/exact/numbers/decimal_number.hpp"
#include "generator/read/nearest.hpp"

namespace hvi::gen {

namespace {

/// Limit of the stages in a step. NOTE: the time to plan them grows like their cube, the header
/// like their square: 136 stages take a second and a megabyte and a half.
constexpr std::size_t most_stages = 150;

struct Entry {
    std::string_view name;
    int order;
    bool with_adjoint;
    bool has_middle;  ///< whether the number of steps is odd
    /// Half of the steps, without the one in the middle. For an even number of steps it is without
    /// the last one before the mirror.
    std::vector<std::string_view> first;
};

// NOTE: the digits of all but the first two are computed anew from those that the authors print, by
// Newton's method on the order conditions in 90 digits, with the smallest change where there are
// more steps than conditions.
const std::vector<Entry>& entries() {
    static const std::vector<Entry> all{
        // 1/(2 - 2^(1/3)); Yoshida, Phys. Lett. A 150 (1990) 262.
        {"yoshida:4", 4, false, true, {"1.351207191959657634047687808971460826921999376217144828"}},
        // Yoshida's solution A.
        {"yoshida:6",
         6,
         false,
         true,
         {"0.7845136104775572638194976338663498757768244174514933846",
          "0.235573213359358133684793182978534601686468082103401119",
          "-1.177679984178871006946415680964315734639269252634598484"}},
        // Yoshida's solution D.
        {"yoshida:8",
         8,
         false,
         true,
         {"0.9148442462297915667487934898475096045181197087288583718",
          "0.2536933365662113541461460206899420760976531647324740966",
          "-1.444852236860605157694730657537390354955910101795505602",
          "-0.1582406353680501752040667767597542477554451156757515681",
          "1.938139137622525986579186487443641760953593357447650272",
          "-1.960610232975310807607633376399663640792432819826005302",
          "0.1027998493917964406981151316012258629110156012784427683"}},
        // 1/(4 - 4^(1/3)); Suzuki, Phys. Lett. A 146 (1990) 319.
        {"suzuki:4",
         4,
         false,
         true,
         {"0.4144907717943757371423540628607614957117746040167071333",
          "0.4144907717943757371423540628607614957117746040167071333"}},
        // The splitting S of 10 stages in Blanes & Moan, J. Comput. Appl. Math. 142 (2002) 313:
        // with a_1 A, b_1 B, a_2 A, ... it is gamma_1 = a_1, gamma_2k = b_k - gamma_2k-1 and
        // gamma_2k+1 = a_k+1 - gamma_2k.
        {"blanes-moan:6",
         6,
         true,
         false,
         {"0.05026276440039268602122165440207410940601274883258751261",
          "0.09855368350065054589967935113350347947138397043266929751",
          "0.3149606169276932691633843690003809595038854460161191593",
          "-0.4473464826954769166122297955993208810783747554402495226",
          "0.4924263724898749795811268477238343522400927776296235506",
          "-0.4251187677976905214308689511312333053407296334302774037",
          "0.2370639139781216066317404622123627628529107614191697048",
          "0.1956024886000519908959275086711825352052731799951342841",
          "0.3463581898507281439354872322618899611428995833406556917"}},
        // 17 stages; Kahan & Li, Math. Comp. 66 (1997) 1089.
        {"kahan-li:8",
         8,
         false,
         true,
         {"0.1302024830888900808788176322625491050228175109268241597",
          "0.5611629817751083845619644077015862653065976542301898873",
          "-0.3894749626448472864080785986459409654425157508081138709",
          "0.1588419065551556008962107456303837638053848226690945023",
          "-0.3959038941332375773362315390221907325846695691339426789",
          "0.1845396409783157070918325413885665927720919530026747449",
          "0.2583743876863220472939791098604313371638620755805837532",
          "0.2950117236093102988709662404919739277377529523693284571"}}};
    return all;
}

/// Returns all steps. Those that are not written down make the sum 1, exactly.
NumberVector steps(const Entry& entry) {
    NumberVector half;
    Number sum(0);
    for (const std::string_view text : entry.first) {
        half.push_back(decimal_number(text));
        sum = sum + half.back();
    }
    NumberVector all = half;
    if (entry.has_middle) {
        all.push_back(Number(1) - sum - sum);
    } else {
        half.push_back(Number(1) / Number(2) - sum);
        all.push_back(half.back());
    }
    all.insert(all.end(), half.rbegin(), half.rend());
    return all;
}

void check_stages(const Composition& composition, const Tableau& tableau) {
    const std::size_t most = most_stages / composition.steps.size();
    if (tableau.stages() <= most) { return; }
    throw InputError(std::to_string(composition.steps.size()) + " steps of " +
                         std::to_string(tableau.stages()) + " stages are not built as one",
                     composition.place,
                     "compose a method of at most " + std::to_string(most) + " stages");
}

/// NOTE: the steps of a rule are taken one after the other, and not planned as one.
void check_stages(const Composition&, const GalerkinRule&) {}

void check_adjoint(const Composition& composition, const Tableau& tableau) {
    if (composition.with_adjoint || is_symmetric(tableau).holds) { return; }
    throw MathError(composition.name + " makes order " + std::to_string(composition.order) +
                        " of symmetric methods, and this one is not its own adjoint",
                    composition.place,
                    "stormer-verlet is, or midpoint; blanes-moan:6 takes any method");
}

void check_adjoint(const Composition& composition, const GalerkinRule& rule) {
    if (composition.with_adjoint || is_symmetric(galerkin_form(rule)).holds) { return; }
    throw MathError(composition.name + " makes order " + std::to_string(composition.order) +
                        " of symmetric methods, and this one is not its own adjoint",
                    composition.place,
                    "take nodes that are symmetric about 1/2; blanes-moan:6 takes any method");
}

}  // namespace

std::vector<std::string_view> composition_names() {
    std::vector<std::string_view> names;
    for (const Entry& entry : entries()) { names.push_back(entry.name); }
    return names;
}

std::string composed_name(const std::string& method,
                          const std::optional<Composition>& composition) {
    if (!composition) { return method; }
    return method.empty() ? composition->name : method + "-" + composition->name;
}

void check_composition(const Composition& composition, const DerivedMethod& method) {
    std::visit(
        [&](const auto& base) {
            if (!base.parameters.empty()) {
                throw InputError("compositions of methods with a free parameter are not built",
                                 composition.place,
                                 "give it a value: --param " + base.parameters.front() + "=1");
            }
            check_stages(composition, base);
            check_adjoint(composition, base);
        },
        method);
}

Composition named_composition(const std::shared_ptr<const Source>& name) {
    for (const Entry& entry : entries()) {
        if (entry.name == name->text) {
            return {name->text, entry.order, entry.with_adjoint, steps(entry), whole(name)};
        }
    }
    throw InputError("there is no composition `" + name->text + "`", whole(name),
                     did_you_mean(name->text, composition_names(),
                                  "yoshida:4, yoshida:6, yoshida:8, suzuki:4, blanes-moan:6 or "
                                  "kahan-li:8"));
}

}  // namespace hvi::gen
