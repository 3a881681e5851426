// The version of the runtime, and which generated headers it serves.
// SPDX-License-Identifier: MIT
#pragma once

namespace hvi {

/// Version of these headers.
/// # Use
/// A program may check the version in a static_assert. Generated headers check their format in the
/// same way, so that a mismatch is a compile error with its reason.
/// ```cpp
/// #include <utility>
///
/// #include <hvi/version.hpp>
///
/// constexpr std::pair version{hvi::version_major, hvi::version_minor};
/// static_assert(version >= std::pair{0, 1}, "this program needs hvi 0.1");
/// static_assert(hvi::supports_format(hvi::runtime_format));
///
/// int main() {
///     const bool is_particular = !hvi::supports_format(hvi::runtime_format - 1);
///     return is_particular ? 0 : 1;
/// }
/// ```
inline constexpr int version_major = 0;
inline constexpr int version_minor = 1;
inline constexpr int version_patch = 0;

/// Format of the calls of generated headers into the runtime: each header names its own, and this
/// one is understood. The number changes where headers written before would no longer compile, or
/// would mean something else.
inline constexpr int runtime_format = 15;

[[nodiscard]] constexpr bool supports_format(int wanted) { return wanted == runtime_format; }

}  // namespace hvi
