// Programs for edge cases: compiled, started, and ended where they take too long.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "generator/edges/edges.hpp"
#include "generator/exact/methods/composed_method.hpp"
#include "generator/pipeline/stepper.hpp"
#include "generator/program/builds.hpp"
#include "generator/simulate/answers.hpp"

namespace hvi::gen {

/// Returns the scene of this name that comes with the program.
[[nodiscard]] Scene edge_scene(const std::string& name);

/// Returns the scene's own step size.
[[nodiscard]] double usual_step(const Scene& scene);

/// The output of a program.
struct Heard {
    Answers answers;
    std::string failure = {};  ///< why it did not end well, which is a bug; else empty
};

/// The outcome of the command `advance`.
struct Advance {
    std::string failure, status;
    long steps = 0;
    bool untouched = false;  ///< whether the last step left the state untouched
    double iterations = 0;   ///< iterations a step

    explicit Advance(const Heard& heard);

    [[nodiscard]] bool ok() const { return failure.empty() && status == "ok"; }
    /// Whether the run ended early, with a status and the state of the last good step.
    [[nodiscard]] bool is_stopped() const { return failure.empty() && status != "ok" && untouched; }
    /// Whether the run never began.
    [[nodiscard]] bool is_refused() const { return is_stopped() && steps == 0; }
};

class EdgeProgram {
public:
    /// Makes the program of src/driver/edge_main.hpp. Throws as scene_stepper() does.
    EdgeProgram(Builds& builds, const ComposedMethod& method, const Scene& scene,
                Solver solver = Solver::automatic);

    /// Makes the program of src/driver/edge_symplectic.hpp, in dual numbers.
    [[nodiscard]] static EdgeProgram symplectic(Builds& builds, const ComposedMethod& method,
                                                const Scene& scene);

    /// Makes the program of src/driver/naive.hpp for a scene. It takes a tableau in place of values
    /// of parameters.
    [[nodiscard]] static EdgeProgram naive(Builds& builds, const Scene& scene);

    /// Runs the program. Throws as the Build does, EnvironmentError where its output is no answer,
    /// and Interruption.
    [[nodiscard]] Heard ask(std::vector<std::string> words) const;

    /// Runs a command with the step size, the number of steps and numbers. The state at the end has
    /// as many numbers as the one at the start.
    [[nodiscard]] Heard ask(const std::string& command, double h, long steps,
                            const std::vector<double>& state,
                            const std::vector<double>& values = {}) const;

    /// Whether steps are explicit.
    [[nodiscard]] bool is_explicit() const { return is_explicit_; }

private:
    EdgeProgram() = default;

    Build build_;
    bool is_explicit_ = false;
};

/// Returns a case that says why the general Galerkin form does not step this H. Empty where it
/// does, and for other methods.
[[nodiscard]] std::optional<EdgeCheck> refusal_of_general_form(const ExactMethod& method,
                                                               const Scene& scene);

}  // namespace hvi::gen
