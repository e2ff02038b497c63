// SPDX-License-Identifier: Apache-2.0
#include "api/digest_list.h"

#include <new>

#include "api/asset_reader.h"
#include "api/digest.h"
#include "api/json_builder.h"
#include "api/json_parser.h"
#include "api/json_reader.h"
#include "renderer/core/out_of_memory.h"

namespace bouguer::api {

namespace {

Result<std::vector<std::string>> read_digests(std::string_view text, const Limits& limits) {
    const auto tree = read_json_tree(text, limits);
    if (!tree) return tl::unexpected(tree.error());
    Problems problems(limits.problems);
    JsonReader reader(JsonValue(tree->root(), "", problems));
    std::vector<std::string> digests;
    if (const auto at = reader.require("digests"); at && at->is_array(0, kMaxDigests, "digests")) {
        for (std::size_t i = 0; i < at->json().size(); ++i) {
            const JsonValue element = at->element(i);
            auto digest = element.text(limits.name_bytes);
            if (digest && !is_digest(*digest)) report_no_digest(element);
            if (digest) digests.push_back(*std::move(digest));
        }
    }
    reader.reject_unknown_keys();
    if (!problems.empty()) {
        return tl::unexpected(std::move(problems).to_error(ErrorKind::InvalidInput));
    }
    return digests;
}

}  // namespace

Result<std::vector<std::string>> parse_digest_list(std::string_view text, const Limits& limits) {
    try {
        return read_digests(text, limits);
    } catch (const std::bad_alloc&) {
        return out_of_memory();
    }
}

std::string missing_json(const std::vector<std::string>& digests) {
    JsonArray missing;
    for (const std::string& digest : digests) missing.add(digest);
    return JsonObject().set_json("missing", missing.text()).text();
}

}  // namespace bouguer::api
