// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/emit/system/class_functions.hpp"

#include <utility>

#include "generator/emit/system/class_values.hpp"
#include "generator/emit/system/function_list.hpp"
#include "generator/emit/system/loop_files.hpp"
#include "generator/emit/system/loop_writer.hpp"

namespace hvi::gen {

namespace {

/// Whether Newton's method may be called for.
bool takes_second(const Step& step) {
    return step.iteration() != nullptr && step.iteration()->takes_newton();
}

std::vector<std::string> followed_by(std::vector<std::string> first,
                                     const std::vector<std::string>& second) {
    first.insert(first.end(), second.begin(), second.end());
    return first;
}

/// Names of nodes as components of a vector.
NodeNames named(const std::vector<Node>& nodes, std::string_view letter) {
    const std::vector<std::string> all = components(letter, nodes.size());
    NodeNames names;
    for (std::size_t k = 0; k < nodes.size(); ++k) { names[nodes[k]] = all[k]; }
    return names;
}

class ClassFunctions {
public:
    ClassFunctions(const System& system, const SceneWishes& wishes, const Step& step,
                   const Evaluations* evaluations)
        : system_(system),
          wishes_(wishes),
          step_(step),
          evaluations_(evaluations),
          counts_(counts_evaluations(wishes, step)),
          has_time_(system.time.has_value()),
          of_q_{true, !step.is_separable(), step.depends_on_time()},
          of_p_{!step.is_separable(), true, step.depends_on_time() && !step.is_separable()},
          list_(system, step) {}

    [[nodiscard]] std::vector<SystemFunction> all() && {
        if (evaluations_ == nullptr) { add_sizes(); }
        if (std::holds_alternative<TabulatedStep>(step_.form)) {
            add_quadratic();
        } else if (!std::holds_alternative<FlowStep>(step_.form)) {
            add_gradients();
            add_inverse_mass();
            add_kick_of_stage();
            add_shared();
            add_constant_terms();
            add_second();
            add_tangents();
            add_directions();
        }
        for (const ClassValue& value : values_of_class(system_, wishes_)) { add_value(value); }
        if (evaluations_ == nullptr) {
            add_begin_of_families();
        } else if (!system_.initial.empty()) {
            add_begin();
        }
        return std::move(list_).all();
    }

private:
    void add_value(const ClassValue& value) {
        const Takes takes{true, true, value.has_time};
        if (evaluations_ == nullptr) {
            list_.add(value.name, takes, ValueOfSums{value.sums}).returns = "Scalar";
            return;
        }
        StraightCode code{kernel(system_.graph, {value.sums->front().value})};
        if (step_.layout == Layout::trajectories) {
            list_.add_of_lanes(value.name, takes, std::move(code), {}).returns = "Value";
        } else {
            list_.add(value.name, takes, std::move(code)).returns = "Scalar";
        }
    }

    // ---- sizes, of sums with loops ----

    void add_sizes() {
        for (std::size_t k = 0; k < system_.totals.size(); ++k) { add_total(k); }
        const std::string_view conjugates = rotations_of(system_) > 0 ? "degrees_" : "size_";
        list_
            .add("size", no_variables, OneLine{fmt::format("return {};", conjugates)}, {},
                 "Degrees of freedom.")
            .returns = "std::size_t";
        const std::string fits =
            fmt::format("return fits_ && q.size() == size_ && p.size() == {};", conjugates);
        list_
            .add("fits", {}, Statements{{fits}}, {},
                 "Whether vectors have the size of the system, and all that sums look at is "
                 "there: lists may be too short.")
            .returns = "bool";
        if (system_.sites) { add_sites(*system_.sites); }
    }

    void add_total(std::size_t k) {
        const SystemTotal& total = system_.totals[k];
        std::vector<Argument> arguments = {{"const Scalar* q", false}, {"const Scalar* p", false}};
        if (has_time(system_, k)) { arguments.push_back({"Scalar t", false}); }
        arguments.push_back({"const Scalar* totals", false});
        list_
            .add(fmt::format("total_{}", k + 1), no_variables, TotalOfSums{&total.sums},
                 std::move(arguments), system_.graph.at(total.node).name)
            .returns = "Scalar";
    }

