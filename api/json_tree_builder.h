// SPDX-License-Identifier: Apache-2.0
// Packs the values of a document, as they come from a parser, into a JsonTree.
#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "api/json_tree.h"

namespace bouguer::api {

/// Throws std::bad_alloc; what was built by then goes without allocating. Not thread-safe.
class JsonTreeBuilder {
  public:
    /// Of a text of `text_bytes`, below 4 GiB; all strings together have no more.
    explicit JsonTreeBuilder(std::size_t text_bytes);

    void add_null() { place({}); }
    void add_boolean(bool value);
    void add_integer(std::int64_t value);
    void add_large(std::uint64_t value);  ///< an integer above INT64_MAX
    void add_float(double value);         ///< finite
    void add_text(std::string_view value);

    void open_object();
    void open_array();
    void close();
    /// The key of the member that comes next. False: the object has it already.
    [[nodiscard]] bool key(std::string_view key);

    /// Arrays and objects that are open.
    [[nodiscard]] std::size_t depth() const { return levels_.size(); }
    /// Where the value that comes next will stand [RFC 6901].
    [[nodiscard]] std::string pointer() const { return pointer_of(levels_.size()); }
    /// Where the innermost open array or object stands; depth() > 0.
    [[nodiscard]] std::string pointer_of_open() const { return pointer_of(levels_.size() - 1); }

    /// The document, when everything is closed.
    [[nodiscard]] JsonTree take() &&;

  private:
    /// What an open array has had so far: nothing, numbers only, rows of one width only (both lie
    /// in a row among the store's numbers), or anything else, which waits in `nodes_`.
    enum class Packing : std::uint8_t { Nothing, Numbers, Rows, Mixed };

    struct Level {
        bool is_object = false;
        Packing packing = Packing::Nothing;
        std::uint16_t width = 0;          ///< of rows
        std::uint32_t size = 0;           ///< elements or keys
        std::size_t first = 0;            ///< its first number, waiting node or waiting member
        std::set<std::string_view> keys;  ///< of an object with more than a few
    };

    [[nodiscard]] JsonNode stored_text(std::string_view text);
    [[nodiscard]] std::string_view text_of(const JsonNode& string) const;
    [[nodiscard]] bool has_key(const Level& object, std::string_view key) const;
    [[nodiscard]] std::string pointer_of(std::size_t levels) const;
    void add_number(const JsonNode& node, double value, bool is_whole);
    void place(const JsonNode& node);
    [[nodiscard]] static bool joins_rows(Level& array, const JsonNode& node);
    void unpack(Level& array);
    [[nodiscard]] JsonNode finished(Level& level);
    [[nodiscard]] JsonNode finished_object(Level& level);

    std::unique_ptr<JsonStore> store_;
    std::vector<Level> levels_;
    std::vector<JsonNode> nodes_;      ///< elements of open arrays
    std::vector<JsonMember> members_;  ///< members of open objects
    JsonNode root_;
};

}  // namespace bouguer::api
