// Programs that go to the edges: compiled, started, and ended where they take too long.
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

/// The scene of this name that comes with the program.
[[nodiscard]] Scene edge_scene(const std::string& name);

/// The size of a step that the scene itself asks for.
[[nodiscard]] double usual_step(const Scene& scene);

/// What a program has said.
struct Heard {
    Answers answers;
    std::string failure = {};  ///< why it did not end well, that is to say, a bug; else empty
};

/// What became of the steps of the command `advance`.
struct Advance {
    std::string failure, status;
    long steps = 0;
    bool untouched = false;  ///< the state, by the last step
    double iterations = 0;   ///< a step

    explicit Advance(const Heard& heard);

    [[nodiscard]] bool ok() const { return failure.empty() && status == "ok"; }
    /// Whether it ended early, by a status and with the state of the last good step.
    [[nodiscard]] bool is_stopped() const { return failure.empty() && status != "ok" && untouched; }
    /// Whether it never began.
    [[nodiscard]] bool is_refused() const { return is_stopped() && steps == 0; }
};

class EdgeProgram {
public:
    /// Of src/driver/edge_main.hpp. Throws what scene_stepper() does.
    EdgeProgram(Builds& builds, const ComposedMethod& method, const Scene& scene,
                Solver solver = Solver::automatic);

    /// Of src/driver/edge_symplectic.hpp, in dual numbers.
    [[nodiscard]] static EdgeProgram symplectic(Builds& builds, const ComposedMethod& method,
                                                const Scene& scene);

    /// The same as from a scene, of src/driver/naive.hpp: in place of values of parameters it takes
    /// a tableau.
    [[nodiscard]] static EdgeProgram naive(Builds& builds, const Scene& scene);

    /// Throws what the Build does, EnvironmentError where what it says is no answer, and
    /// Interruption.
    [[nodiscard]] Heard ask(std::vector<std::string> words) const;

    /// With numbers after the command, the steps and their size. The state at the end has as many
    /// as that at the start.
    [[nodiscard]] Heard ask(const std::string& command, double h, long steps,
                            const std::vector<double>& state,
                            const std::vector<double>& values = {}) const;

    /// Whether steps solve nothing.
    [[nodiscard]] bool is_explicit() const { return is_explicit_; }

private:
    EdgeProgram() = default;

    Build build_;
    bool is_explicit_ = false;
};

/// The general Galerkin form does not step every H: why not this one, as a case. Empty where it
/// does, and for other methods.
[[nodiscard]] std::optional<EdgeCheck> refusal_of_general_form(const ExactMethod& method,
                                                               const Scene& scene);

}  // namespace hvi::gen
