// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/interpret/system_program.hpp"

#include <algorithm>
#include <set>
#include <utility>
#include <variant>

#include "generator/emit/system/class_functions.hpp"
#include "generator/emit/system/class_values.hpp"
#include "generator/support/error.hpp"

namespace hvi::gen {

namespace {

std::vector<Slot> slots_of(Slots& slots, const std::vector<Node>& nodes) {
    std::vector<Slot> result;
    for (const Node node : nodes) result.push_back(slots.of(node));
    return result;
}

/// Values that depend on parameters alone, which functions are given: members of the class that its
/// constructor computes.
class Members {
public:
    explicit Members(const System& system) : graph_(system.graph) {
        for (const std::vector<Node>& nodes : {coordinate_nodes(system), conjugate_nodes(system)})
            variables_.insert(nodes.begin(), nodes.end());
        if (system.time) variables_.insert(*system.time);
    }

    void add(const StraightCode& code) {
        if (code.has_parameters) return;
        for (const Node node : code.kernel.given) {
            const bool is_local = variables_.count(node) != 0 || code.names.count(node) != 0;
            const bool is_constant = graph_.at(node).operation == Operation::constant;
            if (is_local || is_constant || !known_.insert(node).second) continue;
            nodes_.push_back(node);
        }
    }

    [[nodiscard]] const std::vector<Node>& nodes() const { return nodes_; }

    /// Returns the kernel that computes them, as the constructor does.
    [[nodiscard]] Kernel kernel() const {
        std::vector<Scaled> results;
        for (const Node node : nodes_) results.push_back({{1, 1}, node});
        return kernel_of_inputs(graph_, std::move(results));
    }

private:
    const Graph& graph_;
    std::set<Node> variables_, known_;
    std::vector<Node> nodes_;
};

}  // namespace

SystemProgram::SystemProgram(const System& system, const SceneWishes& wishes, const Step& step,
                             const Evaluations& evaluations) {
    Slots slots(system.graph);
    q_ = slots_of(slots, coordinate_nodes(system));
    p_ = slots_of(slots, conjugate_nodes(system));
    if (system.time) time_ = slots.of(*system.time);
    for (const SystemParameter& parameter : system.parameters)
        parameters_.push_back(slots.of(parameter.node));
    for (const ClassValue& value : values_of_class(system, wishes)) values_.push_back(value.name);
    Members members(system);
    for (const SystemFunction& function : functions_of_class(system, wishes, step, &evaluations)) {
        const auto* code = std::get_if<StraightCode>(&function.body);
        if (code == nullptr) continue;
        members.add(*code);
        // NOTE: of functions with one name, steps without lanes call the first.
        functions_.try_emplace(function.name, code->kernel, slots);
    }
    members_ = slots_of(slots, members.nodes());
    constants_.emplace(members.kernel(), slots);
    numbers_ = slots.numbers();
}

InterpretedSystem::InterpretedSystem(const SystemProgram& program,
                                     const std::vector<double>& parameters)
    : program_(&program),
      by_q_(program.function("dHdq")),
      by_p_(program.function("dHdp")),
      gradient_(program.function("gradient")),
      inverse_mass_(program.function("inverse_mass")),
      numbers_(program.numbers_) {
    HVI_CHECK(parameters.size() == program.parameters_.size());
    put(program.parameters_, parameters);
    program.constants_->run(numbers_.data());
    const std::vector<Slot>& results = program.constants_->results();
    for (std::size_t k = 0; k < results.size(); ++k)
        numbers_[program.members_[k]] = numbers_[results[k]];
}

void InterpretedSystem::put(const std::vector<Slot>& slots, const Vector& values) const {
    for (std::size_t k = 0; k < slots.size(); ++k) numbers_[slots[k]] = values[k];
}

void InterpretedSystem::run(const Tape& function, const Point& at) const {
    if (at.q != nullptr) put(program_->q_, *at.q);
    if (at.p != nullptr) put(program_->p_, *at.p);
    if (program_->time_) numbers_[*program_->time_] = at.t;
    function.run(numbers_.data());
}

void InterpretedSystem::evaluate(const Tape& function, const Point& at, Vector& out) const {
    run(function, at);
    const std::vector<Slot>& results = function.results();
    for (std::size_t k = 0; k < results.size(); ++k) out[k] = numbers_[results[k]];
}

void InterpretedSystem::gradient(const Point& at, Vector& by_q, Vector& by_p) const {
    ++evaluations_;
    run(*gradient_, at);
    const std::vector<Slot>& results = gradient_->results();
    const std::size_t n = by_q.size();
    for (std::size_t k = 0; k < n; ++k) {
        by_q[k] = numbers_[results[k]];
        by_p[k] = numbers_[results[n + k]];
    }
}

double InterpretedSystem::value(const std::string& function, const Point& at) const {
    Vector out(1);
    evaluate(*program_->function(function), at, out);
    return out.front();
}

void InterpretedSystem::begin(Vector& q, Vector& p) const {
    const std::size_t n = program_->q_.size();
    Vector all(n + program_->p_.size());
    evaluate(*program_->function("begin"), {}, all);
    q.assign(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(n));
    p.assign(all.begin() + static_cast<std::ptrdiff_t>(n), all.end());
}

}  // namespace hvi::gen
