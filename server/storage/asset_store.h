// SPDX-License-Identifier: Apache-2.0
// Where uploaded files are kept under their digest. Every backend passes
// tests/server/storage/asset_store_contract.h.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "renderer/core/result.h"

namespace bouguer::server {

struct AssetStoreLimits {
    std::size_t file_bytes = 64U << 20U;
    std::uint64_t total_bytes = 16ULL << 30U;
};

/// Files are written once and never change. Thread-safe. What put() has returned for survives a
/// crash. Errors: Internal when the store itself fails.
class AssetStore {
  public:
    enum class Put { New, Known };

    virtual ~AssetStore() = default;

    /// Stores `bytes` under `digest`, whole or not at all. InvalidInput: "digest-mismatch" when the
    /// bytes have another digest, "unknown-type" when they are nothing that scenes can use.
    /// TooLarge: over AssetStoreLimits::file_bytes; "asset-store-full" over total_bytes.
    [[nodiscard]] virtual Result<Put> put(const std::string& digest, std::string_view bytes) = 0;
    /// NotFound; Internal, code "asset-damaged", when the bytes are no longer those of the digest.
    [[nodiscard]] virtual Result<std::string> get(const std::string& digest) const = 0;
    [[nodiscard]] virtual bool has(const std::string& digest) const = 0;
};

/// The media type of a file that scenes can use, told by its content: PNG, JPEG, EXR, PLY or OBJ.
/// Empty for all else.
[[nodiscard]] std::string_view asset_media_type(std::string_view bytes);

/// Checks the arguments of put() but for the room in the store. For backends.
[[nodiscard]] Result<void> check_asset(const std::string& digest, std::string_view bytes,
                                       const AssetStoreLimits& limits);
/// The refusal of put() when there is no room left. For backends.
[[nodiscard]] tl::unexpected<Error> asset_store_is_full(const AssetStoreLimits& limits);

}  // namespace bouguer::server
