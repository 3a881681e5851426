// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/emit/system/loop_code.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <set>
#include <utility>

#include "generator/emit/system/class_values.hpp"
#include "generator/emit/system/element_conditions.hpp"
#include "generator/emit/system/loop_files.hpp"
#include "generator/emit/system/loop_names.hpp"
#include "generator/emit/system/loop_writer.hpp"
#include "generator/emit/system/pair_products.hpp"
#include "generator/emit/system/scene_code.hpp"
#include "generator/emit/system/site_writer.hpp"
#include "generator/emit/text/names.hpp"
#include "generator/emit/text/text.hpp"

namespace hvi::gen {

namespace {

std::vector<const SystemFamily*> all_families(const System& system) {
    std::vector<const SystemFamily*> families;
    for (const auto* each : {&system.coordinates, &system.conjugates}) {
        for (const SystemFamily& family : *each) { families.push_back(&family); }
    }
    for (const SystemTable& table : system.tables) { families.push_back(&table.family); }
    return families;
}

// ---- the functions of the class ----

/// dH/dq, or dH/dp, sum by sum.
std::vector<SumDerivatives> derivatives(const System& system, const LoopWriter& loops, bool by_q) {
    std::vector<SumDerivatives> result;
    for (std::size_t s = 0; s < system.sums.size(); ++s) {
        const SystemSum& sum = system.sums[s];
        const std::vector<AccessSlope>& slopes = by_q ? sum.by_q : sum.by_conjugates;
        if (slopes.empty()) { continue; }
        result.push_back({fmt::format("add_by_{}_{}", by_q ? "q" : "p", s + 1), &sum, &slopes, "p",
                          system.time && (by_q || !system.structure.is_separable),
                          loops.needs_totals(values(slopes))});
    }
    return result;
}

/// d2H/dq2 times a vector, sum by sum. Precondition: no sum has q and p.
std::vector<SumDerivatives> products_of_positions(const System& system) {
    std::vector<SumDerivatives> result;
    for (const SystemSum& sum : std::get<HessianOfSums>(system.second).products) {
        if (sum.by_q.empty()) { continue; }
        result.push_back({fmt::format("add_product_{}", result.size() + 1), &sum, &sum.by_q, "way",
                          system.time.has_value()});
    }
    return result;
}

/// Whether Newton's method may be called for.
bool takes_second(const Step& step) {
    return step.iteration() != nullptr && step.iteration()->takes_newton();
}

/// Whether Newton's method for positions goes by products.
bool takes_products(const Step& step) {
    const auto* velocities = std::get_if<VelocityStep>(&step.form);
    return velocities != nullptr && velocities->hessian == HessianForm::products;
}

/// Whether a step adds up products with second derivatives that are not zero.
bool adds_products(const System& system, const Step& step) {
    const bool are_pairs = std::holds_alternative<PairStep>(step.form);
    if (!takes_second(step) || !(are_pairs || takes_products(step))) { return false; }
    const std::vector<SystemSum>& products = std::get<HessianOfSums>(system.second).products;
    return std::any_of(products.begin(), products.end(),
                       [&](const SystemSum& sum) { return are_pairs || !sum.by_q.empty(); });
}

class SystemClass {
public:
    SystemClass(const System& system, const SceneWishes& wishes, const Step& step)
        : step_(step),
          system_(system),
          wishes_(wishes),
          // NOTE: sweeps over sites know how many they take.
          counts_(wishes.evaluations && step.layout != Layout::sites),
          names_(system_),
          loops_(system_, names_) {}

    [[nodiscard]] std::string text() {
        // NOTE: the constructor comes last, as it computes what the others need.
        Writer functions(2);
        loops_.write_totals(functions);
        write_gradients(functions);
        write_for_positions(functions);
        write_for_pairs(functions);
        write_for_charts(functions);
        write_values(functions);
        write_begin(functions);
        Writer writer(1);
        const std::string written = to_text(system_.expression);
        writer.comment(system_.is_transformed ? "H = p v - L, where L = " + written
                                              : "H = " + written,
                       "/// ");
        writer.open("struct System {{");
        writer.line("using Scalar = Number;").line("using Vector = std::vector<Number>;");
        if (system_.sites) { write_site_types(writer, *system_.sites); }
        writer.blank();
        write_constructor(writer);
        writer.blank().insert(functions.str());
        writer.blank();
        write_data(writer);
        return writer.close("};").str();
    }

private:
    void write_gradients(Writer& writer) {
        writer.line("/// Degrees of freedom.");
        writer.line("[[nodiscard]] std::size_t size() const {{ return {}; }}", conjugate_count());
        writer.blank();
        writer.comment("Whether vectors have the size of the system, and all that sums look at is "
                       "there: lists may be too short.",
                       "/// ");
        writer.open("[[nodiscard]] bool fits(const Vector& q, const Vector& p) const {{");
        writer.line("return fits_ && q.size() == size_ && p.size() == {};", conjugate_count());
        writer.close().blank();
        if (system_.sites) {
            SiteWriter(*system_.sites, loops_).write(writer);
            write_gathered(writer);
            return;
        }
        write_scattered(writer, true);
        writer.blank();
        write_scattered(writer, false);
    }

