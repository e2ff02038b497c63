// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "tests/support/named_bytes.h"

namespace bouguer::tests {

/// Has a mesh, "triangle.ply"; pictures, "grey.png", "linear.png",
/// whose ICC profile says so, and, with numbers up to 2, "hot.exr"; what is
/// neither, "noise.ply"; a file on a broken disk, "broken.ply"; and, as the only digest, that of 64
/// zeros, which is not what its content has.
class FakeAssets final : public NamedBytes {
  public:
    [[nodiscard]] Result<std::string> bytes(std::string_view name) const override {
        const std::string zeros = "sha256-" + std::string(64, '0');
        if (name == "triangle.ply" || name == zeros) {
            return std::string("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
        }
        if (name == "noise.ply") return std::string("v 0 0 0\nv 1 0 0\nv zero\n");
        if (name == "grey.png") return renderer::encode_png(picture(1, 0.5F), {});
        if (name == "linear.png") return linear_png();
        if (name == "hot.exr") return renderer::encode_exr(picture(1, 2), {});
        if (name == "broken.ply") return fail(ErrorKind::Internal, "the disk does not answer");
        return fail(ErrorKind::NotFound, "no such file");
    }

  private:
    static Result<std::string> linear_png() {
        renderer::OutputSettings output;
        output.exposure = 1;
        output.display = "rec709-linear";
        return renderer::encode_png(picture(0.5F, 0.5F), output);
    }
    static renderer::Picture picture(float left, float right) {
        return {
            2, 1, {0.9505F * left, left, 1.0891F * left, 0.9505F * right, right, 1.0891F * right}};
    }
};

}  // namespace bouguer::tests