    void add_sites(const Sites& sites) {
        const Argument q{"const Scalar* q", false}, p{"const V (&p)[components]", false};
        const Argument place{"Place e", false}, site{"const Site& k", false};
        const Argument out{"V (&out)[components]"};
        const auto add_inlined = [&](std::string name, const std::vector<Scaled>& values,
                                     const Argument& array, std::string doc) {
            SystemFunction& function =
                list_.add(std::move(name), no_variables, ValuesOfSites{&values},
                          {array, place, site, out}, std::move(doc));
            function.parameters = "class V";
            function.is_inlined = true;
        };
        list_.add("sites", no_variables, SiteRanges{}).returns = "hvi::detail::Sites<dimension>";
        add_inlined("force", sites.forces, q,
                    "dU/dq of the sites e, e + 1, ... that V stands for, where all their "
                    "neighbours are; the first has the indices k.");
        list_.add("force_at_edge", no_variables, ForceAtEdge{},
                  {q, {"Place"}, site, {"Scalar (&out)[components]"}}, "Force on any site.");
        add_inlined("velocity", sites.velocities, p, "dT/dp of sites with the momenta p.");
    }

    // ---- first derivatives ----

    void add_gradients() {
        if (evaluations_ != nullptr && step_.slopes == Slopes::joint) {
            add_joint(evaluations_->gradients.joint);
        } else {
            add_gradient(true).is_counted = counts_;
            add_gradient(false);
        }
        if (system_.side == Side::lagrangian) {
            list_.add_slope("dLdv", of_p_, evaluations_->gradients.by_conjugates);
        }
        if (evaluations_ == nullptr && rotations_of(system_) > 0) { add_gradient_by_turns(); }
    }

    /// dH/dq or dH/dp.
    SystemFunction& add_gradient(bool by_q) {
        const std::string letter = by_q ? "q" : "p";
        const std::string name = "dHd" + letter;
        const Takes& takes = by_q ? of_q_ : of_p_;
        if (evaluations_ != nullptr) {
            const GradientKernels& gradients = evaluations_->gradients;
            return list_.add_slope(name, takes, by_q ? gradients.by_q : gradients.by_conjugates);
        }
        if (system_.sites) {
            const std::string sweep = fmt::format("hvi::detail::{}(*this, {}.data(), out.data());",
                                                  by_q ? "gather" : "velocities", letter);
            return list_.add(name, takes, Statements{{sweep}}, {{"Vector& out"}});
        }
        const Scatter::Arrays arrays = {{"q", takes.q}, {"p", takes.p}};
        return list_.add_scattered({name, "add_by_" + letter, by_q, arrays, takes.time},
                                   system_.sums, Numbers::of_all);
    }

    /// dH/dq and dH/dp at once.
    void add_joint(const Kernel& kernel) {
        const std::size_t n = system_.degrees_of_freedom();
        const std::string by_q = fmt::format("d{}dq", system_.function_letter());
        const std::string by_p =
            fmt::format("d{}d{}", system_.function_letter(), system_.conjugate_letter());
        StraightCode code{kernel, followed_by(components(by_q, n), components(by_p, n))};
        list_
            .add_of_lanes("gradient", of_q_, std::move(code),
                          {{list_.reference(by_q)}, {list_.reference(by_p)}})
            .is_counted = counts_;
    }

    /// Both gradients by turns of bodies in the place of entries of rotations.
    void add_gradient_by_turns() {
        const std::string_view t = has_time_ ? ", t" : "";
        list_.add(
            "gradient", {true, true, has_time_},
            Statements{{"by_entries_.resize(size_);", fmt::format("dHdq(q, p{}, by_entries_);", t),
                        "hvi::detail::by_turns(q, by_entries_, by_q);",
                        fmt::format("dHdp(q, p{}, by_p);", t)}},
            {{"Vector& by_q"}, {"Vector& by_p"}});
    }

    /// dH/dq that keeps what dH/dp at the same q takes of it, and that dH/dp.
    void add_shared() {
        if (evaluations_ == nullptr || !evaluations_->shared) { return; }
        const GradientKernels& gradients = evaluations_->gradients;
        const std::vector<std::string> out = components("out", system_.degrees_of_freedom());
        const std::vector<std::string> kept = components("at", gradients.shared.size());
        const Takes takes{true, true, step_.depends_on_time()};
        StraightCode by_q{*evaluations_->shared, followed_by(out, kept)};
        StraightCode by_p{gradients.by_conjugates_at_q, out, named(gradients.shared, "at")};
        SystemFunction& force =
            list_.add_of_lanes("dHdq", takes, std::move(by_q), {{"Values& out"}, {"Values& at"}});
        force.is_counted = counts_;
        force.is_inlined = false;
        list_.add_of_lanes("dHdp", takes, std::move(by_p), {{"const Values& at"}, {"Values& out"}})
            .is_inlined = false;
    }

