// SPDX-License-Identifier: Apache-2.0
// What is valid and yet probably not meant.
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace bouguer {

/// One warning. It changes neither what is rendered nor how a request is answered.
struct Warning {
    std::string pointer;  ///< where: RFC 6901 JSON pointer into the document; "" is the whole of it
    std::string code;     ///< stable, for programs: "unused-material", "mesh-open" ...
    std::string detail;   ///< for people: what is so, one sentence
    std::string advice;   ///< for people: what to do about it
    bool operator==(const Warning&) const = default;
};

/// Warnings in the order in which they came. Of very many the first are listed and the others
/// counted.
class Warnings {
  public:
    static constexpr std::size_t kMostListed = 100;

    void add(Warning warning) {
        if (++count_ <= kMostListed) listed_.push_back(std::move(warning));
    }
    void add(const Warnings& others) {
        for (const Warning& warning : others.listed_) add(warning);
        count_ += others.count_ - others.listed_.size();
    }
    [[nodiscard]] const std::vector<Warning>& listed() const { return listed_; }
    [[nodiscard]] std::size_t count() const { return count_; }

  private:
    std::size_t count_ = 0;
    std::vector<Warning> listed_;
};

}  // namespace bouguer
