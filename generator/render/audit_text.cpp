// An audit for people, in a terminal of 80 columns.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>

#include <algorithm>

#include "generator/read/decimal.hpp"
#include "generator/render/certificate.hpp"
#include "generator/render/entry.hpp"
#include "generator/render/named_lines.hpp"

namespace hvi::gen {

namespace {

constexpr std::size_t most_characters = 56;  ///< characters of a number in a line

std::string cut(const std::string& text, std::size_t columns) {
    return text.size() <= columns ? text : text.substr(0, columns - 3) + "...";
}

std::string method_text(const Rebuilt& rebuilt) {
    if (!rebuilt.tableau) { return "A with its symplectic partner for A~"; }
    const std::string& given = rebuilt.tableau->provenance.name;
    const std::string name = given.empty() ? "collocation at these nodes" : given;
    if (rebuilt.is_method()) { return name; }
    if (rebuilt.A == Matrix::A) { return name + ", with A in place of A~"; }
    return name +
           (rebuilt.A_tilde == Matrix::A ? ", with A and A~ exchanged" : ", with A~ in place of A");
}

/// Returns a short closed form with its value, or the value to one digit more than the given
/// number.
std::string right_text(const WrongEntry& entry) {
    constexpr int least_digits = 6;
    constexpr int most_digits = static_cast<int>(most_characters) - 6;
    const auto given = decimal_digits(entry.given);
    const int digits =
        std::clamp(given ? given->significant + 1 : least_digits, least_digits, most_digits);
    const Entry right = make_entry(entry.right, digits);
    const auto exact = right.exact_text();
    if (!exact || exact->size() > most_characters) { return right.decimal.value_or("?"); }
    return exact == right.decimal || !right.decimal
               ? *exact
               : fmt::format("{} = {}", *exact, *right.decimal);
}

void write_wrong(NamedLines& lines, const std::vector<WrongEntry>& wrong) {
    constexpr std::size_t most_shown = 16;
    for (std::size_t i = 0; i < std::min(most_shown, wrong.size()); ++i) {
        const std::string& place = wrong[i].place;
        lines.line(i == 0 ? "wrong" : "",
                   place + ": " + cut(wrong[i].given, NamedLines::columns - place.size() - 2));
        lines.line("", "right is " + right_text(wrong[i]));
    }
    if (wrong.size() > most_shown) {
        lines.line("", fmt::format("and {} more", wrong.size() - most_shown));
    }
}

void write_rebuilt(NamedLines& lines, const Audit& audit) {
    const auto& rebuilt = audit.rebuilt;
    if (!audit.certificate.parameters.empty()) {
        lines.line("is", "not compared with other methods: it has a free parameter");
        return;
    }
    if (!rebuilt) {
        lines.line("is", "no method that has a name, and no collocation");
        return;
    }
    const std::string method = method_text(*rebuilt);
    if (rebuilt->is_right()) {
        lines.line("is", method + (rebuilt->proved ? "" : ", within the digits given"));
    } else {
        lines.line("meant", fmt::format("{}, but for {} of {} entries", method,
                                        rebuilt->wrong.size(), rebuilt->compared));
        write_wrong(lines, rebuilt->wrong);
    }
    if (rebuilt->places) {
        lines.line("right to", fmt::format("{} decimal place{}", std::max(*rebuilt->places, 0L),
                                           *rebuilt->places == 1 ? "" : "s"));
    }
}

std::string row_sums_text(const Audit& audit) {
    const bool A = audit.c_is_sum_of_A.holds;
    const bool A_tilde = audit.c_is_sum_of_A_tilde.holds;
    if (A && A_tilde) { return "c = A 1 = A~ 1"; }
    if (A) { return "c = A 1, not A~ 1"; }
    return A_tilde ? "c = A~ 1, not A 1" : "c is neither A 1 nor A~ 1";
}

std::string defect_text(const SymplecticDefect& defect) {
    const std::size_t i = defect.i + 1;
    const std::string value = value_text(defect.residual);
    if (!defect.j) { return fmt::format("b~_{0} - b_{0} = {1}", i, value); }
    const std::size_t j = *defect.j + 1;
    return fmt::format("b_{0} a~_{0}{2}{1} + b~_{1} a_{1}{2}{0} - b_{0} b~_{1} = {3}", i, j,
                       std::max(i, j) > 9 ? "," : "", value);
}

std::string closing(const Audit& audit) {
    const Certificate& certificate = audit.certificate;
    if (certificate.is_proved()) { return "All of it is proved."; }
    if (!certificate.within_digits) { return "Some of it rests on enclosures of 50 digits."; }
    if (audit.is_known()) {
        return "All of this is said of that method, of which these are the first digits.";
    }
    return "What holds does so within the digits given; what fails is proved to fail.";
}

}  // namespace

std::string render_text(const Audit& audit, const std::optional<SceneStatements>& scene) {
    const Certificate& certificate = audit.certificate;
    NamedLines lines;
    lines.title(certificate.name.empty() ? certificate.origin : certificate.name);
    lines.blank();
    if (audit.rounded > 0) {
        lines.line("given", fmt::format("{} of {} numbers look rounded, to {} digits",
                                        audit.rounded, audit.coefficients, audit.digits));
    }
    write_rebuilt(lines, audit);
    lines.line("row sums", row_sums_text(audit));
    if (audit.defect) { lines.line("defect", defect_text(*audit.defect)); }
    if (const auto& written = audit.as_written) {
        lines.line("as written",
                   fmt::format("order {}, {}symplectic", written->orders.general.order,
                               written->symplectic.holds ? "" : "not "));
    }
    lines.blank();
    write_certificate(lines, certificate);
    lines.title(closing(audit));
    write_statements(lines, scene);
    return lines.text();
}

}  // namespace hvi::gen
