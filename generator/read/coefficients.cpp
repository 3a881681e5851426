// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/read/coefficients.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <string_view>
#include <utility>

#include "generator/read/catalogue.hpp"
#include "generator/read/check.hpp"
#include "generator/read/file.hpp"
#include "generator/read/json.hpp"
#include "generator/read/names.hpp"
#include "generator/read/nearest.hpp"

namespace hvi::gen {

namespace {

using Kind = JsonValue::Kind;

/// NOTE: `tableau --method gauss:64 --format json` writes 3.2 MiB, and --digits 400 ten times that.
constexpr std::size_t largest_file = 32 * 1024 * 1024;
constexpr std::size_t longest_name = 64;
constexpr std::string_view schema = "hvi-tableau/1";

const std::vector<std::string_view> tableau_keys{
    "A",          "b",     "c",       "A_tilde", "b_tilde",   "name", "schema", "stages",
    "parameters", "basis", "c_tilde", "M",       "M_inverse", "B",    "A_psi"};
const std::vector<std::string_view> entry_keys{"exact", "decimal", "double"};

std::string entries(std::size_t count) {
    return fmt::format("{} entr{}", count, count == 1 ? "y" : "ies");
}

/// Reads one file.
class Reader {
public:
    explicit Reader(const Source& source) : file_(source), root_(file_.root()) {}

    Coefficients coefficients() {
        check_root();
        Coefficients result;
        result.name = name();
        result.origin = "--tableau " + quoted_file_name(file_.name());
        const JsonValue& c = required("c");
        check_count(c);
        stages_ = c.items.size();
        result.c = vector("c", c);
        result.b = vector("b", required("b"));
        result.A = matrix("A", required("A"));
        if (const auto* found = root_.find("b_tilde")) {
            result.b_tilde = vector("b_tilde", *found);
        }
        if (const auto* found = root_.find("A_tilde")) {
            result.A_tilde = matrix("A_tilde", *found);
        }
        check_stages();
        return result;
    }

private:
    [[noreturn]] void fail(Range range, std::string what, std::string help = {}) const {
        throw InputError(std::move(what), file_.place(range), std::move(help));
    }

    void check_keys(const JsonValue& object, const std::vector<std::string_view>& known,
                    std::string_view subject) const {
        for (const JsonMember& member : object.members) {
            if (std::find(known.begin(), known.end(), member.key) != known.end()) { continue; }
            fail(member.range, fmt::format("{} has no `{}`", subject, member.key),
                 did_you_mean(member.key, known, fmt::format("it has {}", listed(known))));
        }
    }

    void check_root() const {
        if (!root_.is(Kind::object)) {
            fail(root_.range, "an object with the coefficients is wanted here",
                 R"(write for example {"A": [["1/2"]], "b": [1], "c": ["1/2"]})");
        }
        const JsonValue* given = root_.find("schema");
        if (given != nullptr && (!given->is(Kind::text) || given->text != schema)) {
            fail(given->range, fmt::format("the schema of a tableau is `{}`", schema));
        }
        check_keys(root_, tableau_keys, "a tableau");
    }

    /// The name goes to terminals and into pictures, so it stays plain.
    [[nodiscard]] std::string name() const {
        const JsonValue* given = root_.find("name");
        if (given == nullptr || given->is(Kind::null)) { return {}; }
        const bool plain = given->is(Kind::text) && given->text.size() <= longest_name &&
                           std::all_of(given->text.begin(), given->text.end(), [](char character) {
                               return ' ' <= character && character <= '~';
                           });
        if (!plain) {
            fail(given->range, "this cannot be the name of a tableau",
                 fmt::format("a name has up to {} characters of ASCII", longest_name));
        }
        return given->text;
    }

    [[nodiscard]] const JsonValue& required(std::string_view key) const {
        if (const JsonValue* found = root_.find(key)) { return *found; }
        fail({root_.range.begin, root_.range.begin + 1},
             fmt::format("the tableau has no `{}`", key),
             "a tableau has A, b and c, and perhaps A_tilde and b_tilde");
    }

    void check_count(const JsonValue& c) const {
        check_is_array("c", c);
        if (c.items.empty()) { fail(c.range, "a tableau has one stage at least"); }
        if (c.items.size() > static_cast<std::size_t>(largest_size)) {
            fail(c.range,
                 fmt::format("a tableau of more than {} stages is out of range", largest_size));
        }
    }

