// SPDX-License-Identifier: Apache-2.0
#include "server/http/work_queue.h"

#include <algorithm>

namespace bouguer::server {
namespace {

constexpr auto kDocument = static_cast<std::size_t>(Weight::Document);
constexpr auto kHeavy = static_cast<std::size_t>(Weight::Heavy);

}  // namespace

bool WorkQueue::push(std::unique_ptr<Exchange>& exchange) {
    if (waiting_ >= limits_.waiting) return false;
    const std::string& name = exchange->client_key;
    const auto own = waiting_of_.try_emplace(name, 0).first;
    if (own->second >= limits_.share) return false;
    Line& line = lines_[static_cast<std::size_t>(weight_of(*exchange))];
    auto client =
        std::find_if(line.begin(), line.end(), [&](const Client& c) { return c.name == name; });
    if (client == line.end()) client = line.insert(line.end(), Client{name, {}});
    client->waiting.push_back(std::move(exchange));
    ++own->second;
    ++waiting_;
    return true;
}

bool WorkQueue::may_begin(Weight weight) const {
    const int left_to_light = std::max(1, limits_.threads - 1);
    if (weight == Weight::Light) return true;
    if (under_way_[kDocument] + under_way_[kHeavy] >= left_to_light) return false;
    return weight == Weight::Document || under_way_[kHeavy] < std::max(1, limits_.threads / 2);
}

WorkQueue::Line::iterator WorkQueue::next_client(Weight weight) {
    Line& line = lines_[static_cast<std::size_t>(weight)];
    if (!may_begin(weight)) return line.end();
    if (weight != Weight::Heavy) return line.begin();
    return std::find_if(line.begin(), line.end(), [this](const Client& c) {
        return std::find(busy_clients_.begin(), busy_clients_.end(), c.name) == busy_clients_.end();
    });
}

WorkQueue::Work WorkQueue::begin() {
    for (std::size_t i = 0; i < kWeights; ++i) {
        const auto weight = static_cast<Weight>((turn_ + i) % kWeights);
        const auto client = next_client(weight);
        if (client == lines_[static_cast<std::size_t>(weight)].end()) continue;
        turn_ = (static_cast<std::size_t>(weight) + 1) % kWeights;
        return take(weight, client);
    }
    return {};
}

WorkQueue::Work WorkQueue::take(Weight weight, Line::iterator client) {
    Line& line = lines_[static_cast<std::size_t>(weight)];
    // all that may throw comes first
    Work work{nullptr, weight, client->name};
    if (weight == Weight::Heavy) busy_clients_.push_back(client->name);
    work.exchange = std::move(client->waiting.front());
    client->waiting.pop_front();
    client->waiting.empty() ? void(line.erase(client)) : line.splice(line.end(), line, client);
    ++under_way_[static_cast<std::size_t>(weight)];
    --waiting_;
    const auto own = waiting_of_.find(work.client);
    if (--own->second == 0) waiting_of_.erase(own);
    return work;
}

void WorkQueue::end(const Work& work) {
    --under_way_[static_cast<std::size_t>(work.weight)];
    if (work.weight != Weight::Heavy) return;
    busy_clients_.remove(work.client);  // each stands there once
}

}  // namespace bouguer::server
