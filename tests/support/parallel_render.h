// SPDX-License-Identifier: Apache-2.0
// Drives a render to its end on several threads, as plainly as can be.
#pragma once

#include <chrono>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

#include "renderer/film/unit_result.h"
#include "renderer/render.h"

namespace bouguer::test {

/// Seconds that it took. `after_pass`, when given, is called under the lock at the end of every
/// pass.
inline double run_to_end(renderer::Render& render, int threads,
                         const std::function<void()>& after_pass = {}) {
    using Clock = std::chrono::steady_clock;
    const auto start = Clock::now();
    const auto elapsed = [&] {
        return std::chrono::duration<double>(Clock::now() - start).count();
    };
    std::mutex mutex;
    const auto work = [&] {
        while (true) {
            std::unique_lock lock(mutex);
            if (render.finished()) return;
            const auto unit = render.next_unit();
            lock.unlock();
            if (!unit) {
                std::this_thread::yield();
                continue;
            }
            render.trace(*unit);
            lock.lock();
            if (render.merge(*unit, elapsed()) && after_pass) after_pass();
        }
    };
    std::vector<std::thread> pool;
    for (int i = 0; i < threads; ++i) pool.emplace_back(work);
    for (std::thread& thread : pool) thread.join();
    return elapsed();
}

}  // namespace bouguer::test
