// The fields of schema hvi-check/1.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "generator/certify/certificate.hpp"
#include "generator/render/json_entry.hpp"

namespace hvi::gen {

[[nodiscard]] Json certificate_json(const Certificate& certificate);

}  // namespace hvi::gen
