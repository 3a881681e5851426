// Straight-line code that is evaluated without a compiler.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <vector>

#include "generator/graph/graph.hpp"
#include "generator/lower/kernel.hpp"

namespace hvi::gen {

/// A place in a row of numbers.
using Slot = std::uint32_t;

/// Slots in a row of numbers: of nodes of a graph, of constants, and of intermediate results.
class Slots {
public:
    explicit Slots(const Graph& graph) : graph_(&graph) {}

    [[nodiscard]] const Graph& graph() const { return *graph_; }

    /// Returns a new slot.
    [[nodiscard]] Slot next() { return add(0); }

    /// Returns the slot of a constant.
    [[nodiscard]] Slot of(double constant);

    /// Returns the slot of a node, for all code that is given the node. The slot of a constant has
    /// its value.
    [[nodiscard]] Slot of(Node node);

    /// Returns the row: constants in their slots, zeros in the others.
    [[nodiscard]] const std::vector<double>& numbers() const { return numbers_; }

private:
    Slot add(double number);

    const Graph* graph_;
    std::vector<double> numbers_;
    std::map<std::uint64_t, Slot> constants_;  ///< by the bits of the constant
    std::map<Node, Slot> nodes_;
};

/// A kernel for a row of numbers: the operations of the C++ that write_code() writes, in their
/// order, so that both compute the same bits where a compiler fuses no product with a sum.
class Tape {
public:
    /// Makes a tape that takes the kernel's given values from the slots of their nodes.
    /// Precondition: no function of the user's own is called.
    Tape(const Kernel& kernel, Slots& slots);

    void run(double* numbers) const;

    /// Returns the slots of the results, after run().
    [[nodiscard]] const std::vector<Slot>& results() const { return results_; }

private:
    friend class TapeWriter;

    enum class Act : std::uint8_t { add, subtract, multiply, divide, negate, root, call };
    using Function = double (*)(const std::array<double, 4>& arguments);

    /// An instruction out = a act b. In a call `b` is the place of the function in the list.
    struct Instruction {
        Act act;
        Slot out, a, b;
    };
    struct Call {
        Function function;
        std::array<Slot, 4> arguments;
    };

    std::vector<Instruction> instructions_;
    std::vector<Call> calls_;
    std::vector<Slot> results_;
};

}  // namespace hvi::gen
