// SPDX-License-Identifier: Apache-2.0
#include "api/json_string.h"

#include <nlohmann/json.hpp>

namespace bouguer::api {
namespace {

std::string dumped(std::string_view text, bool is_ascii) {
    using Library = nlohmann::json;
    return Library(std::string(text)).dump(-1, ' ', is_ascii, Library::error_handler_t::replace);
}

}  // namespace

std::string json_string(std::string_view text) { return dumped(text, false); }

std::string ascii_json_string(std::string_view text) { return dumped(text, true); }

std::string_view utf8_prefix(std::string_view text, std::size_t bytes) {
    if (text.size() <= bytes) return text;
    while (bytes > 0 && (static_cast<unsigned char>(text[bytes]) & 0xC0U) == 0x80U) --bytes;
    return text.substr(0, bytes);
}

}  // namespace bouguer::api
