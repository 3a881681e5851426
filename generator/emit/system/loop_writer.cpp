// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/emit/system/loop_writer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <utility>

#include "generator/emit/system/scene_code.hpp"

namespace hvi::gen {

namespace {

/// Returns the width of lanes for a kernel. NOTE: a square root or a quotient of eight numbers is
/// no faster than two of four.
std::size_t lanes_for(const Kernel& kernel) {
    const auto& [additions, multiplications, divisions, roots, calls] = kernel.counts;
    return divisions + roots > 0 && calls == 0 ? 4 : 8;
}

}  // namespace

std::vector<Scaled> values(const std::vector<AccessSlope>& slopes) {
    std::vector<Scaled> result;
    for (const AccessSlope& slope : slopes) { result.push_back(slope.value); }
    return result;
}

std::vector<bool> needed_totals(const System& system, std::vector<Scaled> values) {
    std::vector<bool> needed(system.totals.size(), false);
    for (std::size_t k = needed.size(); k-- > 0;) {
        const SystemTotal& total = system.totals[k];
        needed[k] = kernel(system.graph, values).uses[total.node] != 0;
        if (!needed[k]) { continue; }
        for (const SystemSum& sum : total.sums) { values.push_back(sum.value); }
    }
    return needed;
}

bool needs_totals(const System& system, const std::vector<Scaled>& values) {
    const std::vector<bool> needed = needed_totals(system, values);
    return std::find(needed.begin(), needed.end(), true) != needed.end();
}

bool has_time(const System& system, std::size_t total) {
    return has(system.graph.at(system.totals[total].node).roles, Role::time);
}

bool LoopWriter::depends(std::size_t access, const std::string& index) const {
    const std::vector<ElementIndex>& indices = system_.accesses[access].indices;
    return std::any_of(indices.begin(), indices.end(), [&](const ElementIndex& each) {
        return each.form.coefficient(index) != 0 ||
               (each.modulus && each.modulus->coefficient(index) != 0) ||
               each.offset.coefficient(index) != 0;
    });
}

/// NOTE: each element stays along the innermost loop, or is followed by its neighbours.
bool LoopWriter::goes_in_lanes(const SystemSum& sum) const {
    if (sum.loops.empty()) { return false; }
    const std::string& inner = sum.loops.back().index;
    return std::all_of(sum.accesses.begin(), sum.accesses.end(), [&](std::size_t a) {
        if (!depends(a, inner)) { return true; }
        const std::vector<ElementIndex>& indices = system_.accesses[a].indices;
        const bool only_last =
            std::none_of(indices.begin(), indices.end() - 1, [&](const ElementIndex& index) {
                return index.form.coefficient(inner) != 0 || index.modulus;
            });
        const ElementIndex& last = indices.back();
        return only_last && last.form.coefficient(inner) == 1 && !last.modulus;
    });
}

void LoopWriter::name_numbers(NodeNames& locals, const std::vector<Loop>& loops) const {
    if (system_.time) { locals[*system_.time] = "t"; }
    for (std::size_t k = 0; k < system_.totals.size(); ++k) {
        locals[system_.totals[k].node] = fmt::format("totals[{}]", k);
    }
    for (Node node = 0; node < system_.graph.size(); ++node) {
        const Computation& computation = system_.graph.at(node);
        if (computation.operation != Operation::input) { continue; }
        for (const Loop& loop : loops) {
            if (computation.name != loop.index) { continue; }
            locals[node] = fmt::format("static_cast<Scalar>({})", names_.index(loop.index));
        }
    }
}

NodeNames LoopWriter::load(Writer& writer, const std::vector<std::size_t>& accesses,
                           const Kernel& kernel, const std::vector<Loop>& loops) {
    NodeNames locals;
    name_numbers(locals, loops);
    std::size_t count = 0;
    for (const std::size_t a : accesses) {
        const Access& access = system_.accesses[a];
        if (access.node >= kernel.uses.size() || kernel.uses[access.node] == 0) { continue; }
        const std::string name = fmt::format("a{}", ++count);
        writer.line("const Scalar {} = {}[{}];", name, names_.array(access), names_.place(access));
        locals[access.node] = name;
    }
    return names_.given(kernel, locals);
}

void LoopWriter::open_loop(Writer& writer, const Loop& loop) const {
    const std::string i = names_.index(loop.index);
    writer.open("for (Place {0} = {1}; {0} <= {2}; ++{0}) {{", i, names_.whole(loop.range.first),
                names_.whole(loop.range.last));
}

void LoopWriter::open_loops(Writer& writer, const std::vector<Loop>& loops) const {
    if (loops.empty()) { writer.open("{{"); }
    for (const Loop& loop : loops) { open_loop(writer, loop); }
}

void LoopWriter::close_loops(Writer& writer, const std::vector<Loop>& loops) {
    for (std::size_t l = 0; l < std::max<std::size_t>(loops.size(), 1); ++l) { writer.close(); }
}

/// Writes the body of a sum at one place, where it is computed one by one.
void LoopWriter::write_body(Writer& writer, const SystemSum& sum,
                            const std::vector<AccessSlope>& slopes) {
    const Kernel slope = kernel(system_.graph, values(slopes));
    const NodeNames given = load(writer, sum.accesses, slope, sum.loops);
    const auto results = write_code(writer, system_.graph, slope, given, "hvi::math");
    for (std::size_t k = 0; k < slopes.size(); ++k) {
        writer.line("out[{}] += {};", names_.place(system_.accesses[slopes[k].access]), results[k]);
    }
}

void LoopWriter::write_along(Writer& writer, const SystemSum& sum, const Kernel& kernel,
                             const AlongLoop& loop,
                             const std::function<void(const std::vector<std::string>&)>& use) {
    const std::string& inner = sum.loops.back().index;
    NodeNames locals;
    std::size_t count = 0;
    const auto load = [&](bool moves, std::string_view type, std::string_view before,
                          std::string_view between, std::string_view after) {
        for (const std::size_t a : sum.accesses) {
            const Access& access = system_.accesses[a];
            const bool is_used = access.node < kernel.uses.size() && kernel.uses[access.node] != 0;
            if (!is_used || depends(a, inner) != moves) { continue; }
            locals[access.node] = fmt::format("a{}", ++count);
            writer.line("const {} a{} = {}{}{}{}{};", type, count, before, names_.array(access),
                        between, names_.place(access), after);
        }
    };
    load(false, "Scalar", "", "[", "]");
    name_numbers(locals, sum.loops);
    const std::string j = names_.index(inner);
    for (auto& [node, name] : locals) {
        if (system_.graph.at(node).name == inner) { name = fmt::format("stretch.indices({})", j); }
    }
    writer.open("hvi::detail::along<Scalar, {}>({}, {}, [&](auto stretch, "
                "[[maybe_unused]] Place {}) HVI_INLINED {{",
                loop.width, loop.first, loop.end, j);
    writer.line("using V = hvi::detail::ValueOf<decltype(stretch)>;");
    load(true, "V", "stretch.load(", " + ", ")");
    use(write_code(writer, system_.graph, kernel, names_.given(kernel, locals), "hvi::math", "V"));
    writer.close("});");
}

/// Adds the derivatives, with the innermost loop in lanes. NOTE: subtracting costs less than
/// negating and adding.
void LoopWriter::write_lanes(Writer& writer, const SystemSum& sum,
                             const std::vector<AccessSlope>& slopes) {
    const Loop& inner = sum.loops.back();
    const auto is_negative = [&](const AccessSlope& slope) {
        return depends(slope.access, inner.index) && slope.value.factor.above < 0;
    };
    std::vector<Scaled> results = values(slopes);
    for (std::size_t k = 0; k < slopes.size(); ++k) {
        if (is_negative(slopes[k])) { results[k].factor = -results[k].factor; }
    }
    const Kernel slope = kernel(system_.graph, results);
    const std::size_t width = lanes_for(slope);
    for (std::size_t k = 0; k < slopes.size(); ++k) {
        if (depends(slopes[k].access, inner.index)) { continue; }
        writer.line("hvi::detail::Total<Scalar, {}> sum_{};", width, k + 1);
    }
    const bool is_only_loop = sum.loops.size() == 1;
    const AlongLoop loop{width, is_only_loop ? "from" : names_.whole(inner.range.first),
                         is_only_loop ? "to" : names_.whole(inner.range.last + AffineForm{1})};
    write_along(writer, sum, slope, loop, [&](const std::vector<std::string>& texts) {
        for (std::size_t k = 0; k < slopes.size(); ++k) {
            const Access& access = system_.accesses[slopes[k].access];
            if (depends(slopes[k].access, inner.index)) {
                writer.line("hvi::detail::{}(out + {}, V({}));",
                            is_negative(slopes[k]) ? "subtract" : "add", names_.place(access),
                            texts[k]);
            } else {
                writer.line("sum_{}.add(V({}));", k + 1, texts[k]);
            }
        }
    });
    for (std::size_t k = 0; k < slopes.size(); ++k) {
        if (depends(slopes[k].access, inner.index)) { continue; }
        writer.line("out[{}] += sum_{}.sum();", names_.place(system_.accesses[slopes[k].access]),
                    k + 1);
    }
}

void LoopWriter::write(Writer& writer, const DerivativesOfSum& body) {
    const SystemSum& sum = *body.sum;
    const std::vector<AccessSlope>& slopes = *body.slopes;
    const bool in_lanes = goes_in_lanes(sum);
    const bool is_only_loop = sum.loops.size() == 1;
    if (sum.loops.empty()) {
        write_body(writer, sum, slopes);
    } else if (in_lanes && is_only_loop) {
        write_lanes(writer, sum, slopes);
    } else {
        const std::string i = names_.index(sum.loops.front().index);
        writer.open("for (Place {0} = from; {0} < to; {1}) {{", i,
                    is_only_loop ? "++" + i : i + " += stride");
        const std::size_t inner = sum.loops.size() - (in_lanes ? 1 : 0);
        for (std::size_t l = 1; l < inner; ++l) { open_loop(writer, sum.loops[l]); }
        if (in_lanes) {
            write_lanes(writer, sum, slopes);
        } else {
            write_body(writer, sum, slopes);
        }
        for (std::size_t l = 0; l < inner; ++l) { writer.close(); }
    }
}

void LoopWriter::call(Writer& writer, const DerivativesOfSum& function, std::string_view arrays) {
    const std::string& name = function.name;
    const SystemSum& sum = *function.sum;
    const std::string arguments = fmt::format("{}{}{}", arrays, function.has_time ? ", t" : "",
                                              function.has_totals ? ", totals" : "");
    if (sum.loops.empty()) {
        writer.line("{}({}, out.data());", name, arguments);
        return;
    }
    const LoopRange& range = sum.loops.front().range;
    const std::string first = names_.whole(range.first);
    const std::string end = names_.whole(range.last + AffineForm{1});
    if (sum.loops.size() == 1) {
        writer.line("{}({}, out.data(), {}, {});", name, arguments, first, end);
        return;
    }
    writer.line("hvi::detail::chunked(team_, {}, {}, out.data(), out.size(), memory_,", first, end);
    writer.open("    [&](Place from, Place to, Place "
                "stride, Scalar* to_out) {{");
    writer.line("{}({}, to_out, from, to, stride);", name, arguments).close("});");
}

void LoopWriter::write(Writer& writer, const ScatteredSums& body) {
    writer.line("std::fill(out.begin(), out.end(), Scalar(0));");
    std::vector<Scaled> slopes;
    for (const DerivativesOfSum& each : body.sums) {
        for (const Scaled& slope : values(*each.slopes)) { slopes.push_back(slope); }
    }
    sum_totals(writer, slopes, body.arrays);
    for (const DerivativesOfSum& each : body.sums) { call(writer, each, body.arrays); }
}

void LoopWriter::sum_totals(Writer& writer, const std::vector<Scaled>& values,
                            std::string_view arrays) const {
    const std::vector<bool> needed = needed_totals(system_, values);
    if (std::find(needed.begin(), needed.end(), true) == needed.end()) { return; }
    writer.line("Scalar totals[{}] = {{}};", needed.size());
    for (std::size_t k = 0; k < needed.size(); ++k) {
        if (!needed[k]) { continue; }
        writer.line("totals[{}] = total_{}({}{}, totals);", k, k + 1, arrays,
                    has_time(system_, k) ? ", t" : "");
    }
}

void LoopWriter::write(Writer& writer, const TotalOfSums& body) {
    writer.line("hvi::detail::CompensatedTotal<Scalar> total;");
    for (const SystemSum& sum : *body.sums) { write_total(writer, sum); }
    writer.line("return total.sum();");
}

void LoopWriter::write(Writer& writer, const ValueOfSums& body) {
    writer.line("if (!fits(q_of, p_of)) {{ return std::numeric_limits<Scalar>::quiet_NaN(); }}");
    for (const char array : {'q', 'p'}) {
        writer.line("[[maybe_unused]] const Scalar* const {0} = {0}_of.data();", array);
    }
    std::vector<Scaled> values;
    for (const SystemSum& sum : *body.sums) { values.push_back(sum.value); }
    sum_totals(writer, values, "q, p");
    write(writer, TotalOfSums{body.sums});
}

void LoopWriter::write(Writer& writer, const EntriesOfSums& body) {
    writer.line("[[maybe_unused]] const Scalar* const q = q_of.data();");
    for (const SumEntries& entries : *body.sums) { write_entries(writer, entries); }
}

void LoopWriter::write_entries(Writer& writer, const SumEntries& entries) {
    std::vector<Scaled> results;
    for (const SumEntry& entry : entries.entries) { results.push_back(entry.value); }
    const Kernel values = kernel(system_.graph, results);
    open_loops(writer, entries.loops);
    const NodeNames given = load(writer, entries.accesses, values, entries.loops);
    const auto texts = write_code(writer, system_.graph, values, given, "hvi::math");
    for (std::size_t k = 0; k < texts.size(); ++k) {
        const SumEntry& entry = entries.entries[k];
        writer.line("out.add({}, {}, Scalar({}));", names_.place(system_.accesses[entry.row]),
                    names_.place(system_.accesses[entry.column]), texts[k]);
    }
    close_loops(writer, entries.loops);
}

void LoopWriter::write_total(Writer& writer, const SystemSum& sum) {
    const bool in_lanes = goes_in_lanes(sum);
    const std::vector<Loop> outer(sum.loops.begin(), sum.loops.end() - (in_lanes ? 1 : 0));
    const Kernel value = kernel(system_.graph, {sum.value});
    open_loops(writer, outer);
    if (!in_lanes) {
        const NodeNames given = load(writer, sum.accesses, value, sum.loops);
        const auto results = write_code(writer, system_.graph, value, given, "hvi::math");
        writer.line("total.add({});", results.front());
    } else {
        const LoopRange& range = sum.loops.back().range;
        const std::size_t width = lanes_for(value);
        writer.line("hvi::detail::Total<Scalar, {}> inner;", width);
        write_along(writer, sum, value,
                    {width, names_.whole(range.first), names_.whole(range.last + AffineForm{1})},
                    [&](const std::vector<std::string>& texts) {
                        writer.line("inner.add(V({}));", texts.front());
                    });
        writer.line("total.add(inner.sum());");
    }
    close_loops(writer, outer);
}

}  // namespace hvi::gen
