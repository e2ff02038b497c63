// SPDX-License-Identifier: Apache-2.0
#include "api/json_tree.h"

#include <algorithm>
#include <bit>

namespace bouguer::api {

using Kind = JsonNode::Kind;

double Json::number() const {
    if (node_.kind == Kind::Float) return std::bit_cast<double>(node_.content);
    if (node_.kind == Kind::Large) return static_cast<double>(node_.content);
    return static_cast<double>(std::bit_cast<std::int64_t>(node_.content));
}

std::optional<std::int64_t> Json::integer() const {
    if (node_.kind != Kind::Integer) return std::nullopt;
    return std::bit_cast<std::int64_t>(node_.content);
}

std::string_view Json::text() const {
    return std::string_view(store_->chars).substr(node_.content, node_.size);
}

std::size_t Json::size() const { return is_array() || is_object() ? node_.size : 0; }

Json Json::packed_number(std::uint64_t at) const {
    const double x = store_->numbers[at];
    const bool is_whole = store_->is_whole[at];
    const auto content = is_whole ? std::bit_cast<std::uint64_t>(static_cast<std::int64_t>(x))
                                  : std::bit_cast<std::uint64_t>(x);
    return {*store_, {is_whole ? Kind::Integer : Kind::Float, 0, 0, content}};
}

Json Json::operator[](std::size_t index) const {
    if (node_.kind == Kind::Numbers) return packed_number(node_.content + index);
    if (node_.kind == Kind::Array) return {*store_, store_->nodes[node_.content + index]};
    return {*store_, {Kind::Numbers, 0, node_.width, node_.content + index * node_.width}};
}

std::span<const double> Json::packed_numbers() const {
    if (node_.kind != Kind::Numbers) return {};
    return std::span(store_->numbers).subspan(node_.content, node_.size);
}

std::span<const JsonMember> Json::member_span() const {
    if (!is_object()) return {};
    return std::span(store_->members).subspan(node_.content, node_.size);
}

Json::Members Json::members() const { return {*store_, member_span()}; }

std::optional<Json> Json::find(std::string_view key) const {
    const auto members = member_span();
    const auto it = std::lower_bound(members.begin(), members.end(), key,
                                     [&](const JsonMember& member, std::string_view wanted) {
                                         return Json(*store_, member.key).text() < wanted;
                                     });
    if (it == members.end() || Json(*store_, it->key).text() != key) return std::nullopt;
    return Json(*store_, it->value);
}

}  // namespace bouguer::api
