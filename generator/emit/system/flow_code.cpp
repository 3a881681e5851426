// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/emit/system/flow_code.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "generator/emit/system/class_names.hpp"

namespace hvi::gen {

namespace {

/// Writes the class of the flow of one part.
class FlowWriter {
public:
    FlowWriter(const System& system, std::size_t part, std::string_view library, bool is_inlined)
        : system_(system),
          part_(system.parts->parts[part]),
          name_(fmt::format("Flow{}", part + 1)),
          library_(library),
          head_(fmt::format("[[gnu::{}]] void operator()(Path& at) const {{",
                            is_inlined ? "always_inline" : "noinline")),
          names_(system, Constants::are_numbers) {
        names_.add_input(system.parts->duration, "time");
    }

    [[nodiscard]] std::string text() {
        // NOTE: the constructor comes last, as it computes values that the calls need.
        Writer calls(2);
        if (part_.usual) {
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
        Writer writer(1);
        writer.comment(fmt::format("Flow of the part {} = {} of H over a time: {}.", part_.name,
                                   text_of(part_), part_.flow),
                       "/// ");
        writer.open("struct {} {{", name_).line("{}() = default;", name_);
        writer.open("{}([[maybe_unused]] const Parameters& parameters, [[maybe_unused]] Scalar "
                    "time) {{",
                    name_);
        writer.insert(setup.str()).close().blank();
        writer.insert(calls.str());
        if (!data.str().empty()) { writer.blank().insert(data.str()); }
        return writer.close("};").str();
    }

private:
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
        data.line("hvi::detail::FormFlow<Scalar, {}> form_{}_;", form.degrees.size(), k + 1);
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

    void write_call(Writer& writer, std::string_view head, std::vector<Moved> moved) {
        // NOTE: angles of later turns wait for angular momenta, and for no rotation.
        std::stable_partition(moved.begin(), moved.end(),
                              [](const Moved& each) { return each.is_conjugate; });
        std::vector<Scaled> values;
        for (const Moved& each : moved) { values.push_back(each.change); }
        begin(writer, head);
        for (const RuntimeValues& each : part_.in_each_flow) { write_values(writer, each); }
        const std::vector<std::string> results = results_of(writer, std::move(values));
        move(writer, moved, results);
        writer.close();
    }

    /// Writes a call of a function of the runtime, whose results are values from then on.
    void write_values(Writer& writer, const RuntimeValues& values) {
        const std::string array = fmt::format("values_{}", ++arrays_);
        // NOTE: in a scope of its own, as the code that follows has names of its own.
        writer.line("const std::array<Scalar, {}> {} = [&] {{", values.results.size(), array);
        Writer body(0);
        const std::vector<std::string> given = results_of(body, values.given);
        body.line("return hvi::detail::{}(std::array<Scalar, {}>{{{}}});", values.function,
                  given.size(), fmt::format("{}", fmt::join(given, ", ")));
        writer.insert(body.str());
        writer.line("}}();");
        for (std::size_t k = 0; k < values.results.size(); ++k) {
            locals_[values.results[k]] = fmt::format("{}[{}]", array, k);
        }
    }

    static void begin(Writer& writer, std::string_view head) {
        writer.line("template <class Path>").open("{}", head);
        writer.line("[[maybe_unused]] const auto& q = at.x.q;");
        writer.line("[[maybe_unused]] const auto& p = at.x.p;");
    }

    [[nodiscard]] std::vector<std::string> results_of(Writer& writer, std::vector<Scaled> values) {
        const Kernel code = kernel(system_.graph, std::move(values));
        return write_code(writer, system_.graph, code, names_.given(code, locals_), library_);
    }

    /// Writes all changes, from values before the flow, then the moves by them, and the moves of
    /// forms, with which the others have no variable in common.
    void move(Writer& writer, const std::vector<Moved>& all,
              const std::vector<std::string>& changes) const {
        for (std::size_t k = 0; k < all.size(); ++k) {
            writer.line("const Scalar change_{} = {};", k + 1, changes[k]);
        }
        for (std::size_t k = 0; k < all.size(); ++k) {
            writer.line("at.move_{}({}, change_{});", all[k].is_conjugate ? 'p' : 'q',
                        all[k].component, k + 1);
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
    ClassNames names_;
    NodeNames locals_ = variable_names(system_);  ///< what the calls are given
    std::size_t arrays_ = 0;
};

}  // namespace

std::string flow_text(const System& system, std::size_t part, std::string_view library,
                      bool is_inlined) {
    return FlowWriter(system, part, library, is_inlined).text();
}

}  // namespace hvi::gen
