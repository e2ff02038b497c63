// SPDX-License-Identifier: Apache-2.0
// What is valid and yet probably not meant.
#pragma once

#include <cstddef>
#include <map>
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

/// Warnings in the order in which they came. Of very many with one code the first are listed and
/// the others counted, so that a thousand of one kind hide no other. There are some tens of codes.
class Warnings {
  public:
    static constexpr std::size_t kMostOfOneCode = 20;

    void add(Warning warning) {
        ++count_;
        if (++of_code_[warning.code] <= kMostOfOneCode) listed_.push_back(std::move(warning));
    }
    void add(const Warnings& others) {
        for (const Warning& warning : others.listed_) add(warning);
        for (const auto& [code, count] : others.unlisted()) {
            count_ += count;
            of_code_[code] += count;
        }
    }
    [[nodiscard]] const std::vector<Warning>& listed() const { return listed_; }
    [[nodiscard]] std::size_t count() const { return count_; }

    /// How many of a code are counted only; codes with none are left out.
    [[nodiscard]] std::map<std::string, std::size_t> unlisted() const {
        std::map<std::string, std::size_t> more = of_code_;
        for (const Warning& warning : listed_) --more[warning.code];
        std::erase_if(more, [](const auto& entry) { return entry.second == 0; });
        return more;
    }

    /// That there are more than are listed, with how many of which code; only where unlisted() is
    /// not empty.
    [[nodiscard]] Warning about_unlisted() const {
        std::string codes;
        for (const auto& [code, count] : unlisted())
            codes += (codes.empty() ? "" : ", ") + std::to_string(count) + " of " + code;
        return {"", "more-warnings", "more than are listed: " + codes,
                "mend those that are listed first"};
    }

  private:
    std::size_t count_ = 0;
    std::map<std::string, std::size_t> of_code_;
    std::vector<Warning> listed_;
};

}  // namespace bouguer
