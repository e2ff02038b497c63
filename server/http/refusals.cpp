// SPDX-License-Identifier: Apache-2.0
#include "server/http/refusals.h"

#include "server/http/plain_answer.h"

namespace bouguer::server {
namespace {

constexpr Refusal kUnreadable{500, "storage-failed", "A stored file cannot be read."};

}  // namespace

void answer_refusal(Exchange& exchange, const Refusal& refusal) {
    exchange.stream.reset();
    exchange.waiting.reset();
    exchange.content = {};
    exchange.status = refusal.status;
    exchange.answer = refusal_bytes(refusal, exchange.request_id);
    exchange.close = true;
}

void answer_unreadable(Exchange& exchange, const Error& why) {
    exchange.error = why.message;
    answer_refusal(exchange, kUnreadable);
}

}  // namespace bouguer::server
