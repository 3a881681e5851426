// What the fuzzer and the replay of its findings call: every reader of text, by name.
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
void hamiltonian(std::string_view bytes);  ///< H, coordinates and momenta, each on a line

}  // namespace hvi::gen::fuzz
