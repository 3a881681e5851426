// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/edges/sweep.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "generator/support/bar.hpp"

namespace hvi::gen {

namespace {

constexpr int points = 57, points_of_decade = 8;
constexpr double most_drawn = 1e20;

}  // namespace

void for_each_form(Builds& builds, const std::vector<ExactMethod>& methods,
                   const std::string& scene, const std::string& chapter,
                   const std::function<void(const KnownOscillator&, const Form&)>& check) {
    std::vector<std::pair<KnownOscillator, std::vector<Form>>> all;
    for (const ExactMethod& method : methods)
        all.push_back({known_oscillator(method), forms(builds, method, edge_scene(scene))});
    Bar bar;
    double done = 0;
    for (const auto& [known, forms] : all) {
        bar.show(done++ / static_cast<double>(all.size()), chapter + ": " + known.method);
        for (const Form& form : forms) check(known, form);
    }
}

EdgeCheck Sweeps::sweep(const std::string& method, const std::string& form,
                        const std::string& steps, const std::function<SweepPoint(double)>& at) {
    int right = 0;
    std::string wrong;
    CurvesPicture::Curve growth{method, {}}, iterations = growth;
    for (int k = 0; k < points; ++k) {
        const double z = std::pow(10, -3 + static_cast<double>(k) / points_of_decade);
        const SweepPoint point = at(z);
        right += point.wrong.empty() ? 1 : 0;
        if (wrong.empty() && !point.wrong.empty())
            wrong = fmt::format("; at z = {} {}", z, point.wrong);
        if (std::isfinite(point.growth) && point.growth > 0)
            growth.points.emplace_back(z, std::min(point.growth, most_drawn));
        if (point.iterations > 0) iterations.points.emplace_back(z, point.iterations);
    }
    Curves& curves = of_form(form);
    curves.growth.push_back(std::move(growth));
    curves.iterations.push_back(std::move(iterations));
    return {method,
            scene_,
            fmt::format("{}: {} z from 0.001 to 10000, {}", form, points, steps),
            "",
            fmt::format("so at {} of {}{}", right, points, wrong),
            right == points};
}

std::vector<CurvesPicture> Sweeps::pictures() const {
    std::vector<CurvesPicture> all;
    for (const Curves& curves : forms_)
        for (const auto& [y, drawn] : {std::pair("growth", &curves.growth),
                                       std::pair("iterations a step", &curves.iterations)})
            all.push_back(
                {title_ + ", " + curves.form + ": " + y, "h omega", y, true, true, *drawn});
    return all;
}

Sweeps::Curves& Sweeps::of_form(const std::string& form) {
    const auto found = std::find_if(forms_.begin(), forms_.end(),
                                    [&](const Curves& each) { return each.form == form; });
    return found != forms_.end() ? *found : forms_.emplace_back(Curves{form, {}, {}});
}

}  // namespace hvi::gen
