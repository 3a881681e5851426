// The names of macros, against what compilers say of the headers that they find.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <cstdio>
#include <cstdlib>
#include <set>
#include <sstream>
#include <string>

#include <catch2/catch.hpp>

#include "generator/emit/text/macros.hpp"
#include "generator/emit/text/names.hpp"

using namespace hvi::gen;

namespace {

/// Returns all headers of the standard library, with their names in C++ and in C, with Eigen and
/// other common headers. `<coroutine>` and `<stdatomic.h>` are refused in some modes.
std::string all_headers() {
    std::istringstream words(
        "algorithm any array atomic barrier bit bitset cassert cctype cerrno cfenv cfloat charconv "
        "chrono cinttypes climits clocale cmath codecvt compare complex concepts "
        "condition_variable csetjmp csignal cstdarg cstddef cstdint cstdio cstdlib cstring ctime "
        "cuchar cwchar cwctype deque exception execution filesystem format forward_list fstream "
        "functional future initializer_list iomanip ios iosfwd iostream istream iterator latch "
        "limits list locale map memory memory_resource mutex new numbers numeric optional ostream "
        "queue random ranges ratio regex scoped_allocator semaphore set shared_mutex "
        "source_location span sstream stack stdexcept stop_token streambuf string string_view "
        "strstream syncstream system_error thread tuple type_traits typeindex typeinfo "
        "unordered_map unordered_set utility valarray variant vector version assert.h complex.h "
        "ctype.h errno.h fenv.h float.h inttypes.h iso646.h limits.h locale.h math.h setjmp.h "
        "signal.h stdalign.h stdarg.h stdbool.h stddef.h stdint.h stdio.h stdlib.h string.h "
        "tgmath.h time.h uchar.h wchar.h wctype.h pthread.h sys/types.h unistd.h Eigen/Dense");
    std::string text;
    for (std::string word; words >> word;) {
        text += "#if __has_include(<" + word + ">)\n#include <" + word + ">\n#endif\n";
    }
    return text;
}

/// The macros that are defined behind the text. NOTE: warnings of old headers are not ours, nor is
/// oneTBB, which <execution> of libstdc++ includes where it is installed.
std::set<std::string> macros_behind(const std::string& text, const std::string& compiler,
                                    const std::string& standard) {
    const std::string command = "printf '%s' '" + text + "' | " + compiler + " -std=" + standard +
                                " -w -D_GLIBCXX_USE_TBB_PAR_BACKEND=0 -isystem " HVI_EIGEN
                                " -dM -E -x c++ - 2> /dev/null";
    std::set<std::string> names;
    FILE* const output = popen(command.c_str(), "r");
    REQUIRE(output != nullptr);
    std::string all;
    for (int c = std::fgetc(output); c != EOF; c = std::fgetc(output)) {
        all += static_cast<char>(c);
    }
    pclose(output);
    std::istringstream lines(all);
    for (std::string line; std::getline(lines, line);) {
        const std::string name = line.substr(8, line.find_first_of(" (", 8) - 8);
        names.insert(name);
    }
    return names;
}

bool has(const std::string& compiler) {
    return std::system((compiler + " --version > /dev/null 2>&1").c_str()) == 0;
}

/// Whether users may write a name: as a parameter, or, with a `_` before it, for a class. Include
/// guards, which <Eigen/Dense> defines too, do not count.
bool is_of_user(const std::string& name) {
    const bool is_reserved = name.front() == '_' && (name.size() < 2 || name[1] == '_' ||
                                                     (name[1] >= 'A' && name[1] <= 'Z'));
    return !is_reserved && name.find("_H_") == std::string::npos;
}

}  // namespace

TEST_CASE("no macro of a header of the standard library or of Eigen is a name in a header") {
    const std::string text = all_headers();
    for (const std::string compiler : {HVI_COMPILER, "g++", "clang++"}) {
        if (compiler != HVI_COMPILER && !has(compiler)) { continue; }
        for (const char* standard : {"c++17", "gnu++17", "c++20", "gnu++20"}) {
            CAPTURE(compiler, standard);
            const std::set<std::string> macros = macros_behind(text, compiler, standard);
            CHECK(macros.count("M_PI") + macros.count("EIGEN_MAX_ALIGN_BYTES") == 2);
            for (const std::string& name : macros) {
                if (!is_of_user(name)) { continue; }
                CAPTURE(name);
                CHECK(is_macro(name));
            }
        }
    }
}

TEST_CASE("names in capitals and with an underscore in front are taken for macros") {
    for (const char* name : {"EOF", "NULL", "M_PI", "E2BIG", "INT64_C", "ENDL", "GM", "PI", "M_SUN",
                             "_mm512_add_ps", "_x", "I"}) {
        CAPTURE(name);
        CHECK(is_spelled_as_macro(name));
        CHECK(is_macro(name));
        CHECK(member_name(name) == std::string(name) + "_");
        CHECK_THROWS_AS(check_class_name(name, {}), InputError);
        CHECK_NOTHROW(check_function_name(name, {}));
    }
}

TEST_CASE("one capital with digits, and what has letters in lower case, is none") {
    for (const char* name :
         {"mu",        "K",     "N",     "M",     "E",      "L",   "R",     "M1",   "M_1",
          "B12",       "K_1_2", "GMsun", "M_Sun", "M_Al",   "L_z", "V_max", "m_pi", "Errno",
          "assertion", "std",   "f",     "l",     "majors", "x_",  "GM_",   "PRIze"}) {
        CAPTURE(name);
        CHECK_FALSE(is_macro(name));
        CHECK(member_name(name) == name + std::string(name == std::string("std") ? "_" : ""));
        CHECK(is_macro("EIGEN_" + std::string(name)));
    }
}

TEST_CASE("the few macros that are spelled as variables are members of other names only") {
    for (const char* name : {"errno", "assert", "linux", "unix", "major", "minor", "i386",
                             "complex", "M_PIf64x", "M_El", "PRId64", "SCNuMAX", "SYS_read"}) {
        CAPTURE(name);
        CHECK_FALSE(is_spelled_as_macro(name));
        CHECK(is_macro(name));
        CHECK(member_name(name) == std::string(name) + "_");
        CHECK_THROWS_AS(check_class_name(name, {}), InputError);
        CHECK_NOTHROW(check_function_name(name, {}));
    }
}

TEST_CASE(
    "a function of the user's own may be spelled as a macro, since its header says that it is "
    "none") {
    for (const char* name : {"LJ", "V", "_x", "EAM_2"}) {
        CHECK_NOTHROW(check_own_function_name(name, {}));
    }
    for (const char* name : {"errno", "linux", "class", "__x", "_Big"}) {
        CHECK_THROWS_AS(check_own_function_name(name, {}), InputError);
    }
}
