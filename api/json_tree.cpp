// SPDX-License-Identifier: Apache-2.0
#include "api/json_tree.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "api/problems.h"

namespace bouguer::api {
namespace {

constexpr std::size_t kLongestFound = 60;

/// The longest prefix of at most `bytes` bytes that does not cut a UTF-8 sequence.
std::string_view utf8_prefix(std::string_view text, std::size_t bytes) {
    if (text.size() <= bytes) return text;
    while (bytes > 0 && (static_cast<unsigned char>(text[bytes]) & 0xC0U) == 0x80U) --bytes;
    return text.substr(0, bytes);
}

std::string quoted(std::string_view text) {
    return Json(std::string(text)).dump(-1, ' ', true, Json::error_handler_t::replace);
}

/// "line 3, column 14" of a byte position (which counts from 1, as the parser does).
std::string line_and_column(std::string_view text, std::size_t position) {
    const std::string_view before = text.substr(0, std::min(position, text.size()));
    const auto line = 1 + std::count(before.begin(), before.end(), '\n');
    const auto last_break = before.rfind('\n');
    const std::size_t column =
        last_break == std::string_view::npos ? before.size() : before.size() - last_break - 1;
    return "line " + std::to_string(line) + ", column " + std::to_string(column);
}

/// Builds the tree from the parser's events, so that every check has the pointer at hand and a deep
/// document is refused before it is built.
class TreeBuilder final : public nlohmann::json_sax<Json> {
  public:
    TreeBuilder(std::string_view text, const Limits& limits)
        : text_(text), limits_(limits), problems_(limits.problems) {}

    bool null() override { return place(nullptr); }
    bool boolean(bool value) override { return place(value); }
    bool number_integer(number_integer_t value) override { return place(value); }
    bool number_unsigned(number_unsigned_t value) override { return place(value); }
    bool number_float(number_float_t value, const string_t& /*text*/) override {
        return place(value);
    }
    bool string(string_t& value) override { return place(std::move(value)); }
    bool binary(binary_t& /*value*/) override { return false; }  // JSON has none
    bool start_object(std::size_t /*size*/) override { return open(Json::object()); }
    bool start_array(std::size_t /*size*/) override { return open(Json::array()); }
    bool end_object() override { return close(); }
    bool end_array() override { return close(); }
    bool key(string_t& name) override;
    bool parse_error(std::size_t position, const std::string& last_token,
                     const nlohmann::detail::exception& error) override;

    Result<Json> take() &&;

  private:
    struct Level {
        Json* node;
        std::string key;  ///< of the member being read, in an object
    };

    bool open(Json container);
    bool close();
    bool place(Json value);
    Json* put(Json value);
    [[nodiscard]] std::string pointer() const;
    void malformed(Problem problem);

    std::string_view text_;
    const Limits& limits_;
    Problems problems_;
    ErrorKind kind_ = ErrorKind::InvalidInput;
    Json root_;
    std::vector<Level> levels_;
};

/// Where the value that comes next will stand.
std::string TreeBuilder::pointer() const {
    std::string pointer;
    for (const Level& level : levels_) {
        const bool is_innermost = &level == &levels_.back();
        pointer += '/';
        if (level.node->is_object()) {
            pointer += pointer_token(level.key);
        } else {
            pointer += std::to_string(level.node->size() - (is_innermost ? 0 : 1));
        }
    }
    return pointer;
}

Json* TreeBuilder::put(Json value) {
    if (levels_.empty()) {
        root_ = std::move(value);
        return &root_;
    }
    Level& level = levels_.back();
    if (level.node->is_object()) {
        Json& member = (*level.node)[level.key];
        member = std::move(value);
        return &member;
    }
    return &level.node->emplace_back(std::move(value));
}

bool TreeBuilder::place(Json value) {
    put(std::move(value));
    return true;
}

bool TreeBuilder::open(Json container) {
    if (levels_.size() >= static_cast<std::size_t>(limits_.json_depth)) {
        malformed({pointer(),
                   "too-deep",
                   "arrays and objects are nested too deeply",
                   {},
                   "at most " + std::to_string(limits_.json_depth) + " levels"});
        return false;
    }
    levels_.push_back({put(std::move(container)), {}});
    return true;
}

bool TreeBuilder::close() {
    levels_.pop_back();
    return true;
}

bool TreeBuilder::key(string_t& name) {
    Level& level = levels_.back();
    if (name.size() > limits_.name_bytes) {
        level.key.clear();
        std::string object = pointer();
        object.pop_back();  // the "/" of the empty key
        problems_.add({std::move(object), "over-limit", "a key of this object is too long",
                       describe(Json(name)),
                       "keys of at most " + std::to_string(limits_.name_bytes) + " bytes"});
        level.key = utf8_prefix(name, limits_.name_bytes);
        return true;  // cut short it may look like another
    }
    level.key = std::move(name);
    if (level.node->contains(level.key)) {
        malformed({pointer(), "duplicate-key", "the object has this key more than once",
                   quoted(utf8_prefix(level.key, kLongestFound)), "every key once"});
    }
    return true;
}

bool TreeBuilder::parse_error(std::size_t position, const std::string& last_token,
                              const nlohmann::detail::exception& error) {
    constexpr int kNumberOverflow = 406;
    const std::string where = line_and_column(text_, position);
    const std::string found = quoted(utf8_prefix(last_token, kLongestFound));
    if (error.id == kNumberOverflow) {
        problems_.add({pointer(), "not-finite", "the number is too large to be represented", found,
                       "numbers of magnitude below 1.8e308"});
    } else if (std::string_view(error.what()).find("UTF-8") != std::string_view::npos) {
        malformed({"", "invalid-utf8", "the text is not valid UTF-8 at " + where, found, "UTF-8"});
    } else {
        malformed({"", "not-json", "the text is not JSON: it cannot be understood at " + where,
                   found, "one JSON document"});
    }
    return false;
}

void TreeBuilder::malformed(Problem problem) {
    kind_ = ErrorKind::Malformed;
    problems_.add(std::move(problem));
}

Result<Json> TreeBuilder::take() && {
    if (!problems_.empty()) return tl::unexpected(std::move(problems_).to_error(kind_));
    return std::move(root_);
}

}  // namespace

Result<Json> read_json_tree(std::string_view text, const Limits& limits) {
    if (text.size() > limits.body_bytes) {
        return fail(ErrorKind::TooLarge, "the document has " + std::to_string(text.size()) +
                                             " bytes; at most " +
                                             std::to_string(limits.body_bytes) + " are allowed");
    }
    TreeBuilder builder(text, limits);
    Json::sax_parse(text.begin(), text.end(), &builder);
    return std::move(builder).take();
}

std::string canonical_text(const Json& value) {
    return value.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string describe(const Json& value) {
    if (value.is_object()) return "an object";
    if (value.is_array()) return "an array of " + std::to_string(value.size());
    if (!value.is_string()) return value.dump();
    const auto& text = value.get_ref<const std::string&>();
    const std::string_view shown = utf8_prefix(text, kLongestFound);
    return quoted(shown) + (shown.size() < text.size() ? " ..." : "");
}

}  // namespace bouguer::api
