// What every generated header takes of the runtime, unless it has a copy of what it needs.
// SPDX-License-Identifier: MIT
#pragma once

#include <hvi/detail/coefficients/coefficients.hpp>
#include <hvi/detail/coefficients/rounded.hpp>
#include <hvi/detail/numbers/arithmetic.hpp>
#include <hvi/detail/numbers/scalar.hpp>
#include <hvi/detail/stages/system.hpp>
#include <hvi/state.hpp>
#include <hvi/version.hpp>
