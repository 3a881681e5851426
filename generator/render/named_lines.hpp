// Lines of a name and facts, for a terminal.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "generator/certify/certificate.hpp"
#include "generator/render/layout.hpp"
#include "generator/render/statements.hpp"

namespace hvi::gen {

class NamedLines {
public:
    static constexpr std::size_t name_columns = 14;
    static constexpr std::size_t columns = terminal_columns - name_columns;  ///< for the text

    void line(std::string_view name, const std::string& text);
    void title(const std::string& text);
    void blank() { text_ += "\n"; }
    [[nodiscard]] const std::string& text() const { return text_; }

private:
    std::string text_;
};

/// Whether no number in a text is too long for a line of the terminal.
[[nodiscard]] bool is_readable(const std::string& text);

/// Whether the number has few terms; with a free parameter there can be tens of thousands.
[[nodiscard]] bool is_readable(const Number& number);

/// Returns six digits without zeros at the end; with a free parameter the closed form.
[[nodiscard]] std::string short_decimal(const Number& number);

/// Returns the closed form and six digits, or only these where the form is not readable; where
/// there are no digits either, the number of terms.
[[nodiscard]] std::string value_text(const Number& number);

/// Returns why there is no map of the oscillator, and help. Precondition: there is none.
[[nodiscard]] std::string why_no_oscillator(const Findings& findings);

/// Returns `Q_1`, counted from 1.
[[nodiscard]] std::string stage_name(const StageNode& node);

// Common parts of the certificates of tableaux and of the general form.
[[nodiscard]] std::string yes_or_no(const Verdict& verdict, const Findings& findings);
[[nodiscard]] std::string order_text(const OrderConditions& conditions, const Findings& findings);
void write_failures(NamedLines& lines, const OrderConditions& conditions);
void write_exceptions(NamedLines& lines, const std::vector<ExceptionalValue>& exceptions);
void write_signs(NamedLines& lines, const Findings& findings);
void write_oscillator(NamedLines& lines, const Findings& findings);
void write_statements(NamedLines& lines, const std::optional<SceneStatements>& scene);

/// Writes all of a certificate but its title and its last line.
void write_certificate(NamedLines& lines, const Certificate& certificate);

}  // namespace hvi::gen
