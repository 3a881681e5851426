// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/exact/methods/composed_method.hpp"

#include <algorithm>
#include <utility>
#include <variant>

#include "generator/exact/methods/properties.hpp"
#include "generator/exact/methods/rule_properties.hpp"

namespace hvi::gen {

namespace {

std::shared_ptr<const Source> part(const Source& source, std::size_t begin, std::size_t end) {
    return std::make_shared<const Source>(
        Source{source.name, source.text.substr(begin, end - begin)});
}

bool is_method(const std::shared_ptr<const Source>& name) {
    try {
        static_cast<void>(named_method(name));
        return true;
    } catch (const Error&) { return false; }
}

/// Returns where the name of a composition begins, behind a dash; the end where there is none. Any
/// text behind the name of a method is taken for a composition.
std::size_t begin_of_composition(const Source& source) {
    const std::string& text = source.text;
    for (const std::string_view name : composition_names()) {
        const std::string suffix = "-" + std::string(name);
        if (text.size() > suffix.size() && text.ends_with(suffix)) return text.size() - name.size();
    }
    if (is_method(part(source, 0, text.size()))) return text.size();
    for (std::size_t dash = text.rfind('-'); dash != std::string::npos && dash > 0;
         dash = text.rfind('-', dash - 1))
        if (is_method(part(source, 0, dash))) return dash + 1;
    return text.size();
}

/// Returns the stages of the adjoint, a step of size -h solved for its start. Its tableau has
/// b_s+1-i and b_s+1-j - a_s+1-i,s+1-j (Hairer, Lubich & Wanner, Geometric Numerical Integration,
/// Theorem V.1.5).
WeightedStages adjoint(const WeightedStages& stages) {
    const std::size_t s = stages.b.size();
    WeightedStages result{NumberMatrix(s), {stages.b.rbegin(), stages.b.rend()}};
    for (std::size_t i = 0; i < s; ++i) {
        for (std::size_t j = 0; j < s; ++j) {
            result.m[i].push_back(Number(1) - stages.m[s - 1 - i][s - 1 - j]);
        }
    }
    return result;
}

}  // namespace

ComposedMethod composed_method(const std::shared_ptr<const Source>& name) {
    const std::size_t begin = begin_of_composition(*name), end = name->text.size();
    if (begin == end) return {named_method(name)};
    ComposedMethod result{named_method(part(*name, 0, begin - 1)),
                          named_composition(part(*name, begin, end))};
    result.composition->place = whole(name);
    return result;
}

ExactMethod exact_method(ComposedMethod method) {
    DerivedMethod base = derive_any(method.method);
    if (method.composition) check_composition(*method.composition, base);
    return {std::move(method), std::move(base)};
}

int composed_order(int of_method, const std::optional<Composition>& composition) {
    if (!composition) return of_method;
    const int least = std::max(of_method, composition->order);
    return least + least % 2;
}

bool is_symmetric(const ExactMethod& method) {
    const auto comes_back = [](const auto& derived) { return is_symmetric(derived).holds; };
    return method.composition || std::visit(comes_back, method.base);
}

WeightedStages weighted_stages(const ButcherPair& pair) {
    WeightedStages stages{pair.A, pair.b};
    for (NumberVector& row : stages.m) {
        for (std::size_t j = 0; j < row.size(); ++j) { row[j] = row[j] / pair.b[j]; }
    }
    return stages;
}

// The stages of each step follow the slopes of all earlier steps, weighted gamma_k b.
WeightedStages composed(const WeightedStages& method, const Composition& composition) {
    const WeightedStages partner = composition.with_adjoint ? adjoint(method) : method;
    const std::size_t s = method.b.size(), k = composition.steps.size();
    WeightedStages result;
    for (std::size_t step = 0; step < k; ++step) {
        const WeightedStages& own = step % 2 == 0 ? method : partner;
        for (std::size_t i = 0; i < s; ++i) {
            result.b.push_back(composition.steps[step] * own.b[i]);
            NumberVector row(step * s, Number(1));
            row.insert(row.end(), own.m[i].begin(), own.m[i].end());
            row.resize(k * s, Number(0));
            result.m.push_back(std::move(row));
        }
    }
    return result;
}

// a_ij = b_j m_ij and a~_ij = b_j (1 - m_ji)
PartitionedMethod partitioned_method(const WeightedStages& stages) {
    const auto& [m, b] = stages;
    PartitionedMethod result{b, b, m, m};
    for (std::size_t i = 0; i < b.size(); ++i) {
        for (std::size_t j = 0; j < b.size(); ++j) {
            result.A[i][j] = m[i][j] * b[j];
            result.A_tilde[i][j] = b[j] * (Number(1) - m[j][i]);
        }
    }
    return result;
}

}  // namespace hvi::gen
