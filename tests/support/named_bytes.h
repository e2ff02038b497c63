// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "api/job_document.h"

namespace bouguer::tests {

/// Assets that a test has in memory or makes: it says what the bytes of a name are.
class NamedBytes : public api::AssetSource {
  public:
    [[nodiscard]] virtual Result<std::string> bytes(std::string_view name) const = 0;

    [[nodiscard]] Result<std::unique_ptr<const renderer::ByteSource>> open(
        std::string_view name) const final {
        auto found = bytes(name);
        if (!found) return tl::unexpected(std::move(found).error());
        return std::make_unique<const renderer::MemorySource>(*std::move(found));
    }
};

/// Nothing at all.
class NoAssets final : public NamedBytes {
  public:
    [[nodiscard]] Result<std::string> bytes(std::string_view) const override {
        return fail(ErrorKind::NotFound, "there are no files here");
    }
};

}  // namespace bouguer::tests
