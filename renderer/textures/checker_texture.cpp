// SPDX-License-Identifier: Apache-2.0
#include "renderer/textures/checker_texture.h"

namespace bouguer::renderer {
namespace {

class CheckerTexture final : public Texture {
  public:
    CheckerTexture(SpectrumPtr a, SpectrumPtr b, const UvMapping& mapping)
        : spectra_{std::move(a), std::move(b)}, to_texture_(mapping) {}

    [[nodiscard]] const std::vector<SpectrumPtr>& spectra() const override { return spectra_; }
    [[nodiscard]] TextureWeights at(Vec2 uv) const override {
        const Vec2 st = to_texture_(uv);
        const bool is_a = (fraction(st.x) < 0.5) == (fraction(st.y) < 0.5);
        return is_a ? TextureWeights{1, 0, 0} : TextureWeights{0, 1, 0};
    }
    [[nodiscard]] TextureWeights mean() const override { return {0.5F, 0.5F, 0}; }

  private:
    std::vector<SpectrumPtr> spectra_;
    UvToTexture to_texture_;
};

}  // namespace

TexturePtr checker_texture(SpectrumPtr a, SpectrumPtr b, const UvMapping& mapping) {
    return std::make_shared<CheckerTexture>(std::move(a), std::move(b), mapping);
}

}  // namespace bouguer::renderer
