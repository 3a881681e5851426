// A table of numbers in a file, as comma-separated values.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <unistd.h>

#include <array>
#include <charconv>
#include <cstdint>
#include <cstdio>
#include <string>
#include <string_view>

#include <driver/answer.hpp>

namespace hvi::gen {

/// Returns a text as a cell of comma-separated values: in quotes where a comma is in it, as in
/// u[1,2]. Precondition: there is no quote in it.
[[nodiscard]] inline std::string text_of_cell(std::string_view text) {
    const std::string_view quote = text.find(',') == std::string_view::npos ? "" : "\"";
    return std::string(quote).append(text).append(quote);
}

/// Rows of numbers below a line of names. close() reports whether all of it was written.
class NumberTable {
public:
    explicit NumberTable(const char* path)
        : file_(std::fopen(path, "wb")), good_(file_ != nullptr) {}

    /// Continues a file after `size` bytes, and drops the rest of it.
    NumberTable(const char* path, std::int64_t size) : file_(std::fopen(path, "r+b")) {
        const bool is_nowhere = std::string_view(path) == "/dev/null";
        good_ = file_ != nullptr && (is_nowhere || is_cut_off(size));
    }

    ~NumberTable() {
        if (file_ != nullptr) { std::fclose(file_); }
    }
    NumberTable(const NumberTable&) = delete;
    NumberTable& operator=(const NumberTable&) = delete;

    [[nodiscard]] bool good() const { return good_; }

    NumberTable& cell(std::string_view text) {
        if (!line_.empty()) { line_ += ','; }
        line_ += text_of_cell(text);
        return *this;
    }

    NumberTable& cell(double value) {
        if (!line_.empty()) { line_ += ','; }
        driver::append(line_, value);
        return *this;
    }

    /// NOTE: writes enough digits to restore the float.
    NumberTable& cell(float value) {
        if (!line_.empty()) { line_ += ','; }
        std::array<char, 32> digits;
        const auto result = std::to_chars(digits.begin(), digits.end(), value);
        line_.append(digits.begin(), result.ptr);
        return *this;
    }

    void end_row() {
        line_ += '\n';
        bytes(line_);
        line_.clear();
    }

    /// Writes bytes as they are.
    void bytes(std::string_view all) {
        good_ = good_ && std::fwrite(all.data(), 1, all.size(), file_) == all.size();
    }
    /// Writes bytes over the beginning of the file.
    void overwrite(std::string_view all) {
        good_ = good_ && std::fseek(file_, 0, SEEK_SET) == 0;
        bytes(all);
    }

    /// Returns the number of bytes, all handed to the system; -1 where that failed.
    [[nodiscard]] std::int64_t flushed_size() {
        good_ = good_ && std::fflush(file_) == 0;
        return good_ ? static_cast<std::int64_t>(std::ftell(file_)) : -1;
    }

    /// Closes the file. Returns whether every row has been written.
    [[nodiscard]] bool close() {
        if (file_ == nullptr) { return false; }
        good_ = std::fclose(file_) == 0 && good_;
        file_ = nullptr;
        return good_;
    }

private:
    [[nodiscard]] bool is_cut_off(std::int64_t size) {
        return std::fseek(file_, 0, SEEK_END) == 0 && std::ftell(file_) >= size &&
               ::ftruncate(::fileno(file_), size) == 0 && std::fseek(file_, 0, SEEK_END) == 0;
    }

    std::FILE* file_;
    bool good_ = false;
    std::string line_;
};

}  // namespace hvi::gen
