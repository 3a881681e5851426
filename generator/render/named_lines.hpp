// Lines of a name and what is said of it, for a terminal.
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
    static constexpr std::size_t columns = terminal_columns - name_columns;  ///< of the text

    void line(std::string_view name, const std::string& text);
    void title(const std::string& text);
    void blank() { text_ += "\n"; }
    [[nodiscard]] const std::string& text() const { return text_; }

private:
    std::string text_;
};

/// Whether no number in a text is longer than people read, and a line of the terminal takes.
[[nodiscard]] bool is_readable(const std::string& text);

/// Whether it has so few terms; with a free parameter there can be tens of thousands.
[[nodiscard]] bool is_readable(const Number& number);

/// To six digits, without zeros at the end; with a free parameter the closed form.
[[nodiscard]] std::string short_decimal(const Number& number);

/// The closed form and six digits, or these alone where it is not readable; where that has neither,
/// how many terms it has.
[[nodiscard]] std::string value_text(const Number& number);

/// Why there is no map of the oscillator, and what would help. Precondition: it has none.
[[nodiscard]] std::string why_no_oscillator(const Findings& findings);

/// `Q_1`, counted from 1.
[[nodiscard]] std::string stage_name(const StageNode& node);

// What certificates of tableaux and of the general form share.
[[nodiscard]] std::string yes_or_no(const Verdict& verdict, const Findings& findings);
[[nodiscard]] std::string order_text(const OrderConditions& conditions, const Findings& findings);
void write_failures(NamedLines& lines, const OrderConditions& conditions);
void write_exceptions(NamedLines& lines, const std::vector<ExceptionalValue>& exceptions);
void write_signs(NamedLines& lines, const Findings& findings);
void write_oscillator(NamedLines& lines, const Findings& findings);
void write_statements(NamedLines& lines, const std::optional<SceneStatements>& scene);

/// All that a certificate says but for its title and its last line.
void write_certificate(NamedLines& lines, const Certificate& certificate);

}  // namespace hvi::gen
