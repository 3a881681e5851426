// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/hamiltonian/time_scale.hpp"

#include <algorithm>
#include <cctype>
#include <map>
#include <set>
#include <string_view>
#include <utility>

#include "generator/hamiltonian/gradient.hpp"
#include "generator/hamiltonian/hamiltonian_scene.hpp"
#include "generator/read/names.hpp"
#include "generator/scene/start.hpp"

namespace hvi::gen {

namespace {

using Kind = Expression::Kind;

/// Whether an expression has one of these symbols.
bool has_any(const Expression& expression, const std::set<std::string>& names) {
    bool found = false;
    walk(expression, [&](const Expression& part) {
        found = found || (part.kind == Kind::symbol && names.count(part.name) != 0);
        return !found;
    });
    return found;
}

Expression sum_of_squares(const std::vector<Expression>& values) {
    std::vector<Expression> terms;
    for (const Expression& value : values)
        terms.push_back(Expression::power(value, Expression::integer(2)));
    return Expression::sum(std::move(terms));
}

/// Returns base^(numerator/2).
Expression half_power(Expression base, long numerator) {
    Expression exponent = Expression::product(
        {Expression::integer(numerator), Expression::reciprocal(Expression::integer(2))});
    return Expression::power(std::move(base), std::move(exponent));
}

/// The terms of a sum. A sum in it with a sign or constant factors is split too.
class TermsOfH {
public:
    explicit TermsOfH(std::set<std::string> variables) : variables_(std::move(variables)) {}

    void add(const Expression& expression, const std::vector<Expression>& factors = {}) {
        if (expression.kind == Kind::sum) {
            for (const Expression& term : expression.arguments) add(term, factors);
            return;
        }
        std::vector<Expression> more = factors;
        if (expression.kind == Kind::negation) {
            more.push_back(Expression::integer(-1));
            return add(expression.arguments.front(), more);
        }
        const auto varies = [&](const Expression& factor) { return has_any(factor, variables_); };
        if (expression.kind == Kind::product &&
            std::count_if(expression.arguments.begin(), expression.arguments.end(), varies) == 1) {
            const auto varying =
                std::find_if(expression.arguments.begin(), expression.arguments.end(), varies);
            for (auto factor = expression.arguments.begin(); factor != expression.arguments.end();
                 ++factor)
                if (factor != varying) more.push_back(*factor);
            if (varying->kind == Kind::sum || varying->kind == Kind::negation)
                return add(*varying, more);
        }
        if (factors.empty()) return found_.push_back(expression);
        std::vector<Expression> product = factors;
        product.push_back(expression);
        found_.push_back(Expression::product(std::move(product)));
    }

    [[nodiscard]] const std::vector<Expression>& found() const { return found_; }

private:
    std::set<std::string> variables_;
    std::vector<Expression> found_;
};

/// The parts of H = T(p) + U(q, t).
struct PartsOfH {
    Expression T, U;
};

/// Transforms a scene to scaled time.
class Scaling {
public:
    explicit Scaling(WrittenOutScene scene)
        : scene_(with_hamiltonian(std::move(scene))),
          place_(scene_.scale->place),
          H_(hamiltonian()) {
        p_t_ = "p_t";
        while (contains(variables(H_), p_t_) || is_parameter(p_t_)) p_t_ += "_";
    }

    [[nodiscard]] WrittenOutScene operator()() {
        const Expression H = H_.expression;
        const bool has_time = depends_on_time(H_);
        scene_.scaled = ScaledTime{.coordinate = H_.coordinates.size(),
                                   .energy = has_time ? with_e(H) : H,
                                   .drifts_first = kind() == TimeScale::logarithmic};
        Expression K = scaled();
        begin(H);
        H_.expression = std::move(K);
        H_.coordinates.emplace_back("t");
        H_.momenta.push_back(p_t_);
        scene_.mechanics = H_;
        scene_.exact.clear();
        scene_.scale.reset();
        return std::move(scene_);
    }

private:
    [[nodiscard]] TimeScale kind() const { return scene_.scale->kind; }

    [[nodiscard]] Hamiltonian hamiltonian() const {
        const Hamiltonian& H = hamiltonian_of(scene_);
        if (H.rotations.empty()) return H;
        throw InputError("a scale of the time is not built for rotations", place_);
    }

    [[nodiscard]] bool is_parameter(const std::string& name) const {
        return std::any_of(scene_.parameters.begin(), scene_.parameters.end(),
                           [&](const Parameter& each) { return each.name == name; });
    }

    [[nodiscard]] Expression with_e(const Expression& H) const {
        return Expression::sum({H, Expression::symbol(p_t_)});
    }

    /// Returns K.
    [[nodiscard]] Expression scaled() const {
        const Expression zero = with_e(H_.expression);
        switch (kind()) {
        case TimeScale::expression: {
            const Expression& g = scene_.scale->expression.expression;
            check_positive(g, "the scale of the time");
            return Expression::product({g, zero});
        }
        case TimeScale::logarithmic: {
            const PartsOfH parts = this->parts();
            const Expression negative = Expression::negation(parts.U);
            check_positive(negative, "-U");
            return Expression::sum({Expression::call("log", {with_e(parts.T)}),
                                    Expression::negation(Expression::call("log", {negative}))});
        }
        case TimeScale::potential: {
            const Expression negative = Expression::negation(parts().U);
            check_positive(negative, "-U");
            return Expression::product({zero, Expression::reciprocal(negative)});
        }
        case TimeScale::arclength: {
            const Gradient slopes = gradient(H_);
            std::vector<Expression> all = slopes.by_coordinates;
            all.insert(all.end(), slopes.by_momenta.begin(), slopes.by_momenta.end());
            return Expression::product({zero, half_power(sum_of_squares(all), -1)});
        }
        case TimeScale::distance: break;
        }
        return Expression::product({zero, half_power(Expression::sum(pairs()), -1)});
    }

