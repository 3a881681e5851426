// H scaled to the ends of the range of double.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>

#include <cmath>

#include "generator/edges/extreme.hpp"
#include "generator/edges/forms.hpp"

namespace hvi::gen {

namespace {

/// A scene whose first parameter is `scale`.
struct ScaledScene {
    std::string text;
    std::vector<double> start;
    bool in_all_forms;  ///< else in the form without wishes only
};

const std::vector<ScaledScene>& scaled_scenes() {
    static const std::vector<ScaledScene> scenes{{R"toml(name = "scaled-kepler"
coordinates = ["x", "y"]
momenta = ["px", "py"]
hamiltonian = "scale*((px^2 + py^2)/2 - 1/sqrt(x^2 + y^2))"
[parameters]
scale = 1
[initial]
x = 1
y = 0
px = 0
py = 1
)toml",
                                                  {0.4, 0, 0, 2},
                                                  true},
                                                 {R"toml(name = "scaled-oscillator"
coordinates = "q"
momenta = "p"
hamiltonian = "scale*(p^2 + 3*q^2)/2"
[parameters]
scale = 1
[initial]
q = 1
p = 0
)toml",
                                                  {1, 0.5},
                                                  false},
                                                 {R"toml(name = "scaled-nonseparable"
coordinates = "q"
momenta = "p"
hamiltonian = "scale*(p^2 + 1)*(q^2 + 1)/2"
[parameters]
scale = 1
[initial]
q = 0
p = 1
)toml",
                                                  {0, 1},
                                                  false}};
    return scenes;
}

/// Checks that the runs with and without a scale end alike, bit for bit.
EdgeCheck check(const std::string& method, const std::string& scene, const Form& form,
                const std::vector<double>& start, int exponent) {
    constexpr double h = 0.0625;
    constexpr long steps = 100;
    const double scale = std::ldexp(1, exponent);
    const Heard plain = form.program.ask("advance", h, steps, start, {1}),
                scaled = form.program.ask("advance", h / scale, steps, start, {scale});
    EdgeCheck check{method,
                    scene,
                    fmt::format("{}: H times 2^{}, h by it", form.name, exponent),
                    fmt::format("ok, the bits of {} steps with H", steps),
                    end_text(scaled),
                    false};
    if (!plain.failure.empty() || plain.answers.text("status") != "ok") {
        check.seen += "; with H: " + end_text(plain);
    } else if (check.seen == "ok") {
        check.agrees = plain.answers.numbers("end") == scaled.answers.numbers("end");
        check.seen += check.agrees ? ", the same bits" : ", other bits";
    }
    return check;
}

}  // namespace

std::vector<std::vector<Form>> scaled_forms(Builds& builds, const ExactMethod& method) {
    std::vector<std::vector<Form>> all;
    for (const ScaledScene& scaled : scaled_scenes()) {
        const Scene scene = scene_of(scaled.text);
        if (refusal_of_general_form(method, scene))
            all.emplace_back();
        else
            all.push_back(scaled.in_all_forms
                              ? forms(builds, method, scene)
                              : std::vector<Form>{{"as is", Solver::automatic,
                                                   EdgeProgram(builds, method, scene)}});
    }
    return all;
}

// NOTE: 2^498 is 8.2e149. The scale and the step are powers of two, so that no product is rounded
// differently with them. The scale 2^900 shows squares of such numbers, which are out of range.
void add_scaled(const ExtremeMethod& method, EdgeChapter& chapter) {
    auto forms = method.scaled.begin();
    for (const ScaledScene& scaled : scaled_scenes()) {
        const Scene scene = scene_of(scaled.text);
        for (const Form& form : *forms++)
            for (const int exponent : {-900, -498, 498, 900})
                chapter.checks.push_back(
                    check(method.name, scene.name, form, scaled.start, exponent));
    }
}

}  // namespace hvi::gen
