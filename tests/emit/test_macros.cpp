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

/// All headers of the standard library, as C++ and as C name them, with Eigen and what is often
/// included beside them. `<coroutine>` and `<stdatomic.h>` are refused in some modes.
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

/// The macros that are defined behind the text. NOTE: warnings of old headers are not ours.
std::set<std::string> macros_behind(const std::string& text, const std::string& compiler,
                                    const std::string& standard) {
    const std::string command = "printf '%s' '" + text + "' | " + compiler + " -std=" + standard +
                                " -w -isystem " HVI_EIGEN " -dM -E -x c++ - 2> /dev/null";
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

/// Whether users can write it: as a parameter, or else, with a `_` before it, for a class.
bool is_of_user(const std::string& name) {
    const bool is_reserved = name.front() == '_' && (name.size() < 2 || name[1] == '_' ||
                                                     (name[1] >= 'A' && name[1] <= 'Z'));
    return !is_reserved;
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
                CHECK(member_name(name) != name);
                CHECK_THROWS_AS(check_class_name(name, {}), InputError);
                CHECK_THROWS_AS(check_function_name(name, {}), InputError);
            }
        }
    }
}

TEST_CASE("what only looks like a macro is none") {
    for (const char* name : {"mu", "GM", "K", "N", "M", "E", "EPS", "SIGMA", "M_SUN", "M_1", "PI",
                             "PRIMARY", "FE", "m_pi", "Errno", "assertion", "std", "f", "l"}) {
        CAPTURE(name);
        CHECK_FALSE(is_macro(name));
        CHECK(is_macro("EIGEN_" + std::string(name)));
    }
}

TEST_CASE("macros of other systems, and of releases to come") {
    for (const char* name :
         {"i386", "WIN32", "minor", "M_PIf64x", "M_EGAMMA", "SYS_new", "PRIb64"}) {
        CAPTURE(name);
        CHECK(is_macro(name));
    }
}