    /// A stage at once, where sums stay loops.
    void add_kick_of_stage() {
        if (evaluations_ != nullptr || !std::holds_alternative<VelocityStep>(step_.form)) {
            return;
        }
        std::vector<Argument> arguments = {{"Stages& s"}, {"std::size_t j"}};
        if (has_time_) { arguments.push_back({"Scalar t", false}); }
        const std::string force = fmt::format("dHdq(s.Q[j]{}, s.Lp[j]);", has_time_ ? ", t" : "");
        Statements kick{{force, "hvi::detail::scale(s.Lp[j], -s.hb[j]);", "s.drift(*this, j);"}};
        if (system_.sites) { kick.lines = {"hvi::detail::kick_stage(*this, s, j);"}; }
        SystemFunction& function =
            list_.add("kick_stage", no_variables, std::move(kick), std::move(arguments),
                      "Lp_j = -h b_j dH/dq(Q_j) and W_j = h d2H/dp2 Lp_j.");
        function.parameters = "class Stages";
        function.is_counted = counts_ && system_.sites;
    }

    // ---- second derivatives ----

    void add_inverse_mass() {
        if (evaluations_ != nullptr) {
            if (!evaluations_->inverse_mass) { return; }
            const Kernel& kernel = *evaluations_->inverse_mass;
            if (step_.has_lanes() || step_.carries == Carries::nothing) {
                list_.add_slope("inverse_mass", {false, true}, kernel);
            } else {
                add_of_any("inverse_mass", {false, true},
                           {kernel, components("out", system_.degrees_of_freedom())},
                           {{"Values& out"}});
            }
        } else if (std::holds_alternative<VelocityStep>(step_.form)) {
            list_.add("inverse_mass", no_variables, OneLine{"dHdp(v, out);"},
                      {{"const Vector& v"}, {"Vector& out"}}, "d2H/dp2 v, which is constant.");
        }
    }

    void add_constant_terms() {
        if (evaluations_ == nullptr) { return; }
        if (evaluations_->stiffness) {
            const std::size_t count = evaluations_->stiffness->results.size();
            list_.add("stiffness", {false, false},
                      StraightCode{*evaluations_->stiffness, components("out", count)},
                      {{fmt::format("std::array<Scalar, {}>& out", count), count > 0}});
        }
        if (!evaluations_->constant) { return; }
        const auto& [qq, mixed, conjugates] = *evaluations_->constant;
        list_.add_block("constant_d2Hdq2", no_variables, qq);
        list_.add_block("constant_d2Hdqdp", no_variables, mixed);
        list_.add_block("constant_d2Hdp2", no_variables, conjugates);
    }

    void add_second() {
        if (evaluations_ == nullptr) {
            add_second_of_sums();
        } else if (evaluations_->second) {
            const auto& [qq, mixed, conjugates] = *evaluations_->second;
            const char H = system_.function_letter(), p = system_.conjugate_letter();
            list_.add_block(fmt::format("d2{}dq2", H), of_q_, qq);
            list_.add_block(fmt::format("d2{}dqd{}", H, p), of_p_, mixed);
            list_.add_block(fmt::format("d2{}d{}2", H, p), of_p_, conjugates);
        }
    }

    void add_second_of_sums() {
        if (!takes_second(step_)) { return; }
        const HessianOfSums& second = std::get<HessianOfSums>(system_.second);
        const auto* velocities = std::get_if<VelocityStep>(&step_.form);
        if (std::holds_alternative<PairStep>(step_.form)) {
            add_rows(second.products, true);
            add_rows(second.products, false);
        } else if (velocities != nullptr && velocities->hessian == HessianForm::products) {
            const Scatter::Arrays arrays = {{"q", true}, {"way", true}};
            list_.add_scattered(
                {"d2Hdq2", "add_product", true, arrays, has_time_, "out = d2H/dq2 way."},
                second.products, Numbers::of_these);
        } else if (velocities != nullptr) {
            list_
                .add("d2Hdq2", {true, false, has_time_}, EntriesOfSums{&second.entries},
                     {{"Matrix& out", false}},
                     "Adds the entries i, j of d2H/dq2 by out.add(i, j, value).")
                .parameters = "class Matrix";
        }
    }

