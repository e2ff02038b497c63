// SPDX-License-Identifier: Apache-2.0
// The files of the web page and the documentation, embedded when the daemon is built.
#pragma once

#include <span>
#include <string_view>

namespace bouguer::server {

struct WebAsset {
    std::string_view path;  ///< as in a request: "/", "/app.js", "/docs/problems"
    std::string_view media_type;
    std::string_view bytes;
};

/// All of them. They live as long as the process.
[[nodiscard]] std::span<const WebAsset> web_assets();

}  // namespace bouguer::server
