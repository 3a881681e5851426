// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/emit/system/flow_code.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace hvi::gen {

namespace {

/// Returns the name of a function of the runtime, in hvi::detail.
std::string function_name(const RuntimeValues& values) {
    switch (values.function) {
    case RuntimeFunction::orbits:
        return fmt::format("orbit_values<{}>", values.results.size() / changes_of_orbit);
    case RuntimeFunction::turn_about_momentum: return "turn_about_momentum";
    }
    HVI_CHECK(false);
    return {};
}

/// Writes the class of the flow of one part.
class FlowWriter {
public:
    FlowWriter(const System& system, std::size_t part, std::string_view library, FlowCalls calls,
               Constants constants, Carries carries)
        : system_(system),
          part_(system.parts->parts[part]),
          name_(fmt::format("Flow{}", part + 1)),
          library_(library),
          head_(fmt::format("[[gnu::{}]] void operator()(Path& at) const {{",
                            calls == FlowCalls::inlined ? "always_inline" : "noinline")),
          has_lanes_(constants == Constants::are_of_template),
          is_of_path_(carries == Carries::directions),
          value_(has_lanes_    ? "Lane"
                 : is_of_path_ ? "Value"
                               : "Scalar"),
          names_(system, constants) {
        names_.add_input(system.parts->duration, "time");
    }

    [[nodiscard]] std::string text() {
        // NOTE: the constructor comes last, as it computes values that the calls need.
        Writer calls(2);
        if (part_.usual && has_lanes_) {
            write_call_of_lanes(calls, *part_.usual);
            calls.blank().line("// Changes by any angles.");
            write_changes(calls, part_.moved);
        } else if (part_.usual) {
            write_choice(calls, part_.usual->conditions);
            calls.blank().line("// For angles that are small.");
            write_call(calls, "[[gnu::always_inline]] void usual(Path& at) const {",
                       part_.usual->moved);
            calls.blank().line("// For any angles.");
            write_call(calls, "[[gnu::noinline]] void any(Path& at) const {", part_.moved);
        } else {
            write_call(calls, head_, part_.moved);
        }
        Writer setup(2), data(2);
        for (std::size_t k = 0; k < part_.forms.size(); ++k) { set_form(setup, data, k); }
        names_.write_setup(setup, library_);
        names_.write_data(data);
        if (moves_time()) {
            setup.line("time_ = time;");
            data.line("Scalar time_ = 0;");
        }
        Writer writer(1);
        writer.comment(fmt::format("Flow of the part {} = {} of H over a time: {}.", part_.name,
                                   text_of(part_), part_.flow),
                       "/// ");
        const std::string name = has_lanes_ ? name_ + "Of" : name_;
        if (has_lanes_) { writer.line("template <class Constant>"); }
        writer.open("struct {} {{", name).line("{}() = default;", name);
        writer.open("{}([[maybe_unused]] const Parameters& parameters, [[maybe_unused]] Scalar "
                    "time) {{",
                    name);
        writer.insert(setup.str()).close().blank();
        if (has_lanes_) { write_set(writer); }
        writer.insert(calls.str());
        if (!data.str().empty()) { writer.blank().insert(data.str()); }
        writer.close("};");
        if (has_lanes_) { write_names(writer); }
        return writer.str();
    }

private:
    /// Writes the member that gives a lane the values of one trajectory.
    void write_set(Writer& writer) {
        const bool has_data = names_.has_members() || !part_.forms.empty();
        writer.line("/// Gives a lane the values of one trajectory.");
        writer.open("void set({0}std::size_t lane, {0}const {1}Of<Scalar>& one) {{",
                    has_data ? "" : "[[maybe_unused]] ", name_);
        names_.write_copy_to_lane(writer);
        for (std::size_t k = 0; k < part_.forms.size(); ++k) {
            writer.line("form_{0}_.set(lane, one.form_{0}_);", k + 1);
        }
        writer.close().blank();
    }

