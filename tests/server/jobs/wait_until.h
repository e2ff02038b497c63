// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

namespace bouguer::server {

/// Waits until `condition`; fails the test after 20 s.
template <class Condition>
void wait_until(Condition condition) {
    for (int i = 0; i < 20'000; ++i) {
        if (condition()) return;
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    FAIL() << "it did not happen";
}

}  // namespace bouguer::server