    void check_stages() const {
        const JsonValue* given = root_.find("stages");
        if (given == nullptr || given->text == std::to_string(stages_)) { return; }
        fail(given->range, fmt::format("`c` has {}", entries(stages_)));
    }

    void check_is_array(const std::string& what, const JsonValue& value) const {
        if (!value.is(Kind::array)) { fail(value.range, fmt::format("`{}` is no list", what)); }
    }

    void check_length(const std::string& what, const JsonValue& value) const {
        check_is_array(what, value);
        const std::size_t length = value.items.size();
        if (length == stages_) { return; }
        fail(value.range,
             fmt::format("`{}` has {}, and `c` has {}", what, entries(length), stages_));
    }

    [[nodiscard]] CoefficientVector vector(const std::string& what, const JsonValue& value) const {
        check_length(what, value);
        CoefficientVector result;
        for (const JsonValue& item : value.items) { result.push_back(coefficient(item)); }
        return result;
    }

    [[nodiscard]] CoefficientMatrix matrix(const std::string& what, const JsonValue& value) const {
        check_length(what, value);
        CoefficientMatrix result;
        for (const JsonValue& row : value.items) {
            result.push_back(vector(fmt::format("{}[{}]", what, result.size() + 1), row));
        }
        return result;
    }

    [[nodiscard]] Coefficient coefficient(const JsonValue& value) const {
        const JsonValue& given = value.is(Kind::object) ? of_entry(value) : value;
        if (!given.is(Kind::text) && !given.is(Kind::number)) {
            fail(given.range, "a number is wanted here", R"(write for example "1/2" or 0.5)");
        }
        Coefficient result;
        result.source = file_.source(given.range, given.text);
        result.value = parse_expression(result.source);
        check_coefficient(result.value, result.source);
        return result;
    }

    /// Returns the value that counts in {"exact": ..., "decimal": ..., "double": ...}.
    [[nodiscard]] const JsonValue& of_entry(const JsonValue& entry) const {
        check_keys(entry, entry_keys, "an entry");
        for (const std::string_view key : {"exact", "decimal"}) {
            const JsonValue* found = entry.find(key);
            if (found != nullptr && !found->is(Kind::null)) { return *found; }
        }
        fail(entry.range, "this entry has neither an exact value nor a decimal");
    }

    JsonFile file_;
    const JsonValue& root_;
    std::size_t stages_ = 0;
};

/// Sets `Coefficient::rounded` by the rule that is given there.
void mark_rounded(Coefficients& coefficients) {
    constexpr int surely = 15;
    constexpr int least = 6;
    constexpr int tolerance = 2;
    int most_digits = 0;
    long last_place = 0;
    for_each_coefficient(coefficients, [&](const Coefficient& entry) {
        const auto digits = decimal_digits(entry.source->text);
        if (!digits || digits->significant < least) { return; }
        most_digits = std::max(most_digits, digits->significant);
        last_place = std::min(last_place, digits->last_place);
    });
    for_each_coefficient(coefficients, [&](Coefficient& entry) {
        const auto digits = decimal_digits(entry.source->text);
        if (!digits || digits->significant == 0 || most_digits == 0) { return; }
        const bool is_long = digits->significant >= std::max(least, most_digits - tolerance);
        const bool is_deep = digits->last_place <= last_place + tolerance;
        if (digits->significant >= surely || is_long || is_deep) { entry.rounded = digits; }
    });
}

}  // namespace

Coefficients coefficients_from_json(const Source& file) {
    Coefficients result = Reader(file).coefficients();
    mark_rounded(result);
    if (parameter_names(result).size() > most_parameters) {
        const auto name = std::make_shared<const Source>(Source{"file", file.name});
        throw InputError(fmt::format("there are more than {} parameters", most_parameters),
                         Place{name, {0, name->text.size()}});
    }
    return result;
}

Coefficients coefficients_from_file(const std::filesystem::path& path) {
    return coefficients_from_json({path.string(), read_file(path, largest_file)});
}

std::vector<std::string> parameter_names(const Coefficients& coefficients) {
    std::set<std::string> names;
    for_each_coefficient(coefficients,
                         [&](const Coefficient& entry) { insert_parameters(entry.value, names); });
    return {names.begin(), names.end()};
}

void set_parameter(Coefficients& coefficients, Parameter parameter) {
    const std::string option = parameter_option(parameter);
    set_parameter(coefficients.parameters, parameter_names(coefficients), std::move(parameter),
                  "the tableau");
    coefficients.origin += option;
}

}  // namespace hvi::gen
