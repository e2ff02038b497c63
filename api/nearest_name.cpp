// SPDX-License-Identifier: Apache-2.0
#include "api/nearest_name.h"

#include <algorithm>

namespace bouguer::api {
namespace {

constexpr std::size_t kLongestWord = 40;  // longer words are not misspelt keys; bounds the work
constexpr std::size_t kLongestList = 20;

}  // namespace

std::size_t edit_distance(std::string_view a, std::string_view b) {
    // Three rows of the table of distances between prefixes: before last, last, this.
    std::vector<std::size_t> before(b.size() + 1);
    std::vector<std::size_t> last(b.size() + 1);
    std::vector<std::size_t> row(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        before.swap(last);
        last.swap(row);
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t change = a[i - 1] == b[j - 1] ? 0 : 1;
            row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + change});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
                row[j] = std::min(row[j], before[j - 2] + 1);
            }
        }
    }
    return row[b.size()];
}

std::string_view nearest_name(std::string_view word, const std::vector<std::string_view>& known) {
    std::string_view nearest;
    if (word.size() > kLongestWord) return nearest;
    std::size_t least = std::max<std::size_t>(1, word.size() / 3) + 1;
    for (const std::string_view name : known) {
        if (name.size() > word.size() + least || word.size() > name.size() + least) continue;
        const std::size_t distance = edit_distance(word, name);
        if (distance < least) {
            least = distance;
            nearest = name;
        }
    }
    return nearest;
}

std::string did_you_mean(std::string_view word, const std::vector<std::string_view>& known) {
    const std::string_view nearest = nearest_name(word, known);
    return nearest.empty() ? std::string() : " Did you mean \"" + std::string(nearest) + "\"?";
}

std::string quoted_list(const std::vector<std::string_view>& words) {
    std::string list;
    for (std::size_t i = 0; i < words.size() && i < kLongestList; ++i) {
        if (i > 0) list += ", ";
        list += '"';
        list += words[i];
        list += '"';
    }
    if (words.size() > kLongestList) list += " ...";
    return list;
}

}  // namespace bouguer::api