    /// Rows of d2H times a vector, where stages have positions and momenta.
    void add_rows(const std::vector<SystemSum>& products, bool by_q) {
        const std::string letter = by_q ? "q" : "p";
        const Takes& takes = by_q ? of_q_ : of_p_;
        const Scatter::Arrays arrays = {
            {"q", takes.q}, {"p", takes.p}, {"way", takes.q}, {"way_p", takes.p}};
        const std::string doc =
            "Rows by " + letter + " of d2H times a vector: way of positions, way_p of momenta.";
        list_.add_scattered(
            {"d2Hd" + letter, "add_product_by_" + letter, by_q, arrays, takes.time, doc}, products,
            Numbers::of_these);
    }

    /// dH/dq that keeps what it shares with qq v, the tangent at q, and qq v that takes it.
    void add_tangents() {
        if (evaluations_ == nullptr || !evaluations_->tangents) { return; }
        const Tangents& tangents = *evaluations_->tangents;
        const std::vector<Node>& direction = system_.structure.direction;
        const std::vector<std::string> out = components("out", direction.size());
        const std::vector<std::string> kept = components("at", tangents.kept.size());
        StraightCode slope{tangents.slope, followed_by(out, kept)};
        StraightCode along{tangents.along, out, named(direction, "v")};
        along.names.merge(named(tangents.kept, "at"));
        const Argument v{"const Vector& v", uses_any(along.kernel, direction)};
        list_
            .add("dHdq", {true, false, has_time_}, std::move(slope),
                 {{"Vector& out"}, {"Tangent& at", !kept.empty()}})
            .is_counted = counts_;
        list_.add("d2Hdq2", {true, false}, std::move(along),
                  {{"const Tangent& at", !kept.empty()}, v, {"Vector& out"}});
    }

    // ---- directions that steps carry along ----

    /// d2H along directions: of the slopes that a step evaluates.
    void add_directions() {
        const bool are_needed = evaluations_ != nullptr && evaluations_->directions;
        if (!are_needed) { return; }
        const DirectionKernels& all = *evaluations_->directions;
        const NodeNames dq = named(all.dq, "dq"), dp = named(all.dp, "dp");
        const std::vector<std::string> out = components("out", all.dq.size());
        if (std::holds_alternative<PairStep>(step_.form)) {
            NodeNames both = dq;
            both.insert(dp.begin(), dp.end());
            add_along(
                "", {true, true, has_time_}, all.both, both,
                followed_by(components("by_q", all.dq.size()), components("by_p", all.dp.size())),
                {{"const Values& dq"}, {"const Values& dp"}, {"Values& by_q"}, {"Values& by_p"}});
            return;
        }
        add_along("_q", of_q_, all.by_q, dq, out, {{"const Values& dq"}, {"Values& out"}});
        if (std::holds_alternative<ExplicitStep>(step_.form)) {
            add_along("_p", of_p_, all.by_p, dp, out, {{"const Values& dp"}, {"Values& out"}});
        }
    }

    /// A function that keeps what directions share at a point, and one that is called for each.
    void add_along(const std::string& name, Takes takes, const DirectionKernel& kernel,
                   const NodeNames& directions, const std::vector<std::string>& out,
                   std::vector<Argument> arguments) {
        const std::vector<std::string> kept = components("kept", kernel.kept.size());
        const bool has_lanes = step_.has_lanes();
        SystemFunction& point =
            list_.add_of_lanes("keep" + name, takes, StraightCode{kernel.point, kept},
                               {{has_lanes ? "Values& kept" : "Kept& kept", !kept.empty()}});
        if (!has_lanes) { point.parameters = "class Kept"; }
        StraightCode code{kernel.along, out, named(kernel.kept, "kept")};
        code.names.insert(directions.begin(), directions.end());
        arguments.insert(arguments.begin(), {"const Kept& kept", !kept.empty()});
        add_of_any("along" + name, no_variables, std::move(code), std::move(arguments)).parameters =
            "class Kept, class Values, class Value = hvi::detail::ScalarOf<Values>";
    }

