// Errors of hvi-gen: the fault, its place in the user's text, and help.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>

namespace hvi::gen {

/// Exit statuses of CONTRACT.md, "Output and exit status".
enum class ExitStatus : int {
    done = 0,
    mathematics = 1,  ///< understood, but mathematics forbids it
    input = 2,        ///< cannot be read
    environment = 3,  ///< something outside failed
    bug = 70,         ///< a broken invariant of ours
    interrupted = 130,
};

/// A half-open range of bytes [begin, end) in a text.
struct Range {
    std::size_t begin = 0;
    std::size_t end = 0;
};

/// A text that the user gave, with its name in messages: `--basis`, or `method.toml:3` for a text
/// that begins in line 3 of this file.
struct Source {
    std::string name;
    std::string text;
};

/// A range in a source, for carets.
struct Place {
    std::shared_ptr<const Source> source;
    Range range;
};

/// The text that the user gave for an option. The source's name is the option; null where nothing
/// was given.
using Given = std::shared_ptr<const Source>;

[[nodiscard]] Given given(std::string name, std::string text);

/// Returns all of a text that the user gave.
[[nodiscard]] Place whole(std::shared_ptr<const Source> source);

/// Base of all errors that end the program with a message of the form
///
///     error: WHAT
///       NAME: TEXT
///             ^~~~
///     help: WHAT WOULD HELP
///
/// The place and the help are optional.
class Error : public std::runtime_error {
public:
    Error(ExitStatus status, std::string what, std::optional<Place> place, std::string help);

    [[nodiscard]] ExitStatus status() const noexcept { return status_; }
    [[nodiscard]] const std::optional<Place>& place() const noexcept { return place_; }
    [[nodiscard]] const std::string& help() const noexcept { return help_; }

private:
    ExitStatus status_;
    std::optional<Place> place_;
    std::string help_;
};

/// The input is understood, but mathematics forbids it (status 1).
class MathError : public Error {
public:
    explicit MathError(std::string what, std::optional<Place> place = {}, std::string help = {});
};

/// The input cannot be read (status 2).
class InputError : public Error {
public:
    explicit InputError(std::string what, std::optional<Place> place = {}, std::string help = {});
};

/// Something outside the program failed (status 3).
class EnvironmentError : public Error {
public:
    explicit EnvironmentError(std::string what, std::string help = {});
};

/// The user has interrupted the program (status 130).
class Interruption : public Error {
public:
    Interruption();
};

/// A broken invariant: a bug of ours (status 70). Thrown by HVI_CHECK only.
class InternalError : public Error {
public:
    explicit InternalError(std::string what);
};

/// Returns the error as the user sees it, ending in a newline. Long lines are cut to a window
/// around the place, and bytes that a terminal would act on are shown as '?'.
[[nodiscard]] std::string message(const Error& error);

[[noreturn]] void check_failed(const char* condition, const char* file, int line);

}  // namespace hvi::gen

/// States an invariant of ours; when it does not hold, the program ends with status 70.
#define HVI_CHECK(condition)                                                                       \
    ((condition) ? void() : ::hvi::gen::check_failed(#condition, __FILE__, __LINE__))