    /// Throws InputError where a term of H depends on both q and p.
    [[nodiscard]] PartsOfH parts() const {
        const std::vector<std::string> all = variables(H_);
        const std::set<std::string> q(H_.coordinates.begin(), H_.coordinates.end());
        const std::set<std::string> p(H_.momenta.begin(), H_.momenta.end());
        std::set<std::string> varying(all.begin(), all.end());
        varying.insert("t");
        TermsOfH terms(varying);
        terms.add(H_.expression);
        std::vector<Expression> T, U;
        for (const Expression& term : terms.found()) {
            const bool has_p = has_any(term, p), has_q = has_any(term, q) || has_any(term, {"t"});
            if (has_p && has_q)
                throw InputError("this scale is one of H = T(p) + U(q), and here " + to_text(term) +
                                     " depends on both",
                                 place_,
                                 "\"distance\", \"arclength\" or an expression go with any H");
            (has_q ? U : T).push_back(term);
        }
        return {Expression::sum(std::move(T)), Expression::sum(std::move(U))};
    }

    /// Returns the value at the start of the scene. Throws MathError, at the scale, where there is
    /// none.
    [[nodiscard]] Ball value_of(const Expression& expression, const SymbolValues& start,
                                std::string_view what) const {
        try {
            return value_at(expression, start, nullptr);
        } catch (const MathError& error) {
            throw MathError(std::string(what) +
                                " has no value where the scene begins: " + error.what(),
                            place_);
        }
    }

    /// Throws MathError where the expression is provably not positive at the start.
    void check_positive(const Expression& expression, std::string_view what) const {
        const SymbolValues parameters = parameter_values(scene_);
        SymbolValues start = parameters;
        for (const NamedExpression& initial : scene_.initial)
            start[initial.name] = value_at(initial.expression, parameters, initial.place.source);
        start["t"] = Ball();
        if (scene_.initial.empty() || value_of(expression, start, what).sign() > 0) return;
        throw MathError(std::string(what) + " is not seen to be positive where the scene begins",
                        place_, "time has to go on as steps do");
    }

    /// Returns r^-3 of all pairs of bodies, or of the distance from the origin where there is one
    /// body.
    [[nodiscard]] std::vector<Expression> pairs() const {
        const std::vector<std::vector<Expression>> bodies = this->bodies();
        std::vector<Expression> terms;
        if (bodies.size() == 1) {
            terms.push_back(half_power(sum_of_squares(bodies.front()), -3));
            return terms;
        }
        for (std::size_t a = 0; a < bodies.size(); ++a)
            for (std::size_t b = a + 1; b < bodies.size(); ++b) {
                std::vector<Expression> between;
                for (std::size_t k = 0; k < bodies[a].size(); ++k)
                    between.push_back(
                        Expression::sum({bodies[a][k], Expression::negation(bodies[b][k])}));
                terms.push_back(half_power(sum_of_squares(between), -3));
            }
        return terms;
    }

    /// Returns the name of a coordinate's body: `x[2]` and `y[2]`, `x2` and `y2`, `x[2,1]` and
    /// `x[2,3]` belong to one body each.
    [[nodiscard]] static std::string body_of(const std::string& coordinate) {
        const std::size_t bracket = coordinate.find('[');
        if (bracket != std::string::npos)
            return coordinate.substr(bracket + 1, coordinate.find_first_of(",]") - bracket - 1);
        std::size_t end = coordinate.size();
        while (end > 0 && std::isdigit(static_cast<unsigned char>(coordinate[end - 1])) != 0) --end;
        return coordinate.substr(end);
    }

    [[nodiscard]] std::vector<std::vector<Expression>> bodies() const {
        std::vector<std::string> names;
        std::map<std::string, std::vector<Expression>> all;
        for (const std::string& coordinate : H_.coordinates) {
            const std::string name = body_of(coordinate);
            if (all.count(name) == 0) names.push_back(name);
            all[name].push_back(Expression::symbol(coordinate));
        }
        std::vector<std::vector<Expression>> result;
        for (const std::string& name : names) result.push_back(all[name]);
        const bool are_alike =
            std::all_of(result.begin(), result.end(), [&](const std::vector<Expression>& body) {
                return body.size() == result.front().size();
            });
        if (are_alike) return result;
        throw InputError("these coordinates are not seen to be those of bodies", place_,
                         "bodies are told apart by indices, x[1] and y[1], or numbers, x1 and y1; "
                         "or write the scale as an expression");
    }

    /// Lets t begin at 0, and e at -H.
    void begin(const Expression& H) {
        if (scene_.initial.empty()) return;
        std::map<std::string, Expression> start{{"t", Expression::integer(0)}};
        for (const NamedExpression& initial : scene_.initial)
            start[initial.name] = initial.expression;
        const auto momenta =
            scene_.initial.begin() + static_cast<std::ptrdiff_t>(H_.coordinates.size());
        scene_.initial.insert(momenta, {"t", Expression::integer(0), place_});
        scene_.initial.push_back({p_t_, Expression::negation(replaced(H, start)), place_});
    }

    WrittenOutScene scene_;
    Place place_;
    Hamiltonian H_;
    std::string p_t_;  ///< the name of e
};

}  // namespace

WrittenOutScene with_time_scale(WrittenOutScene scene) {
    return scene.scale ? Scaling(std::move(scene))() : scene;
}

}  // namespace hvi::gen
