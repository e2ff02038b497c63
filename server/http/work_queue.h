// SPDX-License-Identifier: Apache-2.0
// In which order complete requests come to the handler threads: clients take turns, and what costs
// much never has all the threads.
#pragma once

#include <array>
#include <deque>
#include <list>
#include <memory>
#include <string>
#include <unordered_map>

#include "server/http/exchange.h"

namespace bouguer::server {

/// What a request may cost, judged by its body: reading a document or storing a file takes long in
/// proportion to it.
enum class Weight { Light, Document, Heavy };

/// Above this many bytes of body a request is Heavy.
constexpr std::size_t kHeavyBody = 256U << 10U;

[[nodiscard]] inline Weight weight_of(const Exchange& exchange) {
    if (exchange.body.empty()) return Weight::Light;
    return exchange.body.size() > kHeavyBody ? Weight::Heavy : Weight::Document;
}

/// Requests that wait. Heavy ones are begun on at most half of the threads and one at a time of a
/// client; with documents together they leave one thread to what has no body. Of one weight the
/// clients take turns. Not thread-safe.
class WorkQueue {
  public:
    struct Limits {
        int threads = 1;
        std::size_t waiting = 1;  ///< requests of all clients
        std::size_t share = 1;    ///< of one client
    };
    /// What was begun, to be given back to end().
    struct Work {
        std::unique_ptr<Exchange> exchange;
        Weight weight = Weight::Light;
        std::string client;
    };

    explicit WorkQueue(const Limits& limits) : limits_(limits) {}

    /// False, and `exchange` stays with the caller, when as many as are allowed wait.
    [[nodiscard]] bool push(std::unique_ptr<Exchange>& exchange);
    /// The next that may be begun; without an exchange when there is none.
    [[nodiscard]] Work begin();
    void end(const Work& work);

  private:
    /// Those of one client, in the order in which they came.
    struct Client {
        std::string name;
        std::deque<std::unique_ptr<Exchange>> waiting;
    };
    /// Clients with something of one weight to do; the first has the next turn.
    using Line = std::list<Client>;
    static constexpr std::size_t kWeights = 3;

    [[nodiscard]] bool may_begin(Weight weight) const;
    [[nodiscard]] Line::iterator next_client(Weight weight);
    Work take(Weight weight, Line::iterator client);

    const Limits limits_;
    std::array<Line, kWeights> lines_;
    std::array<int, kWeights> under_way_{};
    std::unordered_map<std::string, std::size_t> waiting_of_;  ///< client -> requests; none with 0
    std::size_t waiting_ = 0;
    std::list<std::string> busy_clients_;  ///< with a heavy request under way: a few at most
    std::size_t turn_ = 0;                 ///< the weight that is looked at first
};

}  // namespace bouguer::server
