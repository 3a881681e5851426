// The properties of a method, for people and programs.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>
#include <string>

#include "generator/certify/audit.hpp"
#include "generator/certify/rule_certificate.hpp"
#include "generator/certify/swept_certificate.hpp"
#include "generator/render/statements.hpp"

namespace hvi::gen {

/// Writes for a terminal of 80 columns. Ends with the conserved quantities of a scene that the
/// method keeps, where a scene is given.
[[nodiscard]] std::string render_text(const Certificate& certificate,
                                      const std::optional<SceneStatements>& scene = {});

/// Writes the schema `hvi-check/1`, with members for the conserved quantities of a scene.
[[nodiscard]] std::string render_json(const Certificate& certificate,
                                      const std::optional<SceneStatements>& scene = {});

/// Write the certificate of the general form: properties of partitioned methods are null in JSON.
[[nodiscard]] std::string render_text(const RuleCertificate& certificate,
                                      const std::optional<SceneStatements>& scene = {});
[[nodiscard]] std::string render_json(const RuleCertificate& certificate,
                                      const std::optional<SceneStatements>& scene = {});

/// Write the certificate of counted sweeps: properties of steps to round-off are false in JSON.
[[nodiscard]] std::string render_text(const SweptCertificate& certificate,
                                      const std::optional<SceneStatements>& scene = {});
[[nodiscard]] std::string render_json(const SweptCertificate& certificate,
                                      const std::optional<SceneStatements>& scene = {});

/// Write the audit of a tableau from another source; it is the member `audit` in JSON.
[[nodiscard]] std::string render_text(const Audit& audit,
                                      const std::optional<SceneStatements>& scene = {});
[[nodiscard]] std::string render_json(const Audit& audit,
                                      const std::optional<SceneStatements>& scene = {});

}  // namespace hvi::gen
