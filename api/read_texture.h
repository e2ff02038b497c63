// SPDX-License-Identifier: Apache-2.0
// The kinds of textures that a document may have, by the registry of read_texture.cpp.
#pragma once

#include <optional>
#include <string>

#include "api/json_reader.h"
#include "api/read_context.h"
#include "api/spectrum_reader.h"
#include "renderer/textures/texture.h"

namespace bouguer::api {

/// A texture as the readers hold it, until it is known what it is used for.
struct ReadTexture {
    renderer::TexturePtr texture;
    double high = 0;      ///< the largest value that it takes in the rendered range
    std::string high_at;  ///< where that is, for people
};

/// What textures are read with.
struct TextureKindContext {
    SpectrumReader& spectra;
    const ReadContext& context;
};

/// The texture at `value`. Empty after a report.
[[nodiscard]] std::optional<ReadTexture> read_texture(const JsonValue& value,
                                                      TextureKindContext& with);

}  // namespace bouguer::api