    void write_gathered(Writer& writer) const {
        writer.blank().open("void dHdq(const Vector& q, Vector& out) const {{");
        count_evaluation(writer);
        writer.line("hvi::detail::gather(*this, q.data(), out.data());").close();
        writer.blank().open("void dHdp(const Vector& p, Vector& out) const {{");
        writer.line("hvi::detail::velocities(*this, p.data(), out.data());").close();
    }

    void count_evaluation(Writer& writer) const {
        if (counts_) { writer.line("++evaluations;"); }
    }

    void write_scattered(Writer& writer, bool by_q) {
        const std::vector<SumDerivatives> all = derivatives(system_, loops_, by_q);
        for (const SumDerivatives& each : all) {
            loops_.write_derivatives(writer, each);
            writer.blank();
        }
        const bool is_separable = system_.structure.is_separable;
        const std::string letter = by_q ? "q" : "p";
        const std::string_view time = is_separable && !by_q ? "" : time_argument();
        writer.open("void dHd{}({}{}, Vector& out) const {{", letter,
                    is_separable
                        ? fmt::format("[[maybe_unused]] const Vector& {}", letter)
                        : "[[maybe_unused]] const Vector& q, [[maybe_unused]] const Vector& p",
                    time);
        if (by_q) { count_evaluation(writer); }
        writer.line("std::fill(out.begin(), out.end(), Scalar(0));");
        const std::string q = is_separable && !by_q ? "nullptr" : "q.data()";
        const std::string p = is_separable && by_q ? "nullptr" : "p.data()";
        std::vector<Scaled> slopes;
        for (const SumDerivatives& each : all) {
            for (const Scaled& slope : values(*each.slopes)) { slopes.push_back(slope); }
        }
        loops_.sum_totals(writer, slopes, q, p);
        for (const SumDerivatives& each : all) { loops_.call_derivatives(writer, each, q, p); }
        writer.close();
    }

    /// What steps ask for that solve for positions alone.
    void write_for_positions(Writer& writer) {
        if (!std::holds_alternative<VelocityStep>(step_.form)) { return; }
        writer.blank().line("{}", mass_text(std::get<VelocityStep>(step_.form))).blank();
        writer.comment("d2H/dp2 v, which is constant.", "/// ");
        writer.line("void inverse_mass(const Vector& v, Vector& out) const {{ dHdp(v, out); }}");
        write_kick_of_stage(writer);
        if (!takes_second(step_)) { return; }
        if (takes_products(step_)) {
            write_products(writer);
        } else {
            write_entries(writer);
        }
    }

    void write_for_pairs(Writer& writer) {
        if (!std::holds_alternative<PairStep>(step_.form) || !takes_second(step_)) { return; }
        write_pair_products(writer, loops_);
    }

    [[nodiscard]] bool has_bodies() const { return rotations_of(system_) > 0; }

    /// How many momenta there are; of rotations less than positions.
    [[nodiscard]] std::string_view conjugate_count() const {
        return has_bodies() ? "degrees_" : "size_";
    }

    /// Both gradients of a stage, by turns of bodies in the place of entries of rotations.
    void write_for_charts(Writer& writer) const {
        if (!has_bodies()) { return; }
        const std::string_view t = system_.time ? ", t" : "";
        writer.blank().open("void gradient(const Vector& q, const Vector& p{}, Vector& by_q, "
                            "Vector& by_p) const {{",
                            system_.time ? ", Scalar t" : "");
        writer.line("by_entries_.resize(size_);");
        writer.line("dHdq(q, p{}, by_entries_);", t);
        writer.line("hvi::detail::by_turns(q, by_entries_, by_q);");
        writer.line("dHdp(q, p{}, by_p);", t).close();
    }

    /// Another argument, where H depends on the time.
    [[nodiscard]] std::string_view time_argument() const {
        return system_.time ? ", [[maybe_unused]] Scalar t" : "";
    }

    void write_kick_of_stage(Writer& writer) const {
        writer.blank().comment("Lp_j = -h b_j dH/dq(Q_j) and W_j = h d2H/dp2 Lp_j.", "/// ");
        writer.line("template <class Stages>");
        writer.open("void kick_stage(Stages& s, std::size_t j{}) const {{", time_argument());
        if (system_.sites) {
            count_evaluation(writer);
            writer.line("hvi::detail::kick_stage(*this, s, j);");
        } else {
            writer.line("dHdq(s.Q[j]{}, s.Lp[j]);", system_.time ? ", t" : "");
            writer.line("hvi::detail::scale(s.Lp[j], -s.hb[j]);");
            writer.line("s.drift(*this, j);");
        }
        writer.close();
    }

