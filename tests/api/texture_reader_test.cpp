// SPDX-License-Identifier: Apache-2.0
#include "api/texture_reader.h"

#include <gtest/gtest.h>

#include <optional>

#include "tests/api/fake_assets.h"
#include "tests/api/json_testing.h"

namespace bouguer::api {
namespace {

/// Readers over the spectra and textures of a scene, and what they make of a value at /here.
class TextureReaderTest : public testing::Test {
  protected:
    renderer::SurfaceSpectrum factor(const char* text) {
        json_ = tests::tree_of(text);
        return textures_.factor(JsonValue(json_->root(), "/here", problems_));
    }
    renderer::SurfaceSpectrum emission(const char* text) {
        json_ = tests::tree_of(text);
        return textures_.emission(JsonValue(json_->root(), "/here", problems_));
    }
    /// The only problem since the last call.
    Problem problem() {
        const Error error =
            std::exchange(problems_, Problems(limits_.problems)).to_error(ErrorKind::InvalidInput);
        EXPECT_EQ(error.problems.size(), 1U);
        return error.problems.empty() ? Problem{} : error.problems[0];
    }

    const Limits limits_;
    Problems problems_{limits_.problems};

  private:
    const JsonTree definitions_ = tests::tree_of(R"({
        "photo": { "type": "image", "path": "grey.png" },
        "light": { "type": "image", "path": "linear.png" },
        "taken": { "type": "image", "path": "linear.png", "color_space": "srgb" },
        "agreed": { "type": "image", "path": "linear.png", "color_space": "linear" },
        "sky": { "type": "image", "path": "hot.exr" },
        "board": { "type": "checker", "a": 3, "b": "leaf" },
        "wires": { "type": "grid", "line": 0, "ground": 0.5, "width": 0.2, "scale": [1, 5] },
        "torn": { "type": "image", "path": "noise.ply" } })");
    const JsonTree spectra_json_ =
        tests::tree_of(R"({"leaf": {"wavelengths_nm": [400, 700], "values": [0.25, 0.25]}})");
    const tests::FakeAssets source_;
    DocumentAssets assets_{source_, limits_};
    const ReadContext context_{limits_, assets_};
    std::optional<JsonTree> json_;
    SpectrumReader spectra_{JsonValue(spectra_json_.root(), "/spectra", problems_), limits_};
    TextureReader textures_{JsonValue(definitions_.root(), "/textures", problems_), spectra_,
                            context_};
};

TEST_F(TextureReaderTest, TakesSpectraAsTheyAre) {
    const auto plain = factor("0.5");
    ASSERT_TRUE(plain.spectrum);
    EXPECT_EQ(plain.spectrum->at(500), 0.5);
    EXPECT_FALSE(plain.texture);
    EXPECT_FALSE(factor("1.5").spectrum);
    EXPECT_EQ(problem().code, "out-of-range");
    EXPECT_TRUE(emission("1.5").spectrum);
}

TEST_F(TextureReaderTest, MultipliesATextureByASpectrum) {
    const auto alone = factor(R"({"texture": "wires"})");
    ASSERT_TRUE(alone.spectrum && alone.texture);
    EXPECT_EQ(alone.spectrum->at(500), 1);
    EXPECT_EQ(alone.texture->at({0.5, 0.019})[0], 1);  // a line every 0.2, 0.04 wide
    EXPECT_EQ(alone.texture->at({0.5, 0.021})[0], 0);
    const auto dimmed = factor(R"({"texture": "wires", "times": 0.5})");
    ASSERT_TRUE(dimmed.spectrum);
    EXPECT_EQ(dimmed.spectrum->at(500), 0.5);
    EXPECT_EQ(dimmed.texture, alone.texture);
}

TEST_F(TextureReaderTest, ReadsImages) {
    const auto photo = factor(R"({"texture": "photo"})");
    ASSERT_TRUE(photo.texture);
    EXPECT_EQ(photo.texture->spectra().size(), 1U);
    EXPECT_NEAR(photo.texture->at({0.75, 0.5})[0], 0.5, 5e-3);
}

// A number of 8 bits stands for 128 / 255 by the file's own word and for 0.2159 as sRGB's.
TEST_F(TextureReaderTest, TakesColoursAsTheFileSaysUnlessTheDocumentDoes) {
    EXPECT_NEAR(factor(R"({"texture": "light"})").texture->at({0.5, 0.5})[0], 128.0 / 255, 1e-6);
    EXPECT_NEAR(factor(R"({"texture": "agreed"})").texture->at({0.5, 0.5})[0], 128.0 / 255, 1e-6);
    EXPECT_TRUE(problems_.warnings().listed().empty());
    EXPECT_NEAR(factor(R"({"texture": "taken"})").texture->at({0.5, 0.5})[0], 0.2158605, 1e-6);
    ASSERT_EQ(problems_.warnings().listed().size(), 1U);
    EXPECT_EQ(problems_.warnings().listed()[0].code, "color-space-overrides");
    EXPECT_EQ(problems_.warnings().listed()[0].pointer, "/textures/taken/color_space");
}

// What is too bright to reflect may shine.
TEST_F(TextureReaderTest, RefusesFactorsAboveOne) {
    EXPECT_FALSE(factor(R"({"texture": "board"})").spectrum);
    Problem found = problem();
    EXPECT_EQ(found.pointer, "/here/texture");
    EXPECT_EQ(found.code, "out-of-range");
    EXPECT_EQ(found.found, "values up to 3 at \"a\"");
    EXPECT_FALSE(factor(R"({"texture": "sky"})").spectrum);
    found = problem();
    EXPECT_EQ(found.found.substr(0, 14), "values up to 2");
    EXPECT_NE(found.found.find("column 1, row 0"), std::string::npos);
    EXPECT_TRUE(emission(R"({"texture": "board", "times": 1000})").spectrum);
    EXPECT_TRUE(emission(R"({"texture": "sky"})").spectrum);
    EXPECT_FALSE(factor(R"({"texture": "wires", "times": 1.5})").spectrum);
    EXPECT_EQ(problem().pointer, "/here/times");
}

TEST_F(TextureReaderTest, HelpsWithNames) {
    EXPECT_FALSE(factor(R"({"texture": "wire"})").spectrum);
    const Problem found = problem();
    EXPECT_EQ(found.pointer, "/here/texture");
    EXPECT_EQ(found.code, "unknown-name");
    EXPECT_NE(found.detail.find("Did you mean \"wires\""), std::string::npos) << found.detail;
    EXPECT_FALSE(factor(R"({"texture": 3})").spectrum);
    EXPECT_EQ(problem().code, "wrong-type");
    EXPECT_TRUE(factor(R"({"texture": "wires", "time": 1})").spectrum);
    EXPECT_EQ(problem().pointer, "/here/time");
}

// However often it is used: read once, reported once.
TEST_F(TextureReaderTest, ReportsABadTextureOnce) {
    EXPECT_FALSE(factor(R"({"texture": "torn"})").spectrum);
    EXPECT_FALSE(emission(R"({"texture": "torn"})").spectrum);
    const Problem found = problem();
    EXPECT_EQ(found.pointer, "/textures/torn/path");
    EXPECT_EQ(found.code, "bad-image");
}

}  // namespace
}  // namespace bouguer::api
