// SPDX-License-Identifier: Apache-2.0
// The table of documents that must be refused, for tests of the readers and of the service.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace bouguer::tests {

struct MalformedDocument {
    std::string name;
    std::string body;  ///< what a client would post
    int status = 422;  ///< 400 or 422
    /// (pointer, code) of every problem that is reported, sorted.
    std::vector<std::pair<std::string, std::string>> problems;
};

/// All rows of malformed_documents.json, with their bodies made. Throws when the file is broken.
[[nodiscard]] std::vector<MalformedDocument> malformed_documents();

/// The document that the rows are made from; it has one of everything and is accepted.
[[nodiscard]] std::string wellformed_document();

}  // namespace bouguer::tests
