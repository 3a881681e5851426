// Runs over h times a frequency, from resolved to stiff.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "generator/edges/edges.hpp"
#include "generator/edges/forms.hpp"
#include "generator/edges/oscillation.hpp"

namespace hvi::gen {

/// Makes the programs of all methods in all forms on the scene, then has each checked, and reports
/// progress on standard error. `chapter` is its name.
void for_each_form(Builds& builds, const std::vector<ExactMethod>& methods,
                   const std::string& scene, const std::string& chapter,
                   const std::function<void(const KnownOscillator&, const Form&)>& check);

/// The result at one z = h omega.
struct SweepPoint {
    double growth = 0;      ///< drawn where it is finite and above 0
    double iterations = 0;  ///< iterations a step, drawn likewise
    std::string wrong;      ///< the expected and the seen result; empty where they agree
};

/// Sweeps of a scene by several methods, in several forms.
class Sweeps {
public:
    /// `title` is the beginning of the pictures' titles, before the form.
    Sweeps(std::string scene, std::string title)
        : scene_(std::move(scene)), title_(std::move(title)) {}

    /// Makes one check over 57 z from 1e-3 to 1e4, equally many in each decade, without its
    /// expected result. Adds curves to the two pictures of the form. `steps` names the number and
    /// the kind of steps.
    [[nodiscard]] EdgeCheck sweep(const std::string& method, const std::string& form,
                                  const std::string& steps,
                                  const std::function<SweepPoint(double z)>& at);

    /// Returns pictures of growth and iterations for each form.
    [[nodiscard]] std::vector<CurvesPicture> pictures() const;

private:
    /// The curves of a form.
    struct Curves {
        std::string form;
        std::vector<CurvesPicture::Curve> growth, iterations;
    };

    Curves& of_form(const std::string& form);

    std::string scene_, title_;
    std::vector<Curves> forms_;
};

}  // namespace hvi::gen
