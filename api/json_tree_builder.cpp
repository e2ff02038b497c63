// SPDX-License-Identifier: Apache-2.0
#include "api/json_tree_builder.h"

#include <algorithm>
#include <bit>
#include <limits>
#include <utility>

#include "api/problems.h"

namespace bouguer::api {
namespace {

using Kind = JsonNode::Kind;

/// Objects with more keys than this look them up in a set.
constexpr std::uint32_t kFewKeys = 16;
constexpr std::int64_t kExact = 1LL << 53;  // beyond, doubles are not every integer
constexpr std::uint32_t kWidest = std::numeric_limits<std::uint16_t>::max();

}  // namespace

// The reservations cost address space alone: pages that are not written are not there. Strings must
// not move, because keys are looked up by views of them.
JsonTreeBuilder::JsonTreeBuilder(std::size_t text_bytes) : store_(std::make_unique<JsonStore>()) {
    store_->chars.reserve(text_bytes);
    store_->numbers.reserve(text_bytes / 2 + 1);  // a digit and what separates it from the next
    store_->is_whole.reserve(text_bytes / 2 + 1);
}

void JsonTreeBuilder::add_boolean(bool value) { place({Kind::Boolean, 0, 0, value ? 1U : 0U}); }

void JsonTreeBuilder::add_integer(std::int64_t value) {
    const JsonNode node{Kind::Integer, 0, 0, std::bit_cast<std::uint64_t>(value)};
    if (-kExact <= value && value <= kExact) {
        add_number(node, static_cast<double>(value), true);
    } else {
        place(node);
    }
}

void JsonTreeBuilder::add_large(std::uint64_t value) { place({Kind::Large, 0, 0, value}); }

void JsonTreeBuilder::add_float(double value) {
    add_number({Kind::Float, 0, 0, std::bit_cast<std::uint64_t>(value)}, value, false);
}

void JsonTreeBuilder::add_text(std::string_view value) { place(stored_text(value)); }

JsonNode JsonTreeBuilder::stored_text(std::string_view text) {
    const std::uint64_t begin = store_->chars.size();
    store_->chars += text;
    return {Kind::String, 0, static_cast<std::uint32_t>(text.size()), begin};
}

std::string_view JsonTreeBuilder::text_of(const JsonNode& string) const {
    return std::string_view(store_->chars).substr(string.content, string.size);
}

void JsonTreeBuilder::add_number(const JsonNode& node, double value, bool is_whole) {
    const bool is_packed =
        !levels_.empty() && !levels_.back().is_object && levels_.back().packing <= Packing::Numbers;
    if (!is_packed) return place(node);
    Level& array = levels_.back();
    if (array.packing == Packing::Nothing) array.first = store_->numbers.size();
    array.packing = Packing::Numbers;
    store_->numbers.push_back(value);
    store_->is_whole.push_back(is_whole);
    ++array.size;
}

void JsonTreeBuilder::open_object() {
    levels_.emplace_back();
    levels_.back().is_object = true;
    levels_.back().first = members_.size();
}

void JsonTreeBuilder::open_array() { levels_.emplace_back(); }

bool JsonTreeBuilder::has_key(const Level& object, std::string_view key) const {
    if (object.size > kFewKeys) return object.keys.contains(key);
    return std::any_of(members_.begin() + static_cast<std::ptrdiff_t>(object.first), members_.end(),
                       [&](const JsonMember& member) { return text_of(member.key) == key; });
}

bool JsonTreeBuilder::key(std::string_view key) {
    Level& object = levels_.back();
    const bool is_new = !has_key(object, key);
    members_.push_back({stored_text(key), {}});
    ++object.size;
    if (object.size == kFewKeys + 1) {
        for (std::size_t i = object.first; i < members_.size(); ++i) {
            object.keys.insert(text_of(members_[i].key));
        }
    } else if (object.size > kFewKeys) {
        object.keys.insert(text_of(members_.back().key));
    }
    return is_new;
}

/// Whether a value goes on an array of rows; begins one.
bool JsonTreeBuilder::joins_rows(Level& array, const JsonNode& node) {
    if (node.kind != Kind::Numbers) return false;
    if (array.packing == Packing::Rows) return node.size == array.width;
    if (array.packing != Packing::Nothing || node.size > kWidest) return false;
    array.packing = Packing::Rows;
    array.width = static_cast<std::uint16_t>(node.size);
    array.first = node.content;
    return true;
}

/// Makes an array that had only numbers or rows into one that takes anything. Its numbers stay
/// where they are: all together they are no more than the text has.
void JsonTreeBuilder::unpack(Level& array) {
    const std::size_t first = nodes_.size();
    if (array.packing == Packing::Rows) {
        for (std::uint32_t i = 0; i < array.size; ++i) {
            const std::uint64_t row = array.first + std::uint64_t{i} * array.width;
            nodes_.push_back({Kind::Numbers, 0, array.width, row});
        }
    } else if (array.packing == Packing::Numbers) {
        const Json packed(*store_, {Kind::Numbers, 0, array.size, array.first});
        for (std::uint32_t i = 0; i < array.size; ++i) {
            const Json number = packed[i];
            const auto whole = number.integer();
            nodes_.push_back({whole ? Kind::Integer : Kind::Float, 0, 0,
                              whole ? std::bit_cast<std::uint64_t>(*whole)
                                    : std::bit_cast<std::uint64_t>(number.number())});
        }
    }
    array.first = first;
    array.packing = Packing::Mixed;
}

void JsonTreeBuilder::place(const JsonNode& node) {
    if (levels_.empty()) {
        root_ = node;
        return;
    }
    Level& level = levels_.back();
    if (level.is_object) {
        members_.back().value = node;
        return;
    }
    if (!joins_rows(level, node)) {
        if (level.packing != Packing::Mixed) unpack(level);
        nodes_.push_back(node);
    }
    ++level.size;
}

JsonNode JsonTreeBuilder::finished_object(Level& level) {
    const auto begin = members_.begin() + static_cast<std::ptrdiff_t>(level.first);
    std::sort(begin, members_.end(), [&](const JsonMember& a, const JsonMember& b) {
        return text_of(a.key) < text_of(b.key);
    });
    const JsonNode node{Kind::Object, 0, level.size, store_->members.size()};
    store_->members.insert(store_->members.end(), begin, members_.end());
    members_.erase(begin, members_.end());
    return node;
}

JsonNode JsonTreeBuilder::finished(Level& level) {
    if (level.is_object) return finished_object(level);
    if (level.packing == Packing::Numbers) return {Kind::Numbers, 0, level.size, level.first};
    if (level.packing == Packing::Rows) return {Kind::Rows, level.width, level.size, level.first};
    if (level.packing == Packing::Nothing) return {Kind::Array, 0, 0, 0};
    const auto begin = nodes_.begin() + static_cast<std::ptrdiff_t>(level.first);
    const JsonNode node{Kind::Array, 0, level.size, store_->nodes.size()};
    store_->nodes.insert(store_->nodes.end(), begin, nodes_.end());
    nodes_.erase(begin, nodes_.end());
    return node;
}

void JsonTreeBuilder::close() {
    const JsonNode node = finished(levels_.back());
    levels_.pop_back();
    place(node);
}

std::string JsonTreeBuilder::pointer_of(std::size_t levels) const {
    std::string pointer;
    for (std::size_t i = 0; i < levels; ++i) {
        const Level& level = levels_[i];
        pointer += '/';
        if (level.is_object) {
            pointer += pointer_token(text_of(members_[level.first + level.size - 1].key));
        } else {
            pointer += std::to_string(level.size);
        }
    }
    return pointer;
}

JsonTree JsonTreeBuilder::take() && { return {std::move(store_), root_}; }

}  // namespace bouguer::api
