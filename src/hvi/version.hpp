// The version of the runtime, and which generated headers it serves.
// SPDX-License-Identifier: MIT
#pragma once

namespace hvi {

inline constexpr int version_major = 0;
inline constexpr int version_minor = 1;
inline constexpr int version_patch = 0;

/// Generated headers name the format of their calls into the runtime; this one is understood. It
/// changes where a header that was written before would not compile any more, or mean something
/// else.
inline constexpr int runtime_format = 11;

[[nodiscard]] constexpr bool supports_format(int wanted) { return wanted == runtime_format; }

}  // namespace hvi