    /// Adds code of numbers or of lanes, whatever the step takes: directions take both.
    SystemFunction& add_of_any(std::string name, Takes takes, StraightCode code,
                               std::vector<Argument> others) {
        constexpr std::size_t small = 32;
        const bool is_small = code.kernel.nodes.size() <= small;
        code.takes_lanes = true;
        SystemFunction& function =
            list_.add(std::move(name), takes, std::move(code), std::move(others));
        function.parameters = "class Values, class Value = hvi::detail::ScalarOf<Values>";
        function.is_inlined = is_small;
        return function;
    }

    /// The constants of a quadratic H that are not zero.
    void add_quadratic() {
        const Structure& found = system_.structure;
        const Hessian& second = hessian_of(system_);
        const std::size_t n = system_.degrees_of_freedom();
        StraightCode code;
        std::vector<Scaled> results;
        const auto set = [&](std::string target, const Scaled& value) {
            if (value.is_zero()) { return; }
            code.targets.push_back(std::move(target));
            results.push_back(value);
        };
        for (std::size_t i = 0; i < n; ++i) {
            for (std::size_t j = 0; j < n; ++j) {
                set(fmt::format("H.qq[{}][{}]", i, j), second.qq[i][j]);
                set(fmt::format("H.qp[{}][{}]", i, j), second.mixed[i][j]);
                set(fmt::format("H.pp[{}][{}]", i, j), second.conjugates[i][j]);
            }
            set(fmt::format("H.by_q[{}]", i), found.by_q[i]);
            set(fmt::format("H.by_p[{}]", i), found.by_p[i]);
        }
        code.kernel = kernel(system_.graph, std::move(results));
        const Argument out{fmt::format("hvi::detail::Quadratic<Scalar, {}>& H", n),
                           !code.targets.empty()};
        list_.add("quadratic", no_variables, std::move(code), {out});
    }

    // ---- where the scene begins ----

    void add_begin_of_families() {
        std::vector<Argument> arguments = {{"Vector& q_of"}, {"Vector& p_of"}};
        if (begins_in_file(system_)) {
            arguments.insert(arguments.begin(), {"const Parameters& parameters"});
        }
        list_.add("begin", no_variables, StartOfFamilies{}, std::move(arguments),
                  "Where the scene begins; empty where lists do not fit.");
    }

    void add_begin() {
        StraightCode code{kernel_of_inputs(system_.graph, start_of(system_))};
        code.has_parameters = true;
        std::vector<Node> parameters;
        for (const auto& [node, name] : parameter_names(system_)) { parameters.push_back(node); }
        const bool uses_parameters = uses_any(code.kernel, parameters);
        const std::string p(1, system_.conjugate_letter());
        code.targets = followed_by(components("q", coordinate_nodes(system_).size()),
                                   components(p, conjugate_nodes(system_).size()));
        const std::string q = rotations_of(system_) == 0 ? "Vector& q" : "Positions& q";
        list_.add("begin", no_variables, std::move(code),
                  {{"const Parameters& parameters", uses_parameters}, {q}, {"Vector& " + p}});
    }

    const System& system_;
    const SceneWishes& wishes_;
    const Step& step_;
    const Evaluations* evaluations_;  ///< none where sums stay loops
    bool counts_, has_time_;
    Takes of_q_, of_p_;  ///< variables that dH/dq depends on, and dH/dp
    FunctionList list_;
};

}  // namespace

std::vector<SystemFunction> functions_of_class(const System& system, const SceneWishes& wishes,
                                               const Step& step, const Evaluations* evaluations) {
    return ClassFunctions(system, wishes, step, evaluations).all();
}

/// NOTE: sweeps over sites know how many they take.
bool counts_evaluations(const SceneWishes& wishes, const Step& step) {
    return wishes.evaluations && step.layout != Layout::sites;
}

std::vector<const SystemSum*> scattered_sums(const std::vector<SystemFunction>& functions) {
    std::vector<const SystemSum*> result;
    for (const SystemFunction& function : functions) {
        const auto* body = std::get_if<BodyOfSums>(&function.body);
        if (body == nullptr) { continue; }
        const auto* derivatives = std::get_if<DerivativesOfSum>(body);
        if (derivatives != nullptr) { result.push_back(derivatives->sum); }
    }
    return result;
}

}  // namespace hvi::gen
