// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/emit/text/macros.hpp"

#include <algorithm>
#include <array>

namespace hvi::gen {
namespace {

bool is_in_capitals(std::string_view name) {
    return std::none_of(name.begin(), name.end(), [](char c) { return c >= 'a' && c <= 'z'; });
}

auto capitals_in(std::string_view name) {
    return std::count_if(name.begin(), name.end(), [](char c) { return c >= 'A' && c <= 'Z'; });
}

/// Beginnings of names of macros that are too many to be listed.
constexpr std::array<std::string_view, 11> families{
    "EIGEN_",   "HVI_",   "SYS_",   "atomic_", "ei_",    "eigen_",
    "pthread_", "sigev_", "vec2d_", "vec4f_",  "vec4i_",
};

/// Macros of the standard library, of C, and of compilers for this and other systems; each followed
/// by a blank.
constexpr std::string_view others =
    "L_ctermid L_cuserid L_tmpnam P_tmpdir alloca assert assert_perror be16toh be32toh "
    "be64toh complex errno htobe16 htobe32 htobe64 htole16 htole32 htole64 i386 imaginary "
    "issubnormal kill_dependency le16toh le32toh le64toh linux major makedev math_errhandling "
    "minor mips offsetof sa_handler sa_sigaction sched_priority setjmp si_addr si_addr_lsb "
    "si_arch si_band si_call_addr si_fd si_int si_lower si_overrun si_pid si_pkey si_ptr "
    "si_status si_stime si_syscall si_timerid si_uid si_upper si_utime si_value sigmask "
    "sigsetjmp sparc st_atime st_ctime st_mtime stderr stdin stdout strdupa strndupa timeradd "
    "timerclear timercmp timerisset timersub unix va_arg va_copy va_end va_start ";

bool is_in(std::string_view list, std::string_view name) {
    for (std::size_t at = list.find(name); at != std::string_view::npos;
         at = list.find(name, at + 1)) {
        const bool begins_there = at == 0 || list[at - 1] == ' ';
        if (begins_there && list[at + name.size()] == ' ') { return true; }
    }
    return false;
}

/// Returns whether the name is an integer format of <cinttypes>, as `PRId64` is.
bool is_integer_format(std::string_view name) {
    constexpr std::string_view conversions = "bdioux";
    return (name.starts_with("PRI") || name.starts_with("SCN")) && name.size() > 3 &&
           conversions.find(name[3]) != std::string_view::npos;
}

/// Returns whether the name is a constant of <cmath> in one of several formats, as `M_PIf128` and
/// `M_El` are.
bool is_constant_in_format(std::string_view name) {
    constexpr std::array<std::string_view, 8> formats{"f16",  "f32",  "f64", "f128",
                                                      "f32x", "f64x", "f",   "l"};
    const auto is_in_format = [&](std::string_view format) {
        if (!name.ends_with(format)) { return false; }
        const std::string_view constant = name.substr(0, name.size() - format.size());
        return constant == "M_E" || (is_in_capitals(constant) && capitals_in(constant) > 2);
    };
    return name.starts_with("M_") && std::any_of(formats.begin(), formats.end(), is_in_format);
}

}  // namespace

bool is_spelled_as_macro(std::string_view name) {
    const bool is_constant = name.back() != '_' && is_in_capitals(name) && capitals_in(name) > 1;
    return is_constant || name.front() == '_' || name == "I";
}

bool is_macro(std::string_view name) {
    const auto begins_name = [&](std::string_view family) { return name.starts_with(family); };
    return is_spelled_as_macro(name) || is_integer_format(name) || is_constant_in_format(name) ||
           std::any_of(families.begin(), families.end(), begins_name) || is_in(others, name);
}

}  // namespace hvi::gen
