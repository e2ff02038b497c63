// SPDX-License-Identifier: Apache-2.0
// The rays of one sample that are still to be followed, the heaviest first.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <vector>

#include "renderer/core/hash.h"
#include "renderer/integrators/throughput.h"
#include "renderer/media/interface.h"

namespace bouguer::renderer {

/// A ray's place in the tree of rays. The throughput of its slot is the weight with which it
/// reaches the camera.
struct Path {
    int depth = 0;
    std::uint64_t node = 1;       ///< names the place
    MediumStack media;            ///< the bodies around the ray
    bool one_wavelength = false;  ///< the others ended where an index parted them
    double weight = 1;            ///< the largest number of it, before absorption on the way
};

struct PendingRay {
    RayStart start;
    Vec3 d;
    Path path;
    std::size_t slot = 0;
};

/// Keeps its memory from sample to sample. Not thread-safe.
class RayQueue {
  public:
    explicit RayQueue(std::size_t blocks) : blocks_(blocks) {}

    /// A ray that is not waiting yet, with a throughput of its own; stays where it is until
    /// released.
    PendingRay& open() {
        if (free_.empty()) {
            const std::size_t slot = rays_.size();
            rays_.emplace_back().slot = slot;
            free_.push_back(slot);
            throughputs_.emplace_back(blocks_);
        }
        PendingRay& ray = rays_[free_.back()];
        free_.pop_back();
        return ray;
    }
    void release(const PendingRay& ray) { free_.push_back(ray.slot); }

    void add(const PendingRay& ray) {
        waiting_.push_back({ray.path.weight, number_++, ray.slot});
        std::push_heap(waiting_.begin(), waiting_.end());
    }
    [[nodiscard]] bool empty() const { return waiting_.empty(); }
    /// The heaviest; of equal ones that which came first. To be released.
    PendingRay& take() {
        std::pop_heap(waiting_.begin(), waiting_.end());
        PendingRay& ray = rays_[waiting_.back().slot];
        waiting_.pop_back();
        return ray;
    }
    void clear() {
        for (const Waiting& waiting : waiting_) free_.push_back(waiting.slot);
        waiting_.clear();
        number_ = 0;
    }

    [[nodiscard]] Throughput& throughput(const PendingRay& ray) { return throughputs_[ray.slot]; }

  private:
    struct Waiting {
        double weight = 0;
        std::uint64_t number = 0;
        std::size_t slot = 0;
        bool operator<(const Waiting& b) const {
            return weight != b.weight ? weight < b.weight : number > b.number;
        }
    };

    std::size_t blocks_;
    std::deque<PendingRay> rays_;
    std::deque<Throughput> throughputs_;  ///< by slot
    std::vector<std::size_t> free_;
    std::vector<Waiting> waiting_;  ///< a heap
    std::uint64_t number_ = 0;
};

}  // namespace bouguer::renderer
