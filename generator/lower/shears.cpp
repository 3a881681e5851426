// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/lower/shears.hpp"

namespace hvi::gen {

namespace {

/// Returns sin/(1 + cos), the tangent of half the angle.
Scaled half_tangent(Graph& graph, const Scaled& sine, const Scaled& cosine) {
    return graph.product(sine, graph.inverse(graph.sum({Graph::number(1), cosine})));
}

/// Values of an oscillation over a time, of which both signs were changed where `sign` is -1.
struct Oscillation {
    Scaled sine;  ///< sin(k t)/k, sinh(k t)/k, or t
    Scaled half;  ///< tan(k t/2)/k, tanh(k t/2)/k, or t/2
    Scaled sign;
};

/// Returns sine and tangent of a small angle. NOTE: where these vary, steps wait for them, and
/// neither a cosine nor a quotient stands in their way.
Oscillation small_turn(Graph& graph, TurnAngles& angles, const Scaled& half_angle) {
    const Scaled square = graph.product(half_angle, half_angle);
    angles.conditions.push_back(graph.sum({Graph::number({1, 4}), graph.times({-1, 1}, square)}));
    return {graph.call("sin2<", {half_angle}), graph.call("tan<", {half_angle}), Graph::number(1)};
}

/// Returns them of any angle, or of one up to a quarter turn.
Oscillation any_turn(Graph& graph, TurnAngles& angles, const Scaled& half_angle) {
    const Scaled angle = graph.times({2, 1}, half_angle);
    const Scaled cosine = graph.call("cos", {angle});
    angles.conditions.push_back(cosine);
    const Scaled one = Graph::number(1);
    const Scaled sign = angles.are_small
                            ? one
                            : graph.call("if<", {cosine, Graph::number(0), Graph::number(-1), one});
    const Scaled sine = graph.product(sign, graph.call("sin", {angle}));
    return {sine, half_tangent(graph, sine, graph.product(sign, cosine)), sign};
}

Oscillation bounded(Graph& graph, TurnAngles& angles, const Scaled& frequency,
                    const Scaled& half_time) {
    const Scaled half_angle = graph.product(frequency, half_time);
    const bool is_small = angles.are_small && varies(graph.at(half_angle.node).roles);
    const auto [sine, half, sign] =
        is_small ? small_turn(graph, angles, half_angle) : any_turn(graph, angles, half_angle);
    const Scaled inverse = graph.inverse(frequency);
    return {graph.product(sine, inverse), graph.product(half, inverse), sign};
}

Oscillation unbounded(Graph& graph, const Scaled& rate, const Scaled& half_time) {
    const Scaled angle = graph.times({2, 1}, graph.product(rate, half_time));
    const Scaled sine = graph.product(graph.call("sinh", {angle}), graph.inverse(rate));
    return {sine, half_tangent(graph, sine, graph.call("cosh", {angle})), Graph::number(1)};
}

/// Returns the oscillation for a square of the frequency whose sign parameters decide. NOTE: for a
/// rate k of 1e-15 sin(k t)/k is t to all digits, and all formats have its square.
Oscillation of_any_sign(Graph& graph, TurnAngles& angles, const Scaled& square,
                        const Scaled& half_time) {
    const Scaled least = graph.constant(Expression::decimal("1e-30"));
    const Scaled size = graph.call("max", {graph.call("abs", {square}), least});
    const Scaled rate = graph.half_power(size, 1);
    const Oscillation yes = bounded(graph, angles, rate, half_time),
                      no = unbounded(graph, rate, half_time);
    const auto chosen = [&](const Scaled& positive, const Scaled& negative) {
        return graph.call("if<", {square, Graph::number(0), negative, positive});
    };
    return {chosen(yes.sine, no.sine), chosen(yes.half, no.half), chosen(yes.sign, no.sign)};
}

Oscillation oscillating(Graph& graph, TurnAngles& angles, const Scaled& square,
                        const Scaled& half_time) {
    if (square.is_zero()) { return {graph.times({2, 1}, half_time), half_time, Graph::number(1)}; }
    if (!graph.is_number(square)) { return of_any_sign(graph, angles, square, half_time); }
    if (square.factor.above < 0) {
        return unbounded(graph, graph.half_power(graph.times({-1, 1}, square), 1), half_time);
    }
    return bounded(graph, angles, graph.half_power(square, 1), half_time);
}

}  // namespace

// Two equal shears of x change it by a (y_0 + y_1), where y_1 = y_0 + middle: their product waits
// for one sum less than two products do.
PlaneChange sheared(Graph& graph, const Scaled& x, const Scaled& y, const Shears& shears) {
    const auto& [a, b, c, sign] = shears;
    const Scaled x_0 = graph.product(sign, x), y_0 = graph.product(sign, y);
    const Scaled first = graph.product(a, y_0);
    const Scaled middle = graph.product(b, graph.sum({x_0, first}));
    const Scaled both = a == c ? graph.product(a, graph.sum({graph.times({2, 1}, y_0), middle}))
                               : graph.sum({first, graph.product(c, graph.sum({y_0, middle}))});
    const auto beside = [&](const Scaled& value, const Scaled& start) {
        return graph.sum({value, graph.times({-1, 1}, start)});
    };
    return {graph.sum({beside(x_0, x), both}), graph.sum({beside(y_0, y), middle})};
}

Shears rotation(Graph& graph, TurnAngles& angles, const Scaled& half_angle) {
    const auto [sine, half, sign] = bounded(graph, angles, Graph::number(1), half_angle);
    return {half, graph.times({-1, 1}, sine), half, sign};
}

// With w^2 = a b - c^2, S = sin(w t)/w and C = cos(w t) the flow is q' = (C + c S) q + b S p, p' =
// (C - c S) p - a S q. So the shear of q is b S, and those of p are (C - 1 +- c S)/(b S). With (C -
// 1)/S = -w^2 T for T = S/(1 + C) they are -a T + c (c T +- 1)/b: without c any b will do.
Shears oscillation(Graph& graph, TurnAngles& angles, const PlaneForm& form,
                   const Scaled& half_time) {
    const Scaled &a = form.a, &b = form.b, &c = form.c;
    const Scaled square =
        graph.sum({graph.product(a, b), graph.times({-1, 1}, graph.product(c, c))});
    const Oscillation at = oscillating(graph, angles, square, half_time);
    const auto shear_of_p = [&](long side) {
        const Scaled slant =
            graph.product(c, graph.sum({graph.product(c, at.half), Graph::number(side)}));
        return graph.sum({graph.times({-1, 1}, graph.product(a, at.half)),
                          graph.product(slant, graph.inverse(b))});
    };
    return {shear_of_p(1), graph.product(b, at.sine), shear_of_p(-1), at.sign};
}

}  // namespace hvi::gen
