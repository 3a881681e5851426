// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/drive/checkpoint.hpp"

#include <string_view>
#include <type_traits>

#include <driver/answer.hpp>

#include "generator/support/digest.hpp"
#include "generator/support/error.hpp"

namespace hvi::gen {

namespace {

constexpr std::string_view begins = "hvi checkpoint 1\n", ends = "end ";

// ---- writing ----

class LineWriter {
public:
    void line(std::string_view name, std::string_view value) {
        text_.append(name).append(" ").append(value).append("\n");
    }

    template <class Numbers>
    void numbers(std::string_view name, const Numbers& all) {
        std::string value = std::to_string(all.size());
        for (const auto& each : all) {
            value += ' ';
            append(value, each);
        }
        line(name, value);
    }

    [[nodiscard]] const std::string& text() const { return text_; }

private:
    static void append(std::string& text, double value) { driver::append(text, value); }
    static void append(std::string& text, std::int64_t value) { text += std::to_string(value); }

    std::string text_;
};

/// Returns no time or one, for an event that may not have occurred.
std::vector<double> listed(const std::optional<double>& time) {
    return time ? std::vector<double>{*time} : std::vector<double>{};
}

// ---- reading ----

/// Reads lines in the order in which they are written.
class LineReader {
public:
    explicit LineReader(std::string_view text) : text_(text) {}

    /// Returns the text behind the name that a line begins with.
    [[nodiscard]] std::string_view line(std::string_view name) {
        const std::size_t end = text_.find('\n');
        std::string_view line = text_.substr(0, end);
        text_.remove_prefix(end == std::string_view::npos ? text_.size() : end + 1);
        const bool is_it = line.substr(0, name.size()) == name && line.size() > name.size();
        is_right_ = is_right_ && is_it;
        return is_it ? line.substr(name.size() + 1) : std::string_view();
    }

    template <class Number>
    [[nodiscard]] std::vector<Number> numbers(std::string_view name) {
        std::string_view rest = line(name);
        std::int64_t count = 0;
        is_right_ = is_right_ && driver::read(word(rest), count) && count >= 0;
        std::vector<Number> result;
        for (std::int64_t k = 0; k < count && is_right_; ++k) {
            Number number{};
            is_right_ = driver::read(word(rest), number);
            result.push_back(number);
        }
        return result;
    }

    template <class Number>
    [[nodiscard]] Number number(std::string_view name) {
        const std::vector<Number> all = numbers<Number>(name);
        is_right_ = is_right_ && all.size() == 1;
        return is_right_ ? all.front() : Number{};
    }

    [[nodiscard]] std::optional<double> optional(std::string_view name) {
        const std::vector<double> all = numbers<double>(name);
        return all.empty() ? std::nullopt : std::optional(all.front());
    }

    [[nodiscard]] bool is_right() const { return is_right_; }

private:
    static std::string_view word(std::string_view& rest) {
        const std::size_t end = rest.find(' ');
        const std::string_view result = rest.substr(0, end);
        rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
        return result;
    }

