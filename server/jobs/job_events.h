// SPDX-License-Identifier: Apache-2.0
// Hands what happens to jobs to whoever listens.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <vector>

#include "server/jobs/job_service.h"

namespace bouguer::server {

/// Every listener gets the events of its job in order, one at a time, without a lock held, from the
/// thread that published or from another that is publishing. After "done" it gets nothing more.
/// Thread-safe.
class JobEvents {
  public:
    JobEvents();
    ~JobEvents();

    /// What a listener is told first.
    struct Greeting {
        std::string snapshot;  ///< data of the "snapshot" event
        bool is_done = false;  ///< the job has ended: "done" with the same data follows at once
    };

    /// Registers `listener` and then asks for the greeting, so that what happens in between is not
    /// lost: it is delivered after the snapshot. Nothing is registered when there is no greeting.
    [[nodiscard]] Result<std::unique_ptr<Subscription>> subscribe(
        const JobId& id, EventListener listener, const std::function<Result<Greeting>()>& greet);

    void publish(const JobId& id, const std::string& type, const std::string& data);

    [[nodiscard]] std::size_t num_listeners() const;

  private:
    class Outbox;
    struct Registry;
    class Handle;

    const std::shared_ptr<Registry> registry_;  // shared with the handles, which may live longer
};

}  // namespace bouguer::server
