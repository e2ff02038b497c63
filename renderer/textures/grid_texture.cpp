// SPDX-License-Identifier: Apache-2.0
#include "renderer/textures/grid_texture.h"

namespace bouguer::renderer {
namespace {

class GridTexture final : public Texture {
  public:
    GridTexture(SpectrumPtr line, SpectrumPtr ground, Real width, const UvMapping& mapping)
        : spectra_{std::move(line), std::move(ground)}, width_(width), to_texture_(mapping) {}

    [[nodiscard]] const std::vector<SpectrumPtr>& spectra() const override { return spectra_; }
    [[nodiscard]] TextureWeights at(Vec2 uv) const override {
        const Vec2 st = to_texture_(uv);
        return is_on_line(st.x) || is_on_line(st.y) ? TextureWeights{1, 0, 0}
                                                    : TextureWeights{0, 1, 0};
    }
    /// The ground is what neither the lines of one way nor those of the other cover.
    [[nodiscard]] TextureWeights mean() const override {
        const auto ground = static_cast<float>((1 - width_) * (1 - width_));
        return {1 - ground, ground, 0};
    }

  private:
    [[nodiscard]] bool is_on_line(Real x) const { return fraction(x + width_ / 2) < width_; }

    std::vector<SpectrumPtr> spectra_;
    Real width_;
    UvToTexture to_texture_;
};

}  // namespace

TexturePtr grid_texture(SpectrumPtr line, SpectrumPtr ground, Real width,
                        const UvMapping& mapping) {
    return std::make_shared<GridTexture>(std::move(line), std::move(ground), width, mapping);
}

}  // namespace bouguer::renderer
