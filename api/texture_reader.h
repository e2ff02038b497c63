// SPDX-License-Identifier: Apache-2.0
// Textures of a scene, and what materials make of them. The kinds are in the registry of
// read_texture.cpp.
//
//     "textures": {
//       "wood":  { "type": "image", "path": "wood.png" },
//       "cloth": { "type": "image", "asset": "sha256-...", "color_space": "srgb" | "linear",
//                  "filter": "bilinear" | "nearest", "wrap": "repeat" | "clamp" | "mirror" },
//       "board": { "type": "checker", "a": <spectrum>, "b": <spectrum> },
//       "mesh":  { "type": "grid", "line": <spectrum>, "ground": <spectrum>, "width": 0.05 } }
//
// Each may have "scale": n or [u, v], "offset": [u, v], "rotate_deg": see renderer::UvMapping.
//
// Used: <spectrum> | { "texture": "wood", "times": <spectrum> }      times: default 1
#pragma once

#include <map>
#include <optional>
#include <string>

#include "api/read_context.h"
#include "api/read_texture.h"
#include "api/spectrum_reader.h"
#include "renderer/textures/texture.h"

namespace bouguer::api {

/// Reads textures when they are first used and resolves their names. Not thread-safe.
class TextureReader {
  public:
    /// `definitions` is the scene's `textures`; it need not be there. `spectra` outlives this.
    TextureReader(std::optional<JsonValue> definitions, SpectrumReader& spectra,
                  const ReadContext& context);

    /// A reflectance or transmittance: every value in [0, 1]; a texture and what it is multiplied
    /// by each for itself. Its spectrum is null after a report.
    [[nodiscard]] renderer::SurfaceSpectrum factor(const JsonValue& value);
    /// What a surface emits: every value finite and >= 0. Its spectrum is null after a report.
    [[nodiscard]] renderer::SurfaceSpectrum emission(const JsonValue& value);
    /// Reads the definitions that nothing has used, so that their problems are reported too.
    void read_all();

  private:
    struct Definition {
        JsonValue value;
        bool is_read = false;
        std::optional<ReadTexture> texture;  ///< empty after a report
    };

    Definition* named(const JsonValue& name);
    const std::optional<ReadTexture>& read(Definition& definition);
    renderer::SurfaceSpectrum product(const JsonValue& value, bool is_factor);

    TextureKindContext kinds_;
    std::map<std::string, Definition, std::less<>> definitions_;
};

}  // namespace bouguer::api