    void write_entries(Writer& writer) {
        writer.blank().comment("Adds the entries i, j of d2H/dq2 by out.add(i, j, value).", "/// ");
        writer.line("template <class Matrix>");
        writer.open("void d2Hdq2([[maybe_unused]] const Vector& q_of{}, [[maybe_unused]] Matrix& "
                    "out) const {{",
                    time_argument());
        writer.line("[[maybe_unused]] const Scalar* const q = q_of.data();");
        for (const SumEntries& entries : std::get<HessianOfSums>(system_.second).entries) {
            loops_.write_entries(writer, entries);
        }
        writer.close();
    }

    void write_products(Writer& writer) {
        const std::vector<SumDerivatives> all = products_of_positions(system_);
        for (const SumDerivatives& each : all) {
            writer.blank();
            loops_.write_derivatives(writer, each);
        }
        writer.blank().line("/// out = d2H/dq2 way.");
        writer.open("void d2Hdq2([[maybe_unused]] const Vector& q, [[maybe_unused]] const Vector& "
                    "way{}, Vector& out) const {{",
                    time_argument());
        writer.line("std::fill(out.begin(), out.end(), Scalar(0));");
        for (const SumDerivatives& each : all) {
            loops_.call_derivatives(writer, each, "q.data()", "way.data()");
        }
        writer.close();
    }

    void write_value(Writer& writer, const std::string& name, const std::vector<SystemSum>& sums,
                     std::string_view time) {
        writer.blank().open("[[nodiscard]] Scalar {}([[maybe_unused]] const Vector& q_of, "
                            "[[maybe_unused]] const Vector& p_of{}) const {{",
                            name, time);
        writer.line(
            "if (!fits(q_of, p_of)) {{ return std::numeric_limits<Scalar>::quiet_NaN(); }}");
        writer.line("[[maybe_unused]] const Scalar* const q = q_of.data();");
        writer.line("[[maybe_unused]] const Scalar* const p = p_of.data();");
        std::vector<Scaled> values;
        for (const SystemSum& sum : sums) { values.push_back(sum.value); }
        loops_.sum_totals(writer, values, "q", "p");
        writer.line("hvi::detail::CompensatedTotal<Scalar> total;");
        for (const SystemSum& sum : sums) { loops_.write_total(writer, sum); }
        writer.line("return total.sum();").close();
    }

    void write_values(Writer& writer) {
        for (const ClassValue& value : values_of_class(system_, wishes_)) {
            write_value(writer, value.name, *value.sums, value.has_time ? time_argument() : "");
        }
    }

    void write_begin(Writer& writer) {
        writer.blank().line("/// Where the scene begins; empty where lists do not fit.");
        writer.open("void begin({}Vector& q_of, Vector& p_of) const {{",
                    begins_in_file(system_) ? "const Parameters& parameters, " : "");
        writer.line("q_of.clear();").line("p_of.clear();");
        for (const std::string& condition : conditions_of_starts(system_, names_)) {
            writer.line("if (!({})) {{ return; }}", condition);
        }
        write_conditions_of_files(writer, system_, names_);
        for (const char letter : {'q', 'p'}) {
            writer.line("{}_of.assign({}, Scalar(0));", letter,
                        letter == 'q' ? "size_" : conjugate_count());
            writer.line("[[maybe_unused]] Scalar* const {0} = {0}_of.data();", letter);
        }
        const std::size_t count = system_.coordinates.size();
        for (std::size_t k = 0; k < system_.initial.size(); ++k) {
            const bool is_q = k < count;
            loops_.write_start(writer,
                               is_q ? system_.coordinates[k] : system_.conjugates[k - count],
                               is_q ? "q" : "p", system_.initial[k]);
        }
        writer.close();
    }

    // ---- the constructor, and the data ----

    void write_places(Writer& writer, const SystemFamily& family, std::string_view total) {
        const std::string name = member_of(family.name);
        const std::size_t d = family.ranges.size();
        std::string first;
        for (std::size_t i = d; i-- > 0;) {
            if (i + 1 < d) {
                writer.line("{}_step_{}_ = {}{};", name, i + 1, names_.count(family.ranges[i + 1]),
                            i + 2 < d ? fmt::format(" * {}_step_{}_", name, i + 2) : "");
            }
            first += fmt::format(" - ({}){}", names_.whole(family.ranges[i].first),
                                 i + 1 < d ? fmt::format(" * {}_step_{}_", name, i + 1) : "");
        }
        writer.line("{}_at_ = {}{};", name, total.empty() ? "0" : total, first);
        if (total.empty()) { return; }
        std::string count = d == 0 ? "1" : names_.count(family.ranges[0]);
        if (d > 1) { count += fmt::format(" * {}_step_1_", name); }
        writer.line("{} += {};", total, count);
    }

