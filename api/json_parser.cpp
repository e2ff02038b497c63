// SPDX-License-Identifier: Apache-2.0
#include "api/json_parser.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>

#include "api/json_string.h"
#include "api/json_text.h"
#include "api/json_tree_builder.h"
#include "api/problems.h"

namespace bouguer::api {
namespace {

using Library = nlohmann::json;

constexpr std::size_t kLongestFound = 60;
constexpr std::size_t kLargestText = UINT32_MAX;  // what the tree can count

std::string quoted_start(std::string_view text) {
    return ascii_json_string(utf8_prefix(text, kLongestFound));
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

/// Hands the parser's events to the builder, so that every check has the pointer at hand and a deep
/// document is refused before it is built.
class DocumentReader final : public nlohmann::json_sax<Library> {
  public:
    DocumentReader(std::string_view text, const Limits& limits)
        : text_(text), limits_(limits), problems_(limits.problems), builder_(text.size()) {}

    Result<JsonTree> read();

    bool null() override {
        builder_.add_null();
        return true;
    }
    bool boolean(bool value) override {
        builder_.add_boolean(value);
        return true;
    }
    bool number_integer(number_integer_t value) override {
        builder_.add_integer(value);
        return true;
    }
    bool number_unsigned(number_unsigned_t value) override;
    bool number_float(number_float_t value, const string_t& /*text*/) override {
        builder_.add_float(value);
        return true;
    }
    bool string(string_t& value) override {
        builder_.add_text(value);
        return true;
    }
    bool binary(binary_t& /*value*/) override { return false; }  // JSON has none
    bool start_object(std::size_t /*size*/) override;
    bool start_array(std::size_t /*size*/) override;
    bool end_object() override { return end_array(); }
    bool end_array() override {
        builder_.close();
        return true;
    }
    bool key(string_t& name) override;
    bool parse_error(std::size_t position, const std::string& last_token,
                     const nlohmann::detail::exception& error) override;

  private:
    [[nodiscard]] bool has_room_below();
    void refuse_end_at_nul();
    void not_json(std::size_t position, std::string found);
    void malformed(Problem problem);

    std::string_view text_;
    const Limits& limits_;
    Problems problems_;
    ErrorKind kind_ = ErrorKind::InvalidInput;
    JsonTreeBuilder builder_;
};

Result<JsonTree> DocumentReader::read() {
    if (Library::sax_parse(text_.begin(), text_.end(), this)) refuse_end_at_nul();
    if (!problems_.empty()) return tl::unexpected(std::move(problems_).to_error(kind_));
    return std::move(builder_).take();
}

/// The library takes a NUL for the end of the text, whatever follows. In a text that it could read
/// none stands anywhere else.
void DocumentReader::refuse_end_at_nul() {
    const std::size_t nul = text_.find('\0');
    if (nul != std::string_view::npos) not_json(nul + 1, quoted_start("<U+0000>"));
}

bool DocumentReader::number_unsigned(number_unsigned_t value) {
    if (value > static_cast<number_unsigned_t>(INT64_MAX)) {
        builder_.add_large(value);
    } else {
        builder_.add_integer(static_cast<std::int64_t>(value));
    }
    return true;
}

bool DocumentReader::has_room_below() {
    if (builder_.depth() < static_cast<std::size_t>(limits_.json_depth)) return true;
    malformed({builder_.pointer(),
               "too-deep",
               "arrays and objects are nested too deeply",
               {},
               "at most " + std::to_string(limits_.json_depth) + " levels"});
    return false;
}

bool DocumentReader::start_object(std::size_t /*size*/) {
    if (!has_room_below()) return false;
    builder_.open_object();
    return true;
}

bool DocumentReader::start_array(std::size_t /*size*/) {
    if (!has_room_below()) return false;
    builder_.open_array();
    return true;
}

bool DocumentReader::key(string_t& name) {
    if (name.size() > limits_.name_bytes) {
        problems_.add({builder_.pointer_of_open(), "over-limit", "a key of this object is too long",
                       describe_text(name),
                       "keys of at most " + std::to_string(limits_.name_bytes) + " bytes"});
        // cut short it may look like another
        static_cast<void>(builder_.key(utf8_prefix(name, limits_.name_bytes)));
        return true;
    }
    if (!builder_.key(name)) {
        malformed({builder_.pointer(), "duplicate-key", "the object has this key more than once",
                   quoted_start(name), "every key once"});
    }
    return true;
}

bool DocumentReader::parse_error(std::size_t position, const std::string& last_token,
                                 const nlohmann::detail::exception& error) {
    constexpr int kNumberOverflow = 406;
    const std::string found = quoted_start(last_token);
    if (error.id == kNumberOverflow) {
        problems_.add({builder_.pointer(), "not-finite",
                       "the number is too large to be represented", found,
                       "numbers of magnitude below 1.8e308"});
    } else if (std::string_view(error.what()).find("UTF-8") != std::string_view::npos) {
        malformed({"", "invalid-utf8",
                   "the text is not valid UTF-8 at " + line_and_column(text_, position), found,
                   "UTF-8"});
    } else {
        not_json(position, found);
    }
    return false;
}

void DocumentReader::not_json(std::size_t position, std::string found) {
    malformed(
        {"", "not-json",
         "the text is not JSON: it cannot be understood at " + line_and_column(text_, position),
         std::move(found), "one JSON document"});
}

void DocumentReader::malformed(Problem problem) {
    kind_ = ErrorKind::Malformed;
    problems_.add(std::move(problem));
}

}  // namespace

Result<JsonTree> read_json_tree(std::string_view text, const Limits& limits) {
    const std::size_t most = std::min(limits.body_bytes, kLargestText);
    if (text.size() > most) {
        return fail(ErrorKind::TooLarge, "the document has " + std::to_string(text.size()) +
                                             " bytes; at most " + std::to_string(most) +
                                             " are allowed");
    }
    return DocumentReader(text, limits).read();
}

}  // namespace bouguer::api
