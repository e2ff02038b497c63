// SPDX-License-Identifier: Apache-2.0
// The query of a target: its parameters, and how they are refused.
#pragma once

#include <httplib.h>

#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "renderer/core/result.h"

namespace bouguer::server {

/// The parameters of a target [WHATWG URL, application/x-www-form-urlencoded], each as often as it
/// is there: the HTTP library drops the second of two alike. `target` is well percent-encoded.
[[nodiscard]] httplib::Params params_of(std::string_view target);

/// A refusal of one parameter: 422, code "invalid-query".
[[nodiscard]] Error bad_parameter(const std::string& name, std::string code, std::string found,
                                  std::string allowed);

/// What a reader of texts by name (api/output_texts.h) refused, as a refusal of parameters.
[[nodiscard]] Error bad_query(Error error);

/// Every parameter with its text. A parameter that is there twice is refused. `v` is left out: it
/// has no meaning, so that a page can change an address and have its browser ask again.
[[nodiscard]] Result<std::map<std::string, std::string>> query_of(const httplib::Request& request);

/// Takes `name` out of `query`. Refused when it is not there; `allowed` says what it should be.
[[nodiscard]] Result<std::string> take_required(std::map<std::string, std::string>& query,
                                                const std::string& name,
                                                const std::string& allowed);

/// Takes `name` out of `query`; nothing when it is not there.
[[nodiscard]] std::optional<std::string> take_optional(std::map<std::string, std::string>& query,
                                                       const std::string& name);

/// Refuses what nobody has taken out of `query`: every parameter by its name.
[[nodiscard]] Result<void> expect_empty(const std::map<std::string, std::string>& query);

}  // namespace bouguer::server
