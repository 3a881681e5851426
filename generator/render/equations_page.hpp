// A page of equations of a step, for a terminal of 80 columns.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "generator/equations/step_title.hpp"

namespace hvi::gen {

/// Lines of names and facts, and equations.
class EquationsPage {
public:
    static constexpr std::string_view inexact =
        "\nA decimal stands where there is no closed form, to 20 digits.\n";

    void line(const std::string& head, const std::string& text);
    void fact(std::string_view name, const std::string& text);
    void names(std::string_view name, const std::vector<std::string>& list);
    /// Adds a line as it is.
    void remark(std::string_view text) { text_ += text; }
    /// Adds an equation. A long one is broken between the terms that the step size multiplies, or
    /// has a line for each of its terms.
    void equation(const std::string& left, const Expression& right);
    void title(const StepTitle& step) { line("", step.name.empty() ? step.origin : step.name); }
    void parameters(const StepTitle& step);

    [[nodiscard]] const std::string& text() const { return text_; }

private:
    std::string text_;
};

}  // namespace hvi::gen
