// SPDX-License-Identifier: Apache-2.0
#include "server/http/negotiation.h"

#include <algorithm>
#include <charconv>

#include "server/http/field_syntax.h"

namespace bouguer::server {
namespace {

/// Cuts the part before `separator` off the front.
std::string_view next_part(std::string_view& rest, char separator) {
    const auto end = std::min(rest.find(separator), rest.size());
    const std::string_view part = trimmed(rest.substr(0, end));
    rest.remove_prefix(std::min(end + 1, rest.size()));
    return part;
}

struct MediaRange {
    std::string_view type;
    double quality = 1;
};

MediaRange parse_range(std::string_view text) {
    MediaRange range{next_part(text, ';'), 1};
    while (!text.empty()) {
        const std::string_view parameter = next_part(text, ';');
        if (parameter.size() < 3 || !equal_ignoring_case(parameter.substr(0, 2), "q=")) continue;
        const char* begin = parameter.data() + 2;
        const char* end = parameter.data() + parameter.size();
        if (std::from_chars(begin, end, range.quality).ec != std::errc{}) range.quality = 0;
    }
    range.quality = std::clamp(range.quality, 0.0, 1.0);
    return range;
}

/// 3: the type itself, 2: type/*, 1: */*, 0: no match.
int specificity(std::string_view range, std::string_view offer) {
    if (equal_ignoring_case(range, offer)) return 3;
    if (range == "*/*") return 1;
    const auto slash = offer.find('/');
    const bool subtype_free = range.size() == slash + 2 && range.substr(slash) == "/*";
    return subtype_free && equal_ignoring_case(range.substr(0, slash), offer.substr(0, slash)) ? 2
                                                                                               : 0;
}

/// The quality that the most specific matching range gives the offer.
double quality_of(std::string_view offer, std::string_view accept) {
    int best = 0;
    double quality = 0;
    while (!accept.empty()) {
        const MediaRange range = parse_range(next_part(accept, ','));
        const int match = specificity(range.type, offer);
        if (match > best) {
            best = match;
            quality = range.quality;
        }
    }
    return quality;
}

}  // namespace

std::optional<std::size_t> negotiate(std::string_view accept,
                                     std::span<const std::string_view> offers) {
    if (trimmed(accept).empty()) return 0;
    std::optional<std::size_t> chosen;
    double best = 0;
    for (std::size_t i = 0; i < offers.size(); ++i) {
        const double quality = quality_of(offers[i], accept);
        if (quality > best) {
            best = quality;
            chosen = i;
        }
    }
    return chosen;
}

}  // namespace bouguer::server
