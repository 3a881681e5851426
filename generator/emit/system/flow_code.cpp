// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/emit/system/flow_code.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <vector>

#include "generator/emit/system/class_names.hpp"

namespace hvi::gen {

namespace {

/// Writes the class of the flow of one part.
class FlowWriter {
public:
    FlowWriter(const System& system, std::size_t part, std::string_view library)
        : system_(system),
          part_(system.parts->parts[part]),
          name_(fmt::format("Flow{}", part + 1)),
          library_(library),
          names_(system, Constants::are_numbers) {
        names_.add_input(system.parts->duration, "time");
    }

    [[nodiscard]] std::string text() {
        // NOTE: the constructor comes last, as it computes values that the calls need.
        Writer calls(2);
        if (part_.usual) {
            write_usual(calls, *part_.usual);
            calls.blank();
            write_call(calls, "void turn(Path& at) const {", part_.moved);
        } else {
            write_call(calls, "void operator()(Path& at) const {", part_.moved);
        }
        Writer setup(2), data(2);
        for (std::size_t k = 0; k < part_.forms.size(); ++k) { set_form(setup, data, k); }
        names_.write_setup(setup, library_);
        names_.write_data(data);
        Writer writer(1);
        writer.comment(fmt::format("Flow of the part {} = {} of H over a time: {}.", part_.name,
                                   to_text(part_.expression), part_.flow),
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

    /// Writes the call for what is usual, which hands the rest to another one.
    void write_usual(Writer& writer, const UsualFlow& usual) {
        std::vector<Scaled> values = usual.conditions;
        for (const Moved& moved : usual.moved) { values.push_back(moved.change); }
        begin(writer, "void operator()(Path& at) const {");
        std::vector<std::string> results = results_of(writer, std::move(values));
        const auto conditions =
            results.begin() + static_cast<std::ptrdiff_t>(usual.conditions.size());
        std::string all;
        for (auto condition = results.begin(); condition != conditions; ++condition) {
            all += fmt::format("{}{} >= 0", all.empty() ? "" : " && ", *condition);
        }
        writer.line("if (!({})) {{ return turn(at); }}", all);
        results.erase(results.begin(), conditions);
        move(writer, usual.moved, results);
        writer.close();
    }

    void write_call(Writer& writer, std::string_view head, const std::vector<Moved>& moved) {
        std::vector<Scaled> values;
        for (const Moved& each : moved) { values.push_back(each.change); }
        begin(writer, head);
        const std::vector<std::string> results = results_of(writer, std::move(values));
        move(writer, moved, results);
        writer.close();
    }

    static void begin(Writer& writer, std::string_view head) {
        writer.line("template <class Path>").open("{}", head);
        writer.line("[[maybe_unused]] const auto& q = at.x.q;");
        writer.line("[[maybe_unused]] const auto& p = at.x.p;");
    }

    [[nodiscard]] std::vector<std::string> results_of(Writer& writer, std::vector<Scaled> values) {
        const Kernel code = kernel(system_.graph, std::move(values));
        return write_code(writer, system_.graph, code, names_.given(code, variable_names(system_)),
                          library_);
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
    ClassNames names_;
};

}  // namespace

std::string flow_text(const System& system, std::size_t part, std::string_view library) {
    return FlowWriter(system, part, library).text();
}

}  // namespace hvi::gen
