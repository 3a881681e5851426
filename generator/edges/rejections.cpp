// Impossible steps, and states from which there are no steps.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "generator/edges/edges.hpp"
#include "generator/edges/method_on_scene.hpp"
#include "generator/edges/origin.hpp"

namespace hvi::gen {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double denormal = std::numeric_limits<double>::denorm_min();

/// The expected result of a step.
enum class Promise {
    identity,  ///< ok, and the state unchanged in every bit
    back,      ///< steps, then as many of size -h, end at the start up to round-off
    refusal,   ///< a status, and the state unchanged in every bit
    either,    ///< a finite state, or a refusal
};

std::string text(Promise promise) {
    switch (promise) {
    case Promise::identity: return "ok, the state untouched";
    case Promise::back: return "ok, back within 1e-12";
    case Promise::refusal: return "a status, the state untouched";
    case Promise::either: return "ok and finite, or a status and the state untouched";
    }
    return {};
}

struct Case {
    std::string what;
    double h;
    std::vector<double> state;
    Promise promise;
};

/// Returns the largest difference, divided by the largest component.
double distance(const std::vector<double>& x, const std::vector<double>& y) {
    double difference = 0, size = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        difference = std::max(difference, std::abs(x[i] - y[i]));
        size = std::max(size, std::abs(y[i]));
    }
    return difference / size;
}

struct Seen {
    std::string text;
    bool agrees;
};

Seen judged(const Heard& heard, const Case& edge) {
    if (!heard.failure.empty()) return {heard.failure, false};
    const Answers& answers = heard.answers;
    const bool ok = answers.text("status") == "ok", untouched = answers.integer("untouched") == 1;
    const std::vector<double> end = answers.numbers("end");
    const bool finite =
        std::all_of(end.begin(), end.end(), [](double x) { return std::isfinite(x); });
    const std::string where = untouched ? ", the state untouched"
                              : finite  ? ", a finite state"
                                        : ", a state that is not finite";
    std::string text = answers.text("status") + where;
    switch (edge.promise) {
    case Promise::identity: return {text, ok && untouched};
    case Promise::refusal: return {text, !ok && untouched};
    case Promise::either: return {text, ok ? finite : untouched};
    case Promise::back: break;
    }
    const double off = distance(end, edge.state);
    return {ok ? fmt::format("ok, back within {:.1e}", off) : text, ok && off <= 1e-12};
}

/// `coordinates` is the number of coordinates and entries of rotations in the state.
std::vector<Case> cases(Origin origin, double h, const std::vector<double>& start,
                        std::size_t coordinates, bool is_symmetric) {
    std::vector<Case> all{{"h = 0", 0, start, Promise::identity}};
    if (is_symmetric)
        all.push_back({fmt::format("ten steps of {} and back", h), h, start, Promise::back});
    for (const double large : {1e3, -1e3, 1e10, 1e300, -1e300})
        all.push_back({fmt::format("h = {}", large), large, start, Promise::either});
    for (const double none : {infinity, -infinity, not_a_number})
        all.push_back({fmt::format("h = {}", none), none, start, Promise::refusal});
    for (const double tiny : {denormal, 1e-300})
        all.push_back({fmt::format("h = {}", tiny), tiny, start, Promise::either});
    for (std::size_t i = 0; i < start.size(); ++i)
        for (const double none : {not_a_number, infinity, -infinity}) {
            std::vector<double> state = start;
            state[i] = none;
            const bool is_q = i < coordinates;
            const std::size_t k = (is_q ? i : i - coordinates) + 1;
            all.push_back(
                {fmt::format("{}{} = {}", is_q ? "q" : "p", k, none), h, state, Promise::refusal});
        }
    all.push_back(
        {"all of the state 1e300", h, std::vector<double>(start.size(), 1e300), Promise::either});
    all.push_back({"all of the state 0", h, std::vector<double>(start.size(), 0.0),
                   origin == Origin::singular ? Promise::refusal
                   : origin == Origin::rest   ? Promise::identity
                                              : Promise::either});
    all.push_back({fmt::format("all of the state {}", denormal), h,
                   std::vector<double>(start.size(), denormal),
                   origin == Origin::singular ? Promise::refusal : Promise::either});
    return all;
}

/// NOTE: a chart is at the start of a step, so that the way back uses another chart.
bool has_charts(const Scene& scene) { return !scene.rotations.texts.empty(); }

std::vector<EdgeCheck> checks(const MethodOnScene& subject) {
    const auto& [method, scene, program] = subject;
    const bool comes_back = !has_charts(scene) && is_symmetric(method);
    const WrittenOutScene written = unrolled(scene);
    const std::vector<double> start =
        program.ask({"start"}).answers.numbers("start", written.initial.size());
    std::vector<EdgeCheck> result;
    for (const Case& edge : cases(origin_of(scene), usual_step(scene), start,
                                  function_of(written).coordinates.size(), comes_back)) {
        const bool back = edge.promise == Promise::back;
        const Seen seen = judged(
            program.ask(back ? "return" : "advance", edge.h, back ? 10 : 1, edge.state), edge);
        result.push_back(
            {method.name(), scene.name, edge.what, text(edge.promise), seen.text, seen.agrees});
    }
    return result;
}

}  // namespace

EdgeChapter rejections(Builds& builds, const std::vector<ExactMethod>& methods,
                       const std::vector<Scene>& scenes) {
    EdgeChapter chapter{
        "rejections",
        "Steps that cannot be",
        "A step ends with ok and a finite state, or with a status and every bit of the state as it "
        "was, and it ends. h = 0 is the identity, a step from or with what is no finite number is "
        "refused, the origin is a point of rest or, in Kepler's problem, the collision; and "
        "self-adjoint methods, which the exact coefficients tell, come back with -h. Each case is "
        "a step of a new stepper in a program of its own, which has a minute.",
        {},
        {}};
    add_cases(
        chapter, methods, scenes,
        [&](const ExactMethod& method, const Scene& scene) {
            return EdgeProgram(builds, method, scene);
        },
        checks);
    return chapter;
}

}  // namespace hvi::gen
