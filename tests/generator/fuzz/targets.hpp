// Targets that the fuzzer and the replay of its findings call: every reader of text, by name.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string_view>

namespace hvi::gen::fuzz {

// Each takes any bytes and returns: they are read, or refused with an InputError or MathError. What
// is read is also printed, and must read the same again. Anything else ends with an exception or an
// abort: it is a bug.

void expression(std::string_view bytes);
void list(std::string_view bytes);
void name(std::string_view bytes);
void parameter(std::string_view bytes);
void method_file(std::string_view bytes);
void coefficients(std::string_view bytes);
void scene(std::string_view bytes);
void rows(std::string_view bytes);         ///< of numbers, in a file
void hamiltonian(std::string_view bytes);  ///< H, coordinates and momenta, each on a line

// Targets of the whole program. The input has the words of a command line, each on a line of its
// own, and `""` for an empty one; behind an empty line there may be the text of a file, which the
// word FILE names. Beside it is V.hpp, for a function of the scene's own.

void command_line(std::string_view bytes);  ///< is only read
void command(std::string_view bytes);       ///< is carried out, but for what needs a compiler

// Bytes choose a text of a grammar: see grammars.hpp. With the environment's HVI_FUZZ_SHOW it is
// printed.

void derived_command_line(std::string_view bytes);
void derived_method(std::string_view bytes);
void derived_scene(std::string_view bytes);
void derived_search(std::string_view bytes);
void derived_tableau_file(std::string_view bytes);

}  // namespace hvi::gen::fuzz
