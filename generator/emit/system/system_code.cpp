// The class System of a scene, and the headers that it needs.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>

#include "generator/emit/system/class_functions.hpp"
#include "generator/emit/system/loop_files.hpp"
#include "generator/emit/system/scene_code.hpp"
#include "generator/emit/system/site_writer.hpp"
#include "generator/emit/system/size_members.hpp"
#include "generator/emit/system/start_writer.hpp"
#include "generator/expr/functions.hpp"

namespace hvi::gen {

namespace {

void mirror(Writer& writer, std::size_t n) {
    writer.open("for (std::size_t i = 1; i < {}; ++i) {{", n);
    writer.line("for (std::size_t j = 0; j < i; ++j) {{ out(j, i) = out(i, j); }}").close();
}

/// Returns whether H calls functions of src/hvi/detail/lanes/lane_functions.hpp, which other
/// headers need not include.
bool calls_lane_functions(const System& system) {
    constexpr std::string_view without_library[] = {"sin", "cos", "tan"};
    for (Node node = 0; node < system.graph.size(); ++node) {
        const Computation& computation = system.graph.at(node);
        if (computation.operation != Operation::call) { continue; }
        const Function* const function = find_function(computation.name);
        const bool is_needed = function != nullptr && function->nature == Nature::analytic &&
                               std::count(std::begin(without_library), std::end(without_library),
                                          computation.name) == 0;
        if (is_needed) { return true; }
    }
    return false;
}

std::string include_of_arrays(const System& system, const Step& step, const SceneWishes& wishes) {
    if (step.layout == Layout::threads) { return {}; }
    std::string text = "#include <array>\n#include <cmath>";
    if (wishes.evaluations) { text += "\n#include <cstdint>"; }
    // NOTE: explicit steppers carry a copy of it.
    if (!step.is_explicit() && calls_more_math(system, wishes)) {
        text += "\n#include <hvi/detail/numbers/more_math.hpp>";
    }
    if (step.has_lanes() && calls_lane_functions(system)) {
        text += "\n#include <hvi/detail/lanes/lane_functions.hpp>";
    }
    return text;
}

/// Returns the includes of a system with loops. NOTE: explicit steppers also include headers of hvi
/// that they have copies of.
std::string include_of_loops(const System& system, const SceneWishes& wishes, const Step& step) {
    std::string text = "#include <algorithm>\n#include <array>\n#include <cstdint>\n"
                       "#include <limits>\n#include <type_traits>\n#include <vector>\n\n"
                       "#include <hvi/detail/coefficients/rounded.hpp>\n"
                       "#include <hvi/detail/lanes/lane_functions.hpp>\n"
                       "#include <hvi/detail/loops/along.hpp>\n"
                       "#include <hvi/detail/loops/ranges.hpp>\n";
    text += include_of_files(system);
    if (!scattered_sums(functions_of_class(system, wishes, step, nullptr)).empty()) {
        text += "#include <hvi/detail/loops/chunks.hpp>\n";
    }
    if (system.sites) { text += "#include <hvi/detail/loops/sites.hpp>\n"; }
    if (step.layout == Layout::components) {
        text += "#include <hvi/detail/loops/stage_sweeps.hpp>\n";
    }
    return text;
}

/// Returns the names of families, one after the other.
std::string names_of(const std::vector<SystemFamily>& families) {
    std::vector<std::string> names;
    for (const SystemFamily& family : families) { names.push_back(family.name); }
    return fmt::format("{}", fmt::join(names, ", "));
}

/// Returns H and its variables in words.
std::string about(const System& system) {
    const std::string written = to_text(system.expression);
    if (system.is_transformed) { return "H = p v - L, where L = " + written; }
    if (!system.is_written_out()) { return "H = " + written; }
    if (rotations_of(system) > 0) {
        return fmt::format(
            "H = {}, where q is ({}) and p is ({}); D, the part of dH/dq that "
            "belongs to a rotation R, is the derivative of H(R exp(hat eta)) by eta.",
            written, names_of(system.coordinates), names_of(system.conjugates));
    }
    return fmt::format("{} = {}, where q is ({}) and {} is ({}).", system.function_letter(),
                       written, names_of(system.coordinates), system.conjugate_letter(),
                       names_of(system.conjugates));
}

/// Returns `const Vector& q`, marked where it may be unused.
std::string text_of(const Argument& argument) {
    return (argument.is_used ? "" : "[[maybe_unused]] ") + argument.text;
}

/// Returns the line of a function up to its body. NOTE: on a device no product is a constant
/// expression.
std::string signature(const SystemFunction& function, Constants constants) {
    const bool is_of_device = constants == Constants::are_of_device;
    const auto* code = std::get_if<StraightCode>(&function.body);
    const bool is_static = code != nullptr && code->has_parameters;
    std::vector<std::string> arguments;
    for (const Argument& each : function.arguments) { arguments.push_back(text_of(each)); }
    const std::string_view attribute = function.returns != "void" ? "[[nodiscard]] "
                                       : function.is_inlined      ? "HVI_INLINE_IN_LANES "
                                                                  : "";
    return fmt::format("{}{}{}{}{} {}({}){}", attribute, is_of_device ? "HVI_DEVICE " : "",
                       is_static ? "static " : "",
                       code != nullptr && !is_of_device ? "constexpr " : "", function.returns,
                       function.name, fmt::join(arguments, ", "), is_static ? "" : " const");
}

/// Returns whether sums over pairs are cut into chunks.
bool has_chunks(const std::vector<SystemFunction>& functions) {
    const std::vector<const SystemSum*> sums = scattered_sums(functions);
    return std::any_of(sums.begin(), sums.end(),
                       [](const SystemSum* sum) { return sum->loops.size() > 1; });
}

Constants constants_of(const Step& step) {
    switch (step.layout) {
    case Layout::trajectories: return Constants::are_of_template;
    case Layout::threads: return Constants::are_of_device;
    default: return Constants::are_numbers;
    }
}

/// Writes the class: its functions as listed, and the members that they need.
class ClassWriter {
public:
    ClassWriter(const System& system, const SceneWishes& wishes, const Step& step,
                const Evaluations* evaluations)
        : system_(system),
          step_(step),
          evaluations_(evaluations),
          has_loops_(evaluations == nullptr),
          constants_(constants_of(step)),
          counts_(counts_evaluations(wishes, step)),
          library_(has_loops_                       ? "hvi::math"
                   : step.layout == Layout::threads ? "hvi::device"
                                                    : library(wishes)),
          functions_(functions_of_class(system, wishes, step, evaluations)),
          names_(system, constants_),
          loops_(system, names_),
          sizes_(system, names_, has_chunks(functions_)) {}

