// SPDX-License-Identifier: Apache-2.0
// What a query or a command line says of the output; documents: malformed_documents.json.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "api/output_texts.h"
#include "api/writers.h"

namespace bouguer::api {
namespace {

using renderer::Adaptation;
using renderer::OutputSettings;

/// "pointer code" of every problem; empty when there are none.
std::vector<std::string> problems_of(const OutputTexts& texts,
                                     OutputScope scope = OutputScope::Files) {
    const auto output = read_output_texts(texts, scope, {});
    std::vector<std::string> found;
    if (output) return found;
    for (const Problem& p : output.error().problems) found.push_back(p.pointer + " " + p.code);
    return found;
}

using Found = std::vector<std::string>;

TEST(OutputTexts, SayEverythingThatDocumentsSay) {
    const auto output = read_output_texts({{"display", "display-p3"},
                                           {"exposure", "2.5e-1"},
                                           {"adaptation", "bradford"},
                                           {"white", "0.31,0.33"},
                                           {"gamut", "desaturate"},
                                           {"color_space", "acescg"}},
                                          OutputScope::Files, {});
    ASSERT_TRUE(output);
    EXPECT_EQ(output->display, "display-p3");
    EXPECT_EQ(output->exposure, 0.25);
    EXPECT_EQ(output->adaptation, Adaptation::Bradford);
    EXPECT_EQ(output->white->x, 0.31);
    EXPECT_EQ(output->white->y, 0.33);
    EXPECT_EQ(output->gamut, renderer::GamutMapping::Desaturate);
    EXPECT_EQ(output->exr_colour, renderer::FileColour::AcesCg);
}

TEST(OutputTexts, KeepWhatTheyDoNotSay) {
    OutputSettings base;
    base.display = "lee-9300k";
    base.exposure = 3;
    const auto output = read_output_texts({{"exposure", "auto"}}, OutputScope::Png, base);
    ASSERT_TRUE(output);
    EXPECT_EQ(output->display, "lee-9300k");
    EXPECT_FALSE(output->exposure);
}

// Illuminant A is (0.44758, 0.40745) [CIE 15:2018, table T.3].
TEST(OutputTexts, AWhiteIsAdaptedFrom) {
    const auto output = read_output_texts({{"white", "A"}}, OutputScope::Png, {});
    ASSERT_TRUE(output);
    EXPECT_EQ(output->adaptation, Adaptation::Cat16);
    EXPECT_NEAR(output->white->x, 0.44758, 2e-5);
    EXPECT_NEAR(output->white->y, 0.40745, 2e-5);
    const auto none = read_output_texts({{"adaptation", "none"}}, OutputScope::Png, *output);
    ASSERT_TRUE(none);
    EXPECT_FALSE(none->white) << "nothing is adapted from it any more";
}

TEST(OutputTexts, TheScenesLightIsTheWhiteWhereItHasOneColour) {
    EXPECT_EQ(problems_of({{"adaptation", "cat16"}}), (Found{"/white missing"}));
    OutputSettings base;
    base.scene_white = renderer::Chromaticity{0.4, 0.4};
    EXPECT_TRUE(read_output_texts({{"adaptation", "cat16"}}, OutputScope::Png, base));
    base.scene_white = renderer::Chromaticity{0.7347, 0.2653};  // 700 nm: no white for Bradford
    EXPECT_FALSE(read_output_texts({{"adaptation", "bradford"}}, OutputScope::Png, base));
}

TEST(OutputTexts, AreRefusedAllAtOnceWithWhatIsAllowed) {
    const OutputTexts texts{{"display", "tv"},  {"exposure", "-1"}, {"adaptation", "x"},
                            {"white", "9,9"},   {"gamut", "fit"},   {"color_space", "srgb"},
                            {"brightness", "1"}};
    EXPECT_EQ(problems_of(texts),
              (Found{"/display unknown-name", "/exposure out-of-range", "/adaptation unknown-name",
                     "/white/0 out-of-range", "/white/1 out-of-range", "/gamut unknown-name",
                     "/color_space unknown-name", "/brightness unknown-key"}));
    const auto refused = read_output_texts(texts, OutputScope::Files, {});
    for (const Problem& p : refused.error().problems) EXPECT_FALSE(p.allowed.empty()) << p.pointer;
    for (const char* text : {"inf", "nan", "1e999", "", "1,5", "0", "+1", "1 "})
        EXPECT_EQ(problems_of({{"exposure", text}}).size(), 1U) << text;
    EXPECT_EQ(problems_of({{"white", "A"}, {"adaptation", "none"}}), (Found{"/white unknown-key"}));
}

TEST(OutputTexts, OfOneFileAreNotThoseOfTheOther) {
    EXPECT_EQ(problems_of({{"color_space", "xyz"}}, OutputScope::Png),
              (Found{"/color_space unknown-key"}));
    EXPECT_EQ(problems_of({{"exposure", "1"}}, OutputScope::Exr), (Found{"/exposure unknown-key"}));
    EXPECT_EQ(problems_of({{"color_space", "xyz"}}, OutputScope::Exr), Found{});
    EXPECT_EQ(problems_of({{"gamut", "clip"}}, OutputScope::Comparison),
              (Found{"/gamut unknown-key"}));
}

TEST(OutputTexts, TheReportKeepsTheSettings) {
    OutputSettings output;
    output.display = "display-p3";
    output.adaptation = Adaptation::Bradford;
    output.scene_white = renderer::Chromaticity{0.44, 0.41};
    output.gamut = renderer::GamutMapping::Desaturate;
    output.exr_colour = renderer::FileColour::Xyz;
    renderer::Report report;
    report.image.exposure = 0.1 + 0.2;  // no short number
    const auto kept = read_report_output(report_json(report, output, "", ""));
    ASSERT_TRUE(kept) << kept.error().message;
    EXPECT_EQ(kept->display, output.display);
    EXPECT_EQ(kept->exposure, 0.1 + 0.2);
    EXPECT_EQ(kept->adaptation, output.adaptation);
    EXPECT_EQ(kept->adapted_white()->x, 0.44);
    EXPECT_EQ(kept->scene_white->y, 0.41);
    EXPECT_EQ(kept->gamut, output.gamut);
    EXPECT_EQ(kept->exr_colour, output.exr_colour);
    EXPECT_EQ(read_report_output("{}").error().code, "result-damaged");
    EXPECT_EQ(read_report_output("no JSON").error().code, "result-damaged");
    EXPECT_FALSE(read_report_output(R"({"output":{"display":"tv"}})"));
}

}  // namespace
}  // namespace bouguer::api
