// SPDX-License-Identifier: Apache-2.0
// A JSON document in memory, made for large arrays of numbers: these lie packed, eight bytes a
// number, in a few vectors that the whole document shares. Destruction neither allocates nor
// recurses.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace bouguer::api {

/// A value as it lies in a JsonStore. For Json and JsonTreeBuilder only.
struct JsonNode {
    enum class Kind : std::uint8_t {
        Null,
        Boolean,  ///< content: 0 or 1
        Integer,  ///< content: an int64
        Large,    ///< content: an integer above those
        Float,    ///< content: the bits of a finite double
        String,   ///< size bytes of the store's chars, from content
        Array,    ///< size of the store's nodes, from content
        Numbers,  ///< an array, never empty, of size of the store's numbers, from content
        Rows,     ///< an array of size arrays, each of width numbers, from content
        Object    ///< size of the store's members, sorted by key, from content
    };
    Kind kind = Kind::Null;
    std::uint16_t width = 0;
    std::uint32_t size = 0;
    std::uint64_t content = 0;
};

struct JsonMember {
    JsonNode key, value;
};

/// Where the values of one document lie.
struct JsonStore {
    std::string chars;
    std::vector<JsonNode> nodes;
    std::vector<JsonMember> members;
    std::vector<double> numbers;
    std::vector<bool> is_whole;  ///< of every number: it was written without point and exponent
};

/// A view of one value of a JsonTree, which outlives it. As cheap to copy as a pointer or three.
class Json {
  public:
    class Members;

    Json(const JsonStore& store, const JsonNode& node) : store_(&store), node_(node) {}

    [[nodiscard]] bool is_null() const { return node_.kind == JsonNode::Kind::Null; }
    [[nodiscard]] bool is_boolean() const { return node_.kind == JsonNode::Kind::Boolean; }
    [[nodiscard]] bool is_number() const {
        return node_.kind >= JsonNode::Kind::Integer && node_.kind <= JsonNode::Kind::Float;
    }
    /// A number that was written without point and exponent.
    [[nodiscard]] bool is_whole() const {
        return is_number() && node_.kind != JsonNode::Kind::Float;
    }
    [[nodiscard]] bool is_string() const { return node_.kind == JsonNode::Kind::String; }
    [[nodiscard]] bool is_array() const {
        return node_.kind >= JsonNode::Kind::Array && node_.kind <= JsonNode::Kind::Rows;
    }
    [[nodiscard]] bool is_object() const { return node_.kind == JsonNode::Kind::Object; }
    /// Whether this is the string `text`.
    [[nodiscard]] bool is_text(std::string_view text) const {
        return is_string() && this->text() == text;
    }

    /// The getters below are for values of their type only.
    [[nodiscard]] bool boolean() const { return node_.content != 0; }
    [[nodiscard]] double number() const;
    /// Of a whole number; empty above INT64_MAX.
    [[nodiscard]] std::optional<std::int64_t> integer() const;
    [[nodiscard]] std::uint64_t large() const { return node_.content; }  ///< of one above INT64_MAX
    [[nodiscard]] std::string_view text() const;

    /// Elements of an array, members of an object; 0 for all else.
    [[nodiscard]] std::size_t size() const;
    [[nodiscard]] Json operator[](std::size_t index) const;  ///< index < size() of an array
    /// The numbers of an array that has nothing else. None of other values, and of an array with a
    /// whole number beyond 2^53.
    [[nodiscard]] std::span<const double> packed_numbers() const;

    /// Of an object; empty for all else.
    [[nodiscard]] Members members() const;  ///< sorted by key
    [[nodiscard]] std::optional<Json> find(std::string_view key) const;
    [[nodiscard]] bool contains(std::string_view key) const { return find(key).has_value(); }

  private:
    [[nodiscard]] Json packed_number(std::uint64_t at) const;
    [[nodiscard]] std::span<const JsonMember> member_span() const;

    const JsonStore* store_;
    JsonNode node_;
};

/// The members of an object, for range-based loops: `for (const auto& [key, value] : ...)`.
class Json::Members {
  public:
    struct Member {
        std::string_view key;
        Json value;
    };
    class Iterator {
      public:
        Iterator(const JsonStore& store, const JsonMember* at) : store_(&store), at_(at) {}
        Member operator*() const {
            return {Json(*store_, at_->key).text(), Json(*store_, at_->value)};
        }
        Iterator& operator++() {
            ++at_;
            return *this;
        }
        bool operator!=(const Iterator& other) const { return at_ != other.at_; }

      private:
        const JsonStore* store_;
        const JsonMember* at_;
    };

    Members(const JsonStore& store, std::span<const JsonMember> members)
        : store_(&store), members_(members) {}
    [[nodiscard]] Iterator begin() const { return {*store_, members_.data()}; }
    [[nodiscard]] Iterator end() const { return {*store_, members_.data() + members_.size()}; }

  private:
    const JsonStore* store_;
    std::span<const JsonMember> members_;
};

/// A document. Its values stay where they are when it is moved.
class JsonTree {
  public:
    JsonTree(std::unique_ptr<const JsonStore> store, const JsonNode& root)
        : store_(std::move(store)), root_(root) {}

    [[nodiscard]] Json root() const { return {*store_, root_}; }

  private:
    std::unique_ptr<const JsonStore> store_;
    JsonNode root_;
};

}  // namespace bouguer::api
