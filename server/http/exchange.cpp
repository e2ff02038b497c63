// SPDX-License-Identifier: Apache-2.0
#include "server/http/exchange.h"

namespace bouguer::server {

AccessRecord access_record(const Exchange& exchange) {
    const std::chrono::duration<double, std::milli> spent = Clock::now() - exchange.arrived;
    return {.method = exchange.head.method.empty() ? "-" : exchange.head.method,
            .path = exchange.head.target.empty() ? "-" : exchange.head.target,
            .status = exchange.status,
            .milliseconds = spent.count(),
            .bytes = exchange.answer.size() + exchange.content.size(),
            .request_id = exchange.request_id,
            .client = exchange.client,
            .error = exchange.error};
}

}  // namespace bouguer::server
