// The version of the runtime, and which generated headers it serves.
// SPDX-License-Identifier: MIT
#pragma once

namespace hvi {

/// The version of these headers.
/// # Use
/// A program may ask for a version, and generated headers ask for their format themselves: while
/// they are compiled, so that an answer of no is an error with its reason.
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

/// Generated headers name the format of their calls into the runtime; this one is understood. It
/// changes where a header that was written before would not compile any more, or mean something
/// else.
inline constexpr int runtime_format = 13;

[[nodiscard]] constexpr bool supports_format(int wanted) { return wanted == runtime_format; }

}  // namespace hvi