    /// NOTE: for other sizes than those of the scene.
    void write_fits(Writer& writer) const {
        for (const SystemTable& table : system_.tables) {
            if (table.family.ranges.size() == 1) { continue; }
            long count = 1;
            for (const LoopRange& range : table.family.ranges) { count *= range.last.constant; }
            writer.line("fits_ = fits_ && {}_values_.size() == {};", member_of(table.family.name),
                        count);
        }
        for (const std::string& condition : conditions_of_sums(system_, names_)) {
            writer.line("fits_ = fits_ && {};", condition);
        }
    }

    void write_constructor(Writer& writer) {
        Writer body(2);
        body.line("Place in_q = 0, in_p = 0;");
        for (const SystemFamily& family : system_.coordinates) {
            write_places(body, family, "in_q");
        }
        for (const SystemFamily& family : system_.conjugates) {
            write_places(body, family, "in_p");
        }
        for (const SystemTable& table : system_.tables) { write_places(body, table.family, ""); }
        body.line("size_ = static_cast<std::size_t>(in_q);");
        if (has_bodies()) { body.line("degrees_ = static_cast<std::size_t>(in_p);"); }
        if (system_.sites) { body.line("count_ = in_q / {};", system_.coordinates.size()); }
        write_fits(body);
        names_.write_setup(body, "hvi::math");
        writer.line("explicit System({}const Parameters& parameters{})",
                    uses_parameters() ? "" : "[[maybe_unused]] ",
                    has_chunks() ? ", unsigned threads = 1" : ", unsigned /*threads*/ = 1");
        std::vector<std::string> members;
        for (const SystemSize& size : system_.sizes) {
            members.push_back(fmt::format("{0}_(parameters.{0})", member_of(size.name)));
        }
        for (const SystemTable& table : system_.tables) {
            members.push_back(
                fmt::format("{0}_values_(parameters.{0})", member_of(table.family.name)));
        }
        if (has_chunks()) { members.emplace_back("team_(threads)"); }
        if (members.empty()) {
            writer.open("{{");
        } else {
            writer.open("    : {} {{", fmt::join(members, ", "));
        }
        writer.insert(body.str()).close();
    }

    [[nodiscard]] bool uses_parameters() const {
        return !system_.sizes.empty() || !system_.tables.empty() || !names_.members().empty();
    }

    /// Whether sums over pairs are cut into chunks.
    [[nodiscard]] bool has_chunks() const {
        return scatters(system_, step_) &&
               std::any_of(system_.sums.begin(), system_.sums.end(),
                           [](const SystemSum& sum) { return sum.loops.size() > 1; });
    }

    void write_data(Writer& writer) const {
        names_.write_data(writer);
        for (const SystemSize& size : system_.sizes) {
            writer.line("Place {}_;", member_of(size.name));
        }
        for (const SystemTable& table : system_.tables) {
            writer.line("Vector {}_values_;", member_of(table.family.name));
        }
        for (const SystemFamily* family : all_families(system_)) {
            const std::string name = member_of(family->name);
            std::string line = fmt::format("Place {}_at_ = 0", name);
            for (std::size_t d = 1; d < family->ranges.size(); ++d) {
                line += fmt::format(", {}_step_{}_ = 0", name, d);
            }
            writer.line("{};", line);
        }
        writer.line("std::size_t size_ = 0;").line("bool fits_ = true;");
        if (has_bodies()) {
            writer.line("std::size_t degrees_ = 0;  // of freedom");
            writer.line(
                "mutable Vector by_entries_{{}};  // dH/dq, and by the entries of rotations");
        }
        if (system_.sites) { writer.line("Place count_ = 0;  // of sites"); }
        if (has_chunks()) {
            writer.line("mutable hvi::detail::Team team_;");
            writer.line("mutable Vector memory_{{}};  // of chunks");
        }
        if (counts_) { writer.line("mutable std::int64_t evaluations = 0;  // of dH/dq"); }
    }

    const Step& step_;
    const System& system_;
    const SceneWishes& wishes_;
    bool counts_;
    LoopNames names_;
    LoopWriter loops_;
};

}  // namespace

bool scatters(const System& system, const Step& step) {
    return !system.sites || adds_products(system, step);
}

std::string loop_system_text(const System& system, const SceneWishes& wishes, const Step& step) {
    return SystemClass(system, wishes, step).text();
}

}  // namespace hvi::gen