    /// Writes the names of both classes, of one trajectory and of eight.
    void write_names(Writer& writer) const {
        writer.line("using {0} = {0}Of<Scalar>;", name_);
        writer.line("using Lane{0} = {0}Of<hvi::detail::TrajectoryRow<Scalar>>;", name_);
    }

    /// Writes the member of a form, and its computation.
    void set_form(Writer& setup, Writer& data, std::size_t k) {
        const FormMoved& form = part_.forms[k];
        const Kernel code = kernel_of_inputs(system_.graph, form.rows);
        // NOTE: in a scope of its own, as the code after it has names of its own.
        setup.open("{{");
        const std::vector<std::string> rows =
            write_code(setup, system_.graph, code, names_.given_inputs(code), library_);
        setup.line("form_{}_ = {{time, {{{}}}}};", k + 1, fmt::format("{}", fmt::join(rows, ", ")));
        setup.close();
        data.line("hvi::detail::FormFlow<Scalar, {}{}> form_{}_;", form.degrees.size(),
                  has_lanes_ ? ", Constant" : "", k + 1);
    }

    /// Writes the call that chooses. NOTE: nothing else is computed before the choice, so that
    /// compilers fuse products and sums of what follows.
    void write_choice(Writer& writer, const std::vector<Scaled>& conditions) {
        begin(writer, head_);
        std::string all;
        for (const std::string& value : results_of(writer, conditions)) {
            all += fmt::format("{}{} >= 0", all.empty() ? "" : " && ", value);
        }
        writer.line("if (!({})) {{ return any(at); }}", all);
        writer.line("usual(at);").close();
    }

    /// Returns whether the time goes on with this flow.
    [[nodiscard]] bool moves_time() const {
        const auto& clock = system_.parts->clock;
        return clock && &system_.parts->parts[*clock] == &part_;
    }

    void write_call(Writer& writer, std::string_view head, std::vector<Moved> moved) {
        moved = momenta_first(std::move(moved));
        begin(writer, head);
        const std::vector<std::string> results = changes_of(writer, moved, {});
        for (std::size_t k = 0; k < moved.size(); ++k) {
            writer.line("const {} change_{} = {};", value_, k + 1, results[k]);
        }
        move(writer, moved, [](std::size_t k) { return fmt::format("change_{}", k + 1); });
        if (moves_time()) { writer.line("at.move_t(time_);"); }
        writer.close();
    }

    /// Writes the call of lanes, each of which takes the changes that it would take alone: those
    /// for small angles, or those for any.
    void write_call_of_lanes(Writer& writer, const UsualFlow& usual) {
        const std::vector<Moved> moved = momenta_first(usual.moved);
        HVI_CHECK(moved.size() == part_.moved.size());
        begin(writer, head_);
        const std::vector<std::string> results = changes_of(writer, moved, usual.conditions);
        writer.line("Mask are_small(true);");
        for (std::size_t k = moved.size(); k < results.size(); ++k) {
            writer.line("are_small = are_small & (Lane(Scalar(0)) <= {});", results[k]);
        }
        writer.open("const std::array<Lane, {}> small = {{", moved.size());
        for (std::size_t k = 0; k < moved.size(); ++k) { writer.line("{},", results[k]); }
        writer.close("};");
        writer.line("const auto others = [&] {{ return any(at); }};");
        writer.line("const auto changes = hvi::detail::small_or_any(are_small, small, others);");
        move(writer, moved, [](std::size_t k) { return fmt::format("changes[{}]", k); });
        writer.close();
    }

    /// Writes the member that returns changes of lanes.
    void write_changes(Writer& writer, std::vector<Moved> moved) {
        moved = momenta_first(std::move(moved));
        begin(writer,
              fmt::format("[[gnu::noinline]] std::array<Lane, {}> any(const Path& at) const "
                          "{{",
                          moved.size()));
        const std::vector<std::string> results = changes_of(writer, moved, {});
        writer.line("return {{{}}};", fmt::join(results, ", ")).close();
    }

