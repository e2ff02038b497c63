// SPDX-License-Identifier: Apache-2.0
#include "renderer/geometry/shape.h"

#include <algorithm>
#include <utility>

namespace bouguer::renderer {

void NameList::add(std::string_view name) {
    constexpr std::size_t kMost = 24;
    constexpr std::size_t kLongest = 60;
    std::string shown(name.substr(0, kLongest));
    for (char& c : shown) {
        if ((c >= 0 && c < ' ') || c == '\x7f') c = '?';  // of terminals and logs
    }
    if (name.size() > kLongest) shown += "...";
    if (std::find(names_.begin(), names_.end(), shown) != names_.end()) return;
    if (names_.size() < kMost) {
        names_.push_back(std::move(shown));
    } else {
        has_more_ = true;
    }
}

std::string NameList::text() const {
    std::string all;
    for (const std::string& name : names_) all += (all.empty() ? "" : ", ") + name;
    return has_more_ ? all + ", ..." : all;
}

}  // namespace bouguer::renderer
