// Scenes to be read, and to be refused when they are edited.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "generator/read/scene_times.hpp"
#include "generator/read/written_out_scene.hpp"
#include "tests/generator/read/refusal.hpp"

namespace hvi::gen {

using Names = std::vector<std::string>;

/// A scene with all sections, whose lines the tests count.
inline const std::string planet = R"toml(name = "planet"
coordinates = ["x", "y"]
momenta = "px, py"
hamiltonian = "(px^2 + py^2)/2 - mu/sqrt(x^2 + y^2)"
[parameters]
mu = 1
ecc = "3/5"
[invariants]
angular = "x*py - y*px"
[initial]
x = "1 - ecc"
y = 0
px = 0
py = "sqrt(mu*(1 + ecc)/(1 - ecc))"
[run]
method = "gauss:4"
step = "1/20"
until = 200
)toml";

/// A scene of three bodies.
inline const std::string bodies = R"toml(coordinates = "x[1..3]"
momenta = ["p[1..3]"]
hamiltonian = "sum(i=1..3, p[i]^2/(2*m[i])) + x[1]*x[2]"
[parameters]
m = [1, "1/1000", 0.25]
[initial]
x = [1, 2, "-3"]
p = [0, 0, "m[2]"]
)toml";

/// The text with another part in place of one.
inline std::string edited(std::string text, const std::string& part, const std::string& other) {
    const std::size_t at = text.find(part);
    REQUIRE(at != std::string::npos);
    return text.replace(at, part.size(), other);
}

inline Scene written(const std::string& text) { return scene_from_toml({"s.toml", text}); }

inline WrittenOutScene read(const std::string& text) { return unrolled(written(text)); }

inline Refusal refused(const std::string& text) {
    return refusal([&] {
        const Scene scene = written(text);
        WrittenOutScene result = unrolled(scene);
        static_cast<void>(times_of(scene));
        return result;
    });
}

inline Refusal refused(const std::string& text, const std::string& part, const std::string& other) {
    return refused(edited(text, part, other));
}

inline Names names(const std::vector<Parameter>& parameters) {
    Names result;
    for (const Parameter& parameter : parameters) result.push_back(parameter.name);
    return result;
}

/// `x = 1` for each.
inline Names lines(const std::vector<NamedExpression>& values) {
    Names result;
    for (const NamedExpression& value : values)
        result.push_back(value.name + " = " + to_text(value.expression));
    return result;
}

inline WrittenOutScene embedded(const std::string& name) {
    return unrolled(find_scene(source(name, "SCENE")));
}

}  // namespace hvi::gen
