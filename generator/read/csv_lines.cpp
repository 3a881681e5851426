// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/read/csv_lines.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "generator/read/token.hpp"

namespace hvi::gen {

namespace {

constexpr std::size_t longest_line = 1024 * 1024;

}  // namespace

CsvLines::CsvLines(NumberFile file, std::ifstream stream)
    : file_(std::move(file)), stream_(std::move(stream)), line_(longest_line + 1, '\0') {}

bool CsvLines::next() {
    while (stream_.getline(line_.data(), static_cast<std::streamsize>(line_.size()))) {
        const auto read = static_cast<std::size_t>(stream_.gcount());
        here_ = behind_;
        behind_ = {here_.byte + static_cast<std::int64_t>(read), here_.number + 1};
        text_ = std::string_view(line_).substr(0, read - (stream_.eof() ? 0 : 1));
        const Range content = trimmed(text_, {0, text_.size()});
        if (content.begin != content.end && text_[content.begin] != '#') return true;
    }
    if (!stream_.eof()) refuse(file_, "a line is longer than those of tables of numbers are");
    return false;
}

void CsvLines::go_to(Position position) {
    stream_.clear();
    stream_.seekg(position.byte);
    behind_ = position;
}

std::shared_ptr<const Source> CsvLines::source() const {
    return std::make_shared<const Source>(
        Source{fmt::format("{}:{}", file_.path.string(), here_.number), std::string(text_)});
}

std::vector<Range> cells(std::string_view line) {
    std::vector<Range> result;
    std::size_t begin = 0;
    for (;;) {
        const std::size_t comma = std::min(line.find(',', begin), line.size());
        result.push_back(trimmed(line, {begin, comma}));
        if (comma == line.size()) return result;
        begin = comma + 1;
    }
}

}  // namespace hvi::gen
