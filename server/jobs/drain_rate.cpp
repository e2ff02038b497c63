// SPDX-License-Identifier: Apache-2.0
#include "server/jobs/drain_rate.h"

#include <algorithm>
#include <cmath>

namespace bouguer::server {
namespace {

constexpr double kMemory_s = 60;

}  // namespace

DrainRate::Measure DrainRate::brought_to(Clock::time_point now, Measure measure) {
    if (measure.jobs > 0) {  // idle time changes nothing
        const double passed_s = std::chrono::duration<double>(now - measure.at).count();
        const double kept = std::exp(-std::max(passed_s, 0.0) / kMemory_s);
        measure.ends *= kept;
        // the integral of the weight over the time that has passed
        measure.busy_s = measure.busy_s * kept + kMemory_s * (1 - kept);
    }
    measure.at = std::max(now, measure.at);
    return measure;
}

void DrainRate::begin(Clock::time_point now) {
    const std::lock_guard lock(mutex_);
    measure_ = brought_to(now, measure_);
    ++measure_.jobs;
}

void DrainRate::end(Clock::time_point now) {
    const std::lock_guard lock(mutex_);
    measure_ = brought_to(now, measure_);
    if (measure_.jobs > 0) --measure_.jobs;
    measure_.ends += 1;
    measure_.ends_seen = std::min(measure_.ends_seen + 1, kFewestEnds);
}

int DrainRate::seconds_to_drain(Clock::time_point now) const {
    const std::lock_guard lock(mutex_);
    if (measure_.jobs == 0) return kLeast_s;
    if (measure_.ends_seen < kFewestEnds) return kUnmeasured_s;
    const Measure present = brought_to(now, measure_);
    // when nothing has ended for long, as if one ended now
    const double a_job_s = present.busy_s / std::max(present.ends, 1.0);
    const double all_s = std::ceil(static_cast<double>(present.jobs) * a_job_s);
    return static_cast<int>(std::clamp<double>(all_s, kLeast_s, kMost_s));
}

}  // namespace bouguer::server
