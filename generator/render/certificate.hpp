// What a method can do, for people and programs.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>

#include "generator/certify/audit.hpp"
#include "generator/certify/rule_certificate.hpp"

namespace hvi::gen {

/// For a terminal of 80 columns.
[[nodiscard]] std::string render_text(const Certificate& certificate);

/// The schema `hvi-check/1`.
[[nodiscard]] std::string render_json(const Certificate& certificate);

/// The same of the general form: what is asked of partitioned methods is null in JSON.
[[nodiscard]] std::string render_text(const RuleCertificate& certificate);
[[nodiscard]] std::string render_json(const RuleCertificate& certificate);

/// The same with what was found out about a tableau that someone else made: in JSON under `audit`.
[[nodiscard]] std::string render_text(const Audit& audit);
[[nodiscard]] std::string render_json(const Audit& audit);

}  // namespace hvi::gen
