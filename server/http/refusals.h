// SPDX-License-Identifier: Apache-2.0
// Answers of the front's own, in place of one that a route has given or would have.
#pragma once

#include "renderer/core/result.h"
#include "server/http/exchange.h"

namespace bouguer::server {

/// The answer becomes `refusal`, and the connection ends with it.
void answer_refusal(Exchange& exchange, const Refusal& refusal);

/// The same because the file to be sent cannot be read; `why` is for the log.
void answer_unreadable(Exchange& exchange, const Error& why);

}  // namespace bouguer::server
