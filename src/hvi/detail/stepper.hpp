// Includes of every generated header that carries no copy of the runtime.
// SPDX-License-Identifier: MIT
#pragma once

#include <hvi/detail/coefficients/coefficients.hpp>
#include <hvi/detail/coefficients/rounded.hpp>
#include <hvi/detail/numbers/arithmetic.hpp>
#include <hvi/detail/numbers/scalar.hpp>
#include <hvi/detail/stages/system.hpp>
#include <hvi/state.hpp>
#include <hvi/version.hpp>