    [[nodiscard]] std::string text() {
        // NOTE: the constructor comes last, as it computes values that the functions need.
        Writer functions(2);
        for (const SystemFunction& function : functions_) {
            if (&function != &functions_.front()) { functions.blank(); }
            write(functions, function);
        }
        Writer writer(1);
        writer.comment(about(system_), "/// ");
        if (constants_ == Constants::are_of_template) { writer.line("template <class Constant>"); }
        writer.open("struct {} {{", class_name());
        write_types(writer);
        writer.blank();
        write_constructor(writer);
        writer.blank().insert(functions.str());
        write_data(writer);
        writer.close("};");
        if (constants_ == Constants::are_of_template) { write_names(writer); }
        return writer.str();
    }

private:
    [[nodiscard]] std::string_view class_name() const {
        return constants_ == Constants::are_of_template ? "SystemOf" : "System";
    }

    /// Writes the names of both classes, of one trajectory and of eight.
    static void write_names(Writer& writer) {
        writer.line("using System = SystemOf<Scalar>;");
        writer.line("using LaneSystem = SystemOf<hvi::detail::TrajectoryRow<Scalar>>;");
    }

    void write(Writer& writer, const SystemFunction& function) {
        if (!function.doc.empty()) { writer.comment(function.doc, "/// "); }
        if (!function.parameters.empty()) { writer.line("template <{}>", function.parameters); }
        std::visit([&](const auto& body) { write_whole(writer, function, body); }, function.body);
    }

    void write_whole(Writer& writer, const SystemFunction& function, const OneLine& body) {
        writer.line("{} {{ {} }}", signature(function, constants_), body.statement);
    }

    template <class Body>
    void write_whole(Writer& writer, const SystemFunction& function, const Body& body) {
        writer.open("{} {{", signature(function, constants_));
        if (function.is_counted) { write_count(writer, function.body); }
        write_body(writer, body);
        writer.close();
    }

    static void write_count(Writer& writer, const FunctionBody& body) {
        const auto* code = std::get_if<StraightCode>(&body);
        if (code == nullptr) {
            writer.line("++evaluations;");
        } else {
            writer.line("evaluations += {};",
                        code->takes_lanes ? "hvi::detail::lane_count<Value>" : "1");
        }
    }

    // ---- bodies ----

    void write_body(Writer& writer, const StraightCode& code) {
        NodeNames locals = code.names;
        locals.merge(variable_names(system_));
        const std::string_view value = code.takes_lanes ? "Value" : "Scalar";
        const NodeNames names = code.has_parameters
                                    ? names_.given_inputs(code.kernel)
                                    : names_.converted(names_.given(code.kernel, locals), value);
        const auto results = write_code(writer, system_.graph, code.kernel, names,
                                        code.takes_lanes ? "hvi::math" : library_, value);
        if (code.targets.empty() && !results.empty()) {
            writer.line("return {};", results.front());
        }
        for (std::size_t k = 0; k < code.targets.size(); ++k) {
            writer.line("{} = {};", code.targets[k], results[k]);
        }
        if (code.is_mirrored) { mirror(writer, system_.degrees_of_freedom()); }
    }