    /// NOTE: angles of later turns wait for angular momenta, and for no rotation.
    [[nodiscard]] static std::vector<Moved> momenta_first(std::vector<Moved> moved) {
        std::stable_partition(moved.begin(), moved.end(),
                              [](const Moved& each) { return each.is_conjugate; });
        return moved;
    }

    /// Writes the code of all changes, and of other values after them.
    [[nodiscard]] std::vector<std::string>
    changes_of(Writer& writer, const std::vector<Moved>& moved, const std::vector<Scaled>& others) {
        std::vector<Scaled> values;
        for (const Moved& each : moved) { values.push_back(each.change); }
        values.insert(values.end(), others.begin(), others.end());
        for (const RuntimeValues& each : part_.in_each_flow) { write_values(writer, each); }
        return results_of(writer, std::move(values));
    }

    /// Writes a call of a function of the runtime, whose results are values from then on.
    void write_values(Writer& writer, const RuntimeValues& values) {
        const std::string array = fmt::format("values_{}", ++arrays_);
        // NOTE: in a scope of its own, as the code that follows has names of its own.
        const std::size_t count = values.results.size();
        writer.line("const std::array<{}, {}> {} = [&] {{", value_, count, array);
        Writer body(0);
        const std::vector<std::string> given = results_of(body, values.given);
        body.line("return hvi::detail::{}(std::array<{}, {}>{{{}}});", function_name(values),
                  value_, given.size(), fmt::format("{}", fmt::join(given, ", ")));
        writer.insert(body.str());
        writer.line("}}();");
        for (std::size_t k = 0; k < count; ++k) {
            locals_[values.results[k]] = fmt::format("{}[{}]", array, k);
        }
    }

    void begin(Writer& writer, std::string_view head) const {
        writer.line("template <class Path>").open("{}", head);
        if (is_of_path_) {
            writer.line("using Value [[maybe_unused]] = std::decay_t<decltype(at.x.q[0])>;");
        }
        writer.line("[[maybe_unused]] const auto& q = at.x.q;");
        writer.line("[[maybe_unused]] const auto& p = at.x.p;");
        if (has(system_.graph.at(part_.value.node).roles, Role::time)) {
            writer.line("[[maybe_unused]] const Scalar t = at.clock.now();");
        }
    }

    [[nodiscard]] std::vector<std::string> results_of(Writer& writer, std::vector<Scaled> values) {
        const Kernel code = kernel(system_.graph, std::move(values));
        NodeNames names = names_.given(code, locals_);
        names = is_of_path_ ? names_.all_converted(std::move(names), value_)
                            : names_.converted(std::move(names), value_);
        return write_code(writer, system_.graph, code, names, library_, value_);
    }

    /// Writes the moves by changes, all of values before the flow, of which name() has the names,
    /// and the moves of forms, with which the others have no variable in common.
    template <class Name>
    void move(Writer& writer, const std::vector<Moved>& all, Name name) const {
        for (std::size_t k = 0; k < all.size(); ++k) {
            writer.line("at.move_{}({}, {});", all[k].is_conjugate ? 'p' : 'q', all[k].component,
                        name(k));
        }
        for (std::size_t k = 0; k < part_.forms.size(); ++k) {
            writer.line("form_{}_(at, {{{}}});", k + 1,
                        fmt::format("{}", fmt::join(part_.forms[k].degrees, ", ")));
        }
    }

    const System& system_;
    const HamiltonianPart& part_;
    std::string name_;
    std::string_view library_;
    std::string head_;  ///< of the call
    bool has_lanes_;
    bool is_of_path_;         ///< calls compute in the numbers of the path
    std::string_view value_;  ///< type of what the calls compute
    ClassNames names_;
    NodeNames locals_ = variable_names(system_);  ///< what the calls are given
    std::size_t arrays_ = 0;
};

}  // namespace

std::string flow_text(const System& system, std::size_t part, std::string_view library,
                      FlowCalls calls, Constants constants, Carries carries) {
    return FlowWriter(system, part, library, calls, constants, carries).text();
}

}  // namespace hvi::gen
