// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/emit/text/constants.hpp"

#include <algorithm>

#include "generator/support/error.hpp"

namespace hvi::gen {
namespace {

constexpr std::string_view call = "rounded(";
constexpr std::string_view qualified_call = "hvi::detail::rounded<Scalar>(";

/// Returns the number in a format. A format other than float always has it: see check_range().
const Dyadic& of(const Rounded& value, int bits) {
    for (std::size_t f = 0; f < formats.size(); ++f) {
        if (formats[f].bits == bits) {
            HVI_CHECK(value[f]);
            return *value[f];
        }
    }
    HVI_CHECK(false);
    return *value.front();
}

const std::optional<Dyadic>& of_float(const Rounded& value) {
    static_assert(formats.front().bits == 24);
    return value.front();
}

bool is_the_same_in_all(const Rounded& value) {
    return std::all_of(value.begin(), value.end(),
                       [&](const auto& in_format) { return in_format == value.front(); });
}

/// Returns a number of few bits, or one whose decimal digits tell a reader nothing.
std::string hexadecimal(double value) { return value == 0.0 ? "0.0" : fmt::format("{:a}", value); }

/// Returns a call of rounded(); see src/hvi/detail/coefficients/rounded.hpp.
std::string text_of(const Rounded& value) {
    const Dyadic& hi = of(value, 53);
    if (is_the_same_in_all(value)) { return fmt::format("Scalar({})", literal(hi.to_double())); }
    const Dyadic rest = of(value, 113) - hi;
    const Dyadic to_113 = rest.cut(53);
    const auto single = of_float(value) ? static_cast<float>(of_float(value)->to_double()) : 0.0F;
    return fmt::format("{}{}, {}, {}, {}, {})", call, literal(single), literal(hi.to_double()),
                       hexadecimal((of(value, 64) - hi).to_double()),
                       hexadecimal(to_113.to_double()), hexadecimal((rest - to_113).to_double()));
}

/// Checks the size of a constant. NOTE: the parts of a number of 113 bits are doubles, so it has to
/// be well above the smallest double.
void check_range(const Constant& constant) {
    constexpr int least = -900;
    for (std::size_t f = 0; f < formats.size(); ++f) {
        const auto& value = constant.value[f];
        const bool missing = !value && formats[f].bits != 24;
        if (missing || (value && !value->is_zero() && value->leading() < least)) {
            const std::string exact = constant.name == constant.exact ? "" : " = " + constant.exact;
            throw MathError(constant.name + exact + " is beyond the range of coefficients");
        }
    }
}

/// NOTE: at most four braces are open around a table.
constexpr std::size_t line_width = page_width - 16;

void entries(Writer& writer, const std::vector<Constant>& row) {
    std::size_t width = 0;
    const auto line = [&](const Constant& entry) {
        return fmt::format("{:<{}}  // {} = {}", text_of(entry.value) + ",", width, entry.name,
                           entry.exact);
    };
    for (const Constant& entry : row) {
        check_range(entry);
        if (line(entry).size() <= line_width) {
            width = std::max(width, text_of(entry.value).size() + 1);
        }
    }
    for (const Constant& entry : row) {
        if (line(entry).size() <= line_width) {
            writer.line("{}", line(entry));
        } else {
            writer.comment(entry.name + " = " + entry.exact);
            writer.line("{},", text_of(entry.value));
        }
    }
}

/// Writes as many entries in a line as there is room for.
void entries(Writer& writer, const std::vector<Rounded>& row) {
    std::string line;
    for (const Rounded& entry : row) {
        const std::string text = fmt::format("Scalar({}),", literal(of(entry, 53).to_double()));
        if (!line.empty() && line.size() + 1 + text.size() > line_width) {
            writer.line("{}", line);
            line.clear();
        }
        line += (line.empty() ? "" : " ") + text;
    }
    writer.line("{}", line);
}

/// Writes a table of rows, by entries() of each.
void table_of_rows(Writer& writer, std::string_view name, const auto& rows) {
    writer.open("static constexpr Scalar {}[{}][{}] = {{", name, rows.size(), rows.front().size());
    for (const auto& row : rows) {
        writer.open("{{");
        entries(writer, row);
        writer.close("},");
    }
    writer.close("};");
}

}  // namespace

void table(Writer& writer, std::string_view name, const std::vector<Constant>& row) {
    writer.open("static constexpr Scalar {}[{}] = {{", name, row.size());
    entries(writer, row);
    writer.close("};");
}

void table(Writer& writer, std::string_view name, const std::vector<std::vector<Constant>>& rows) {
    table_of_rows(writer, name, rows);
}

void table_of_doubles(Writer& writer, std::string_view name,
                      const std::vector<std::vector<Rounded>>& rows) {
    table_of_rows(writer, name, rows);
}

std::string initializer(const Constant& constant) {
    check_range(constant);
    return text_of(constant.value);
}

std::string qualified_initializer(const Constant& constant) {
    const std::string text = initializer(constant);
    const bool is_call = text.substr(0, call.size()) == call;
    return is_call ? std::string(qualified_call) + text.substr(call.size()) : text;
}

bool are_rounded(std::string_view tables) {
    return tables.find(call) != std::string_view::npos ||
           tables.find(qualified_call) != std::string_view::npos;
}

std::string with_rounding(const std::string& tables) {
    return are_rounded(tables) ? with_rounding_declared(tables) : tables;
}

std::string with_rounding_declared(const std::string& text) {
    Writer writer(1);
    writer.comment("rounded(...) is the number of its comment as float, double, long double or "
                   "__float128: the one that Scalar is.");
    writer.line("static constexpr auto& rounded = hvi::detail::rounded<Scalar>;").blank();
    return writer.str() + '\n' + text;
}

void refuse_float(Writer& writer, const std::vector<Constant>& constants) {
    for (const Constant& constant : constants) {
        if (of_float(constant.value)) { continue; }
        writer.line("static_assert(hvi::detail::bits<Scalar> != 24,");
        writer.line("              \"hvi: {} is beyond the range of float\");", constant.name);
    }
}

namespace {

constexpr int least = -300;  // power of two

bool is_next_to_zero(const Number& value) {
    return !value.known_zero() && value.nearest_multiple(least).is_zero();
}

}  // namespace

Rounded rough_value(const Number& value) {
    return is_next_to_zero(value) ? nearest(Number(0)) : nearest_or_small(value);
}

Constant constant(std::string name, const Number& value) {
    return {std::move(name), rough_value(value),
            is_next_to_zero(value) ? fmt::format("0 within 2^{}", least) : exact_text(value)};
}

}  // namespace hvi::gen