    static void write_body(Writer& writer, const Statements& body) {
        for (const std::string& line : body.lines) { writer.line("{}", line); }
    }

    void write_body(Writer& writer, const StartOfFamilies& body) {
        StartWriter(loops_).write(writer, body);
    }
    void write_body(Writer& writer, const BodyOfSites& body) {
        SiteWriter(*system_.sites, loops_).write(writer, body);
    }
    void write_body(Writer& writer, const BodyOfSums& body) { loops_.write(writer, body); }

    // ---- the rest of the class ----

    void write_types(Writer& writer) const {
        if (has_loops_) { writer.line("using Scalar = Number;"); }
        if (constants_ == Constants::are_of_device) {
            writer.line("using Scalar = hvi::device::Real<Number>;");
            writer.line("using Vector = hvi::device::Vector<Scalar, {}>;",
                        system_.degrees_of_freedom());
        } else {
            writer.line("using Vector = {};", vector_type(system_));
        }
        if (!has_loops_ && rotations_of(system_) > 0) {
            writer.line("using Positions = typename Space::Positions;");
        }
        if (system_.sites) { write_site_types(writer, *system_.sites); }
        if (!has_loops_ && evaluations_->tangents) {
            // NOTE: an empty array would do, but compilers warn of it.
            writer.line("using Tangent = std::array<Scalar, {}>;",
                        std::max<std::size_t>(1, evaluations_->tangents->kept.size()));
        }
        if (const auto* form = std::get_if<VelocityStep>(&step_.form)) {
            writer.line("static constexpr bool has_diagonal_mass = {};", form->has_diagonal_mass);
        }
    }

    [[nodiscard]] std::string_view before_constructor() const {
        if (constants_ == Constants::are_of_device) { return "HVI_DEVICE "; }
        return has_loops_ ? "" : "constexpr ";
    }

    void write_constructor(Writer& writer) {
        Writer body(2);
        std::vector<std::string> members;
        if (has_loops_) {
            members = sizes_.initialised();
            sizes_.write_setup(body);
        }
        names_.write_setup(body, library_);
        const bool has_tables = has_loops_ && !(system_.sizes.empty() && system_.tables.empty());
        const std::string arguments =
            text_of({"const Parameters& parameters", names_.uses_inputs() || has_tables});
        const std::string head =
            fmt::format("{}explicit {}({}{})", before_constructor(), class_name(), arguments,
                        has_loops_ ? sizes_.threads() : "");
        if (members.empty()) {
            writer.open("{} {{", head);
        } else {
            writer.line("{}", head).open("    : {} {{", fmt::join(members, ", "));
        }
        writer.insert(body.str()).close();
        if (constants_ == Constants::are_of_template) { write_lanes(writer); }
    }

    /// Writes the constructor of the class of eight trajectories, which have all their own
    /// constants.
    void write_lanes(Writer& writer) const {
        writer.blank().line("SystemOf() = default;").blank();
        writer.line("/// Gives a lane the constants of one trajectory.");
        if (!names_.has_members()) {
            writer.line("constexpr void set(std::size_t, const SystemOf<Scalar>&) {{}}");
            return;
        }
        writer.open("constexpr void set(std::size_t lane, const SystemOf<Scalar>& one) {{");
        names_.write_copy_to_lane(writer);
        writer.close();
    }

    void write_data(Writer& writer) const {
        Writer data(2);
        names_.write_data(data);
        if (has_loops_) { sizes_.write_data(data); }
        if (counts_) {
            (has_loops_ ? data : writer.blank())
                .line("mutable std::int64_t evaluations = 0;  // of dH/dq");
        }
        if (!data.str().empty()) { writer.blank().insert(data.str()); }
    }

    const System& system_;
    const Step& step_;
    const Evaluations* evaluations_;
    bool has_loops_;
    Constants constants_;
    bool counts_;
    std::string_view library_;  ///< namespace of functions that take no lanes
    std::vector<SystemFunction> functions_;
    ClassNames names_;
    LoopWriter loops_;
    SizeMembers sizes_;
};

}  // namespace

std::string includes_of_class(const System& system, const SceneWishes& wishes, const Step& step,
                              const Evaluations* evaluations) {
    return evaluations != nullptr ? include_of_arrays(system, step, wishes)
                                  : include_of_loops(system, wishes, step);
}

std::string system_text(const System& system, const SceneWishes& wishes, const Step& step,
                        const Evaluations* evaluations) {
    return ClassWriter(system, wishes, step, evaluations).text();
}

}  // namespace hvi::gen
