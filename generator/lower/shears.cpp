// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/lower/shears.hpp"

namespace hvi::gen {

namespace {

/// Returns -1 where the cosine is negative, else 1.
Scaled sign_of(Graph& graph, TurnSigns& signs, const Scaled& cosine) {
    signs.cosines.push_back(cosine);
    if (signs.are_ones) { return Graph::number(1); }
    return graph.call("if<", {cosine, Graph::number(0), Graph::number(-1), Graph::number(1)});
}

/// Returns sin/(1 + cos), the tangent of half the angle.
Scaled half_tangent(Graph& graph, const Scaled& sine, const Scaled& cosine) {
    return graph.product(sine, graph.inverse(graph.sum({Graph::number(1), cosine})));
}

/// Values of an oscillation over a time, of which both signs were changed where `sign` is -1.
struct Oscillation {
    Scaled sine;  ///< sin(k t)/k, sinh(k t)/k, or t
    Scaled cosine;
    Scaled sign;
};

Oscillation bounded(Graph& graph, TurnSigns& signs, const Scaled& frequency, const Scaled& time) {
    const Scaled angle = graph.product(frequency, time);
    const Scaled cosine = graph.call("cos", {angle});
    const Scaled sign = sign_of(graph, signs, cosine);
    const Scaled sine = graph.product(graph.call("sin", {angle}), graph.inverse(frequency));
    return {graph.product(sign, sine), graph.product(sign, cosine), sign};
}

Oscillation unbounded(Graph& graph, const Scaled& rate, const Scaled& time) {
    const Scaled angle = graph.product(rate, time);
    const Scaled sine = graph.product(graph.call("sinh", {angle}), graph.inverse(rate));
    return {sine, graph.call("cosh", {angle}), Graph::number(1)};
}

/// Returns the oscillation for a square of the frequency whose sign parameters decide. NOTE: for a
/// rate k of 1e-15 sin(k t)/k is t to all digits, and all formats have its square.
Oscillation of_any_sign(Graph& graph, TurnSigns& signs, const Scaled& square, const Scaled& time) {
    const Scaled least = graph.constant(Expression::decimal("1e-30"));
    const Scaled size = graph.call("max", {graph.call("abs", {square}), least});
    const Scaled rate = graph.half_power(size, 1);
    const Oscillation yes = bounded(graph, signs, rate, time), no = unbounded(graph, rate, time);
    const auto chosen = [&](const Scaled& positive, const Scaled& negative) {
        return graph.call("if<", {square, Graph::number(0), negative, positive});
    };
    return {chosen(yes.sine, no.sine), chosen(yes.cosine, no.cosine), chosen(yes.sign, no.sign)};
}

Oscillation oscillating(Graph& graph, TurnSigns& signs, const Scaled& square, const Scaled& time) {
    if (square.is_zero()) { return {time, Graph::number(1), Graph::number(1)}; }
    if (!graph.is_number(square)) { return of_any_sign(graph, signs, square, time); }
    if (square.factor.above < 0) {
        return unbounded(graph, graph.half_power(graph.times({-1, 1}, square), 1), time);
    }
    return bounded(graph, signs, graph.half_power(square, 1), time);
}

}  // namespace

PlaneChange sheared(Graph& graph, const Scaled& x, const Scaled& y, const Shears& shears) {
    const auto& [a, b, c, sign] = shears;
    const Scaled x_0 = graph.product(sign, x), y_0 = graph.product(sign, y);
    const Scaled first = graph.product(a, y_0);
    const Scaled middle = graph.product(b, graph.sum({x_0, first}));
    const Scaled last = graph.product(c, graph.sum({y_0, middle}));
    const auto beside = [&](const Scaled& value, const Scaled& start) {
        return graph.sum({value, graph.times({-1, 1}, start)});
    };
    return {graph.sum({beside(x_0, x), first, last}), graph.sum({beside(y_0, y), middle})};
}

Shears rotation(Graph& graph, TurnSigns& signs, const Scaled& angle) {
    const auto [sine, cosine, sign] = bounded(graph, signs, Graph::number(1), angle);
    const Scaled half = half_tangent(graph, sine, cosine);
    return {half, graph.times({-1, 1}, sine), half, sign};
}

// With w^2 = a b - c^2, S = sin(w t)/w and C = cos(w t) the flow is q' = (C + c S) q + b S p, p' =
// (C - c S) p - a S q. So the shear of q is b S, and those of p are (C - 1 +- c S)/(b S). With (C -
// 1)/S = -w^2 T for T = S/(1 + C) they are -a T + c (c T +- 1)/b: without c any b will do.
Shears oscillation(Graph& graph, TurnSigns& signs, const PlaneForm& form, const Scaled& time) {
    const Scaled &a = form.a, &b = form.b, &c = form.c;
    const Scaled square =
        graph.sum({graph.product(a, b), graph.times({-1, 1}, graph.product(c, c))});
    const auto [sine, cosine, sign] = oscillating(graph, signs, square, time);
    const Scaled half = half_tangent(graph, sine, cosine);
    const auto shear_of_p = [&](long side) {
        const Scaled slant =
            graph.product(c, graph.sum({graph.product(c, half), Graph::number(side)}));
        return graph.sum(
            {graph.times({-1, 1}, graph.product(a, half)), graph.product(slant, graph.inverse(b))});
    };
    return {shear_of_p(1), graph.product(b, sine), shear_of_p(-1), sign};
}

}  // namespace hvi::gen
