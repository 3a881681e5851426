// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/emit/system/site_writer.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>

namespace hvi::gen {

namespace {

std::string joined(const std::vector<std::string>& texts) {
    return fmt::format("{}", fmt::join(texts, ", "));
}

}  // namespace

void write_site_types(Writer& writer, const Sites& sites) {
    writer.line("static constexpr std::size_t dimension = {};  // indices of a site",
                sites.ranges.size());
    writer.line("static constexpr std::size_t components = {};", sites.forces.size());
    writer.line("using Site = hvi::detail::Site<dimension>;");
    writer.line("static constexpr Site reach = {{{{{}}}}};", fmt::join(sites.reach, ", "));
}

void SiteWriter::write(Writer& writer, const SiteRanges& /*body*/) {
    std::vector<std::string> first, end, inside_first, inside_end;
    const auto extreme = [&](std::string_view which, const std::vector<AffineForm>& forms,
                             const AffineForm& more) {
        std::vector<std::string> texts;
        for (const AffineForm& form : forms) { texts.push_back(names_.whole(form + more)); }
        return texts.size() == 1 ? texts.front()
                                 : fmt::format("std::{}<Place>({{{}}})", which, joined(texts));
    };
    const AffineForm one{1};
    for (std::size_t d = 0; d < sites_.ranges.size(); ++d) {
        const LoopRange& range = sites_.ranges[d];
        first.push_back(names_.whole(range.first));
        end.push_back(fmt::format("std::max<Place>({}, {})", names_.whole(range.first),
                                  names_.whole(range.last + one)));
        inside_first.push_back(extreme("max", sites_.inside[d].firsts, {}));
        inside_end.push_back(extreme("min", sites_.inside[d].lasts, one));
    }
    writer.line("return {{{{{{{{{}}}}}, {{{{{}}}}}}},", joined(first), joined(end));
    writer.line("        {{{{{{{}}}}}, {{{{{}}}}}}}}};", joined(inside_first), joined(inside_end));
}

/// Returns the place of an element that a site reads, relative to the number e of the site.
std::string SiteWriter::place(const SiteAccess& seen) const {
    const System& system = loops_.system();
    const SystemFamily& family = system.family({seen.kind, seen.family});
    const std::string name = member_of(family.name);
    const std::size_t d = family.ranges.size();
    if (seen.kind != FamilyKind::table) {
        std::string text = seen.family == 0 ? "e" : fmt::format("{} * count_ + e", seen.family);
        for (std::size_t i = 0; i < d; ++i) {
            const long offset = seen.offset[i].constant;
            if (offset == 0) { continue; }
            const long size = std::labs(offset);
            const std::string step = i + 1 == d ? std::to_string(size)
                                     : size == 1
                                         ? fmt::format("{}_step_{}_", name, i + 1)
                                         : fmt::format("{} * {}_step_{}_", size, name, i + 1);
            text += (offset < 0 ? " - " : " + ") + step;
        }
        return text;
    }
    std::vector<std::string> indices;
    for (std::size_t i = 0; i < d; ++i) {
        const std::string offset = names_.whole(seen.offset[i]);
        indices.push_back(seen.of[i] ? fmt::format("(k[{}] + {})", *seen.of[i], offset)
                                     : "(" + offset + ")");
    }
    return ClassNames::place(family, indices);
}

/// Loads the elements that forces or velocities read.
NodeNames SiteWriter::locals(Writer& writer, const Kernel& kernel) {
    const std::size_t last = sites_.ranges.size() - 1;
    NodeNames names;
    std::size_t count = 0;
    for (const SiteAccess& seen : sites_.accesses) {
        if (seen.node >= kernel.uses.size() || kernel.uses[seen.node] == 0) { continue; }
        if (seen.kind == FamilyKind::conjugate) {
            names[seen.node] = fmt::format("p[{}]", seen.family);
            continue;
        }
        const Access access{seen.kind, seen.family};
        const bool moves = std::find(seen.of.begin(), seen.of.end(), last) != seen.of.end();
        names[seen.node] = fmt::format("a{}", ++count);
        if (moves) {
            writer.line("const V a{} = hvi::detail::Stretch<V>::load({} + ({}));", count,
                        names_.array(access), place(seen));
        } else {
            writer.line("const Scalar a{} = {}[{}];", count, names_.array(access), place(seen));
        }
    }
    for (std::size_t d = 0; d < sites_.indices.size(); ++d) {
        names[sites_.indices[d]] = d == last
                                       ? fmt::format("hvi::detail::Stretch<V>::indices(k[{}])", d)
                                       : fmt::format("static_cast<Scalar>(k[{}])", d);
    }
    return names_.given(kernel, names);
}

void SiteWriter::write(Writer& writer, const ValuesOfSites& body) {
    const Graph& graph = loops_.system().graph;
    const Kernel values = kernel(graph, *body.values);
    const NodeNames names = locals(writer, values);
    const auto results = write_code(writer, graph, values, names, "hvi::math", "V");
    for (std::size_t c = 0; c < results.size(); ++c) {
        writer.line("out[{}] = V({});", c, results[c]);
    }
}

void SiteWriter::write_edge_term(Writer& writer, const SiteTerm& term) {
    const System& system = loops_.system();
    const SystemSum& sum = system.sums[term.sum];
    std::vector<std::string> conditions;
    writer.open("{{");
    for (std::size_t d = 0; d < term.indices.size(); ++d) {
        const SiteIndex& index = term.indices[d];
        const std::string shift = names_.whole(index.shift);
        if (!index.loop) {
            conditions.push_back(fmt::format("k[{}] == {}", d, shift));
            continue;
        }
        const Loop& loop = sum.loops[*index.loop];
        const std::string i = names_.index(loop.index);
        const std::string first = names_.whole(loop.range.first);
        const std::string last = names_.whole(loop.range.last);
        if (index.wraps) {
            const AffineForm length = loop.range.last - loop.range.first + AffineForm{1};
            writer.line("[[maybe_unused]] const Place {} = {} + hvi::detail::remainder(k[{}] - "
                        "({}) - ({}), {});",
                        i, first, d, shift, first, names_.whole(length));
        } else {
            writer.line("const Place {} = k[{}] - ({});", i, d, shift);
            conditions.push_back(fmt::format("{} <= {} && {} <= {}", first, i, i, last));
        }
    }
    if (!conditions.empty()) { writer.open("if ({}) {{", fmt::join(conditions, " && ")); }
    const Kernel slope = kernel(system.graph, {term.slope.value});
    const NodeNames given = loops_.load(writer, sum.accesses, slope, sum.loops);
    const auto results = write_code(writer, system.graph, slope, given, "hvi::math");
    writer.line("out[{}] += {};", term.component, results.front());
    if (!conditions.empty()) { writer.close(); }
    writer.close();
}

void SiteWriter::write(Writer& writer, const ForceAtEdge& /*body*/) {
    writer.line("for (Scalar& each : out) {{ each = 0; }}");
    for (const SiteTerm& term : sites_.terms) { write_edge_term(writer, term); }
}

}  // namespace hvi::gen
