// The fields of schema hvi-check/1.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>

#include "generator/certify/certificate.hpp"
#include "generator/render/json_entry.hpp"
#include "generator/render/statements.hpp"

namespace hvi::gen {

[[nodiscard]] Json certificate_json(const Certificate& certificate);

// Common parts of the certificates of tableaux and of the general form.
[[nodiscard]] Json failures_json(const OrderConditions& conditions);
[[nodiscard]] Json error_constant_json(const OrderConditions& conditions);
[[nodiscard]] Json exceptions_json(const std::vector<ExceptionalValue>& exceptions);
[[nodiscard]] Json stability_json(const Findings& findings);
void add_statements(Json& certificate, const std::optional<SceneStatements>& scene);

}  // namespace hvi::gen
