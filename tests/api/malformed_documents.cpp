// SPDX-License-Identifier: Apache-2.0
#include "tests/api/malformed_documents.h"

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "tests/support/source_folder.h"

namespace bouguer::tests {
namespace {

using Json = nlohmann::json;

Json read_table() {
    std::ifstream file(source_folder() / "tests/api/malformed_documents.json");
    return Json::parse(file);
}

std::string bytes_of_hex(const std::string& hex) {
    std::string bytes;
    for (std::size_t i = 0; i + 1 < hex.size(); i += 2) {
        bytes += static_cast<char>(std::stoi(hex.substr(i, 2), nullptr, 16));
    }
    return bytes;
}

std::string repeated(const std::string& text, std::size_t times) {
    std::string all;
    for (std::size_t i = 0; i < times; ++i) all += text;
    return all;
}

std::string patched(const Json& base, const Json& row) {
    std::string body = base.patch(row["patch"]).dump();
    if (!row.contains("then_replace")) return body;
    const auto from = row["then_replace"]["from"].get<std::string>();
    const auto at = body.find(from);
    if (at == std::string::npos) throw std::runtime_error("nothing to replace: " + from);
    return body.replace(at, from.size(), row["then_replace"]["to"].get<std::string>());
}

std::string body_of(const Json& base, const Json& row) {
    if (row.contains("text")) return row["text"].get<std::string>();
    if (row.contains("hex")) return bytes_of_hex(row["hex"].get<std::string>());
    if (row.contains("repeat")) {
        return repeated(row["repeat"].get<std::string>(), row["times"].get<std::size_t>());
    }
    return patched(base, row);
}

}  // namespace

std::vector<MalformedDocument> malformed_documents() {
    const Json table = read_table();
    std::vector<MalformedDocument> documents;
    for (const Json& row : table["documents"]) {
        MalformedDocument document{row["name"].get<std::string>(),
                                   body_of(table["base"], row),
                                   row["status"].get<int>(),
                                   {}};
        for (const Json& problem : row["problems"]) {
            document.problems.emplace_back(problem["pointer"].get<std::string>(),
                                           problem["code"].get<std::string>());
        }
        std::sort(document.problems.begin(), document.problems.end());
        documents.push_back(std::move(document));
    }
    return documents;
}

std::string wellformed_document() { return read_table()["base"].dump(); }

}  // namespace bouguer::tests
