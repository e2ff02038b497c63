// SPDX-License-Identifier: Apache-2.0
#include "server/cli/stop_signal.h"

#include <signal.h>
#include <time.h>

#include <initializer_list>

namespace bouguer::server {
namespace {

sigset_t stop_signals() {
    sigset_t set;
    sigemptyset(&set);
    sigaddset(&set, SIGINT);
    sigaddset(&set, SIGTERM);
    return set;
}

void dispose(void (*action)(int)) {
    for (const int signal : {SIGHUP, SIGUSR1, SIGUSR2}) (void)::signal(signal, action);
}

}  // namespace

IgnoredSignals::IgnoredSignals() { dispose(SIG_IGN); }
IgnoredSignals::~IgnoredSignals() { dispose(SIG_DFL); }

StopSignal::StopSignal() {
    const sigset_t set = stop_signals();
    pthread_sigmask(SIG_BLOCK, &set, nullptr);
}

StopSignal::~StopSignal() { let_the_next_one_kill(); }

void StopSignal::let_the_next_one_kill() {
    has_come_ = true;
    const sigset_t set = stop_signals();
    pthread_sigmask(SIG_UNBLOCK, &set, nullptr);
}

void StopSignal::wait() {
    const sigset_t set = stop_signals();
    int signal = 0;
    while (!has_come_) {
        if (sigwait(&set, &signal) == 0) let_the_next_one_kill();
    }
}

bool StopSignal::has_come() {
    if (has_come_) return true;
    const sigset_t set = stop_signals();
    const timespec at_once{0, 0};
    if (sigtimedwait(&set, nullptr, &at_once) > 0) let_the_next_one_kill();
    return has_come_;
}

}  // namespace bouguer::server
