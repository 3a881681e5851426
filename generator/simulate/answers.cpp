// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/simulate/answers.hpp"

#include <fmt/format.h>

#include <charconv>

#include "generator/support/child.hpp"
#include "generator/support/error.hpp"
#include "generator/support/progress.hpp"

namespace hvi::gen {

namespace {

constexpr int cannot_write = 3;  // a driver's exit status

template <class Number>
Number read(std::string_view text) {
    Number value{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    HVI_CHECK(error == std::errc{} && end == text.data() + text.size());
    return value;
}

}  // namespace

void Answers::hear(std::string_view line) {
    const std::size_t blank = line.find(' ');
    HVI_CHECK(blank != std::string_view::npos);
    values_[std::string(line.substr(0, blank))].emplace_back(line.substr(blank + 1));
}

const std::string& Answers::text(const std::string& key) const {
    const auto found = values_.find(key);
    HVI_CHECK(found != values_.end());
    return found->second.back();
}

std::int64_t Answers::integer(const std::string& key) const {
    return read<std::int64_t>(text(key));
}

double Answers::number(const std::string& key) const { return read<double>(text(key)); }

std::vector<double> Answers::numbers(const std::string& key) const {
    std::vector<double> result;
    if (const auto found = values_.find(key); found != values_.end())
        for (const std::string& value : found->second) result.push_back(read<double>(value));
    return result;
}

Answers ask(const std::filesystem::path& program, std::vector<std::string> words,
            const std::filesystem::path& file, const std::function<void(double)>& on_progress) {
    constexpr std::string_view progress = "progress ";
    const Progress::Stage stage("running");
    words.insert(words.begin(), program.string());
    if (!file.empty()) words.push_back(file.string());
    Answers answers;
    const ChildResult ended = run_child(words, ".", [&](std::string_view line) {
        if (!line.starts_with(progress)) return answers.hear(line);
        if (on_progress) on_progress(read<double>(line.substr(progress.size())));
    });
    if (ended.status == cannot_write) throw EnvironmentError("cannot write " + file.string());
    if (ended.status > 128)
        throw EnvironmentError(
            fmt::format("the compiled program was ended by signal {}", ended.status - 128));
    HVI_CHECK(ended.ok());
    return answers;
}

}  // namespace hvi::gen
