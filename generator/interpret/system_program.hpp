// The class System of a stepper, evaluated without a compiler.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "generator/emit/system/scene_code.hpp"
#include "generator/interpret/tape.hpp"
#include "generator/ir/step.hpp"
#include "generator/ir/system.hpp"
#include "generator/plan/evaluations.hpp"

namespace hvi::gen {

/// Functions of the class as tapes on one row of numbers. Its parameters are data.
class SystemProgram {
public:
    /// Makes the tapes. Precondition: the system is written out, without functions of the user's
    /// own.
    SystemProgram(const System& system, const SceneWishes& wishes, const Step& step,
                  const Evaluations& evaluations);

    /// Returns the function with that name, whose results are components; null where there is none.
    [[nodiscard]] const Tape* function(const std::string& name) const {
        const auto found = functions_.find(name);
        return found == functions_.end() ? nullptr : &found->second;
    }
    [[nodiscard]] std::size_t coordinates() const { return q_.size(); }
    [[nodiscard]] std::size_t momenta() const { return p_.size(); }
    [[nodiscard]] bool has_time() const { return time_.has_value(); }
    /// Returns the names of functions that compute values of states, in their order: the energy,
    /// then the invariants.
    [[nodiscard]] const std::vector<std::string>& values() const { return values_; }

private:
    friend class InterpretedSystem;

    std::vector<double> numbers_;  ///< the initial row
    std::vector<Slot> q_, p_, parameters_;
    std::optional<Slot> time_;
    std::map<std::string, Tape> functions_;
    std::vector<std::string> values_;
    std::optional<Tape> constants_;  ///< computes `members_`, which depend on parameters alone
    std::vector<Slot> members_;
};

/// A System with its parameters. Functions that a step calls have their names in C++.
class InterpretedSystem {
public:
    using Vector = std::vector<double>;

    /// Precondition: the program lives longer, and there are as many parameters as it has.
    InterpretedSystem(const SystemProgram& program, const std::vector<double>& parameters);

    [[nodiscard]] const SystemProgram& program() const { return *program_; }

    /// Point at which functions are evaluated. Vectors that a function does not read may be null.
    struct Point {
        const Vector* q = nullptr;
        const Vector* p = nullptr;
        double t = 0;
    };

    void dHdq(const Point& at, Vector& out) const {
        ++evaluations_;
        evaluate(*by_q_, at, out);
    }
    void dHdp(const Point& at, Vector& out) const { evaluate(*by_p_, at, out); }
    void dHdp(const Vector& p, Vector& out) const { dHdp({.p = &p}, out); }

    /// Evaluates both gradients at once.
    void gradient(const Point& at, Vector& by_q, Vector& by_p) const;

    /// Sets out to d2H/dp2 v, where d2H/dp2 is constant.
    void inverse_mass(const Vector& v, Vector& out) const {
        evaluate(*inverse_mass_, {.p = &v}, out);
    }

    /// Returns a value of a state.
    [[nodiscard]] double value(const std::string& function, const Point& at) const;

    /// Sets q and p to the initial state of the scene.
    void begin(Vector& q, Vector& p) const;

    /// Returns the number of evaluations of dH/dq.
    [[nodiscard]] std::int64_t evaluations() const { return evaluations_; }

private:
    void run(const Tape& function, const Point& at) const;
    void evaluate(const Tape& function, const Point& at, Vector& out) const;
    void put(const std::vector<Slot>& slots, const Vector& values) const;

    const SystemProgram* program_;
    const Tape* by_q_;
    const Tape* by_p_;
    const Tape* gradient_;
    const Tape* inverse_mass_;
    mutable std::vector<double> numbers_;
    mutable std::int64_t evaluations_ = 0;
};

}  // namespace hvi::gen