    std::string_view text_;
    bool is_right_ = true;
};

std::optional<Checkpoint> read(std::string_view text, std::string& key) {
    LineReader reader(text.substr(begins.size()));
    Checkpoint all;
    key = reader.line("run");
    all.steps = reader.number<std::int64_t>("steps");
    all.iterations = reader.number<std::int64_t>("iterations");
    all.evaluations = reader.number<std::int64_t>("evaluations");
    all.t = reader.number<double>("t");
    all.state = reader.numbers<double>("state");
    const auto count = reader.number<std::int64_t>("departures");
    for (std::int64_t k = 0; k < count && reader.is_right(); ++k) {
        const std::vector<double> each = reader.numbers<double>("departure");
        if (each.size() != 6) return {};
        all.departures.push_back({each[0], each[1], each[2], each[3], each[4], each[5]});
    }
    all.motion = reader.number<double>("motion");
    all.motions = reader.number<std::int64_t>("motions");
    all.counts = reader.numbers<std::int64_t>("counts");
    const auto events = reader.number<std::int64_t>("events");
    for (std::int64_t k = 0; k < events && reader.is_right(); ++k) {
        EventMemory& event = all.events.emplace_back();
        event.sign = static_cast<int>(reader.number<std::int64_t>("sign"));
        event.value = reader.number<double>("value");
        event.slope = reader.number<double>("slope");
        event.last = reader.optional("last");
        event.before_last = reader.optional("before");
    }
    all.reductions = reader.numbers<double>("reductions");
    all.sizes = reader.numbers<std::int64_t>("sizes");
    all.rows = reader.numbers<std::int64_t>("rows");
    return reader.is_right() ? std::optional(all) : std::nullopt;
}

/// Whether the text is a whole checkpoint, which its digest follows.
bool is_whole(std::string_view text, std::string_view behind) {
    const std::string expected = std::string(ends) + digest(text) + "\n";
    return behind.substr(0, expected.size()) == expected;
}

}  // namespace

std::string text(const Checkpoint& checkpoint, const std::string& key) {
    using Integers = std::vector<std::int64_t>;
    using Reals = std::vector<double>;
    LineWriter lines;
    lines.line("run", key);
    lines.numbers("steps", Integers{checkpoint.steps});
    lines.numbers("iterations", Integers{checkpoint.iterations});
    lines.numbers("evaluations", Integers{checkpoint.evaluations});
    lines.numbers("t", Reals{checkpoint.t});
    lines.numbers("state", checkpoint.state);
    lines.numbers("departures", Integers{static_cast<std::int64_t>(checkpoint.departures.size())});
    for (const detail::Departure& each : checkpoint.departures)
        lines.numbers("departure", Reals{each.start, each.largest, each.last, each.looks, each.sum,
                                         each.moment});
    lines.numbers("motion", Reals{checkpoint.motion});
    lines.numbers("motions", Integers{checkpoint.motions});
    lines.numbers("counts", checkpoint.counts);
    lines.numbers("events", Integers{static_cast<std::int64_t>(checkpoint.events.size())});
    for (const EventMemory& event : checkpoint.events) {
        lines.numbers("sign", Integers{event.sign});
        lines.numbers("value", Reals{event.value});
        lines.numbers("slope", Reals{event.slope});
        lines.numbers("last", listed(event.last));
        lines.numbers("before", listed(event.before_last));
    }
    lines.numbers("reductions", checkpoint.reductions);
    lines.numbers("sizes", checkpoint.sizes);
    lines.numbers("rows", checkpoint.rows);
    const std::string whole = std::string(begins) + lines.text();
    return whole + std::string(ends) + digest(whole) + "\n";
}

Checkpoint last_checkpoint(const std::string& text, const std::string& key,
                           const std::filesystem::path& file) {
    const auto name = std::make_shared<const Source>(Source{"--resume", file.string()});
    const std::string_view all = text;
    for (std::size_t begin = all.rfind(begins); begin != std::string_view::npos;
         begin = begin == 0 ? std::string_view::npos : all.rfind(begins, begin - 1)) {
        const std::size_t end = all.find(std::string("\n") + std::string(ends), begin);
        if (end == std::string_view::npos) continue;
        const std::string_view block = all.substr(begin, end + 1 - begin);
        std::string of;
        if (!is_whole(block, all.substr(end + 1))) continue;
        const std::optional<Checkpoint> found = read(block, of);
        if (!found) continue;
        if (of == key) return *found;
        throw InputError("this checkpoint is of another run", whole(name),
                         "scene, parameters, method, step, columns and the version of hvi-gen have "
                         "to be what they were");
    }
    throw InputError("there is no whole checkpoint in this file", whole(name),
                     "--checkpoint writes them");
}

}  // namespace hvi::gen
