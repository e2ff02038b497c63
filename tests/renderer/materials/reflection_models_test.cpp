// SPDX-License-Identifier: Apache-2.0
// What holds for every model of reflection, and closed forms of each.
#include <gtest/gtest.h>

#include <functional>

#include "renderer/materials/fresnel.h"
#include "renderer/materials/material.h"
#include "renderer/samplers/sobol.h"
#include "renderer/samplers/warp.h"

namespace bouguer::renderer {
namespace {

const Vec3 kNormal{0, 0, 1};

Vec3 at_angle(double degrees, double turn_degrees = 0) {
    const double theta = degrees_to_radians(degrees), phi = degrees_to_radians(turn_degrees);
    return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
}

MaterialModel phong(double k_d, double k_s, double n) {
    PhongMaterial m;
    m.k_d = k_d;
    m.k_s = k_s;
    m.n = n;
    return m;
}

MaterialModel blinn(double k_d, double k_s, double c3) {
    BlinnMaterial m;
    m.k_d = k_d;
    m.k_s = k_s;
    m.c3 = c3;
    return m;
}

MaterialModel cook_torrance(double k_d, double m, const ComplexIndex& index) {
    CookTorranceMaterial surface;
    surface.k_d = k_d;
    surface.k_s = 1 - k_d;
    surface.m = m;
    surface.index = index;
    return surface;
}

MaterialModel hall_greenberg(double k_dr, double k_sr, double n) {
    HallGreenbergMaterial m;
    m.k_dr = k_dr;
    m.k_sr = k_sr;
    m.n = n;
    m.mirror = false;
    return m;
}

MaterialModel hall(double k_sr, double n) {
    HallMaterial m;
    m.reflectance = constant_spectrum(1);
    m.transmittance = constant_spectrum(1);
    m.k_sr = k_sr;
    m.n = n;
    return m;
}

/// A model bound to wavelengths at 5 nm, and the first number of its answers.
class Bound {
  public:
    explicit Bound(const MaterialModel& model)
        : surface_(bind({"", model, {}}, basis_, table_)), colours_(table_) {}

    double reflect(Vec3 wo, Vec3 wi, std::size_t number = 0) {
        return value(surface_.model->reflect(kNormal, wo, wi, colours_), number);
    }
    /// The mean of what `samples` drawn directions give: the integral of reflect().
    double mean_of_samples(Vec3 wo, std::uint32_t samples) {
        double sum = 0;
        for (std::uint32_t i = 0; i < samples; ++i) {
            const auto sample =
                surface_.model->sample(kNormal, wo, scrambled_sobol(i, 7), colours_);
            if (sample) sum += value(sample->response, 0);
        }
        return sum / samples;
    }
    double integral(Vec3 wo, std::uint32_t samples) {
        double sum = 0;
        for (std::uint32_t i = 0; i < samples; ++i)
            sum += reflect(wo, sample_cosine_power(scrambled_sobol(i, 8), 0));
        return sum * 2 * kPi / samples;
    }
    Shares shares(double cosine, const Boundary& boundary) {
        return surface_.model->shares(cosine, boundary, colours_);
    }
    const SpectralBasis& basis() const { return basis_; }
    const Surface& surface() const { return surface_; }

  private:
    static double value(const Response& response, std::size_t number) {
        double sum = 0;
        for (const Term& term : response)
            if (term.scale > 0) sum += term.scale * term.colour[number / 8][number % 8];
        return sum;
    }

    const SpectralBasis basis_ = SpectralBasis::wavelengths(5);
    SpectralTable table_{basis_.size()};
    Surface surface_;
    SurfaceColours colours_;
};

struct Named {
    const char* name;
    std::function<MaterialModel()> make;
};

class EveryModel : public testing::TestWithParam<Named> {};

// Drawing directions and weighing them by their density gives the integral that uniform directions
// give. 2^16 points: the standard error of the rougher of the two is below 0.3 % here.
TEST_P(EveryModel, DrawsInProportionToItsDensity) {
    Bound model(GetParam().make());
    for (const double degrees : {0.0, 40.0, 75.0}) {
        const Vec3 wo = at_angle(degrees, 20);
        const double integral = model.integral(wo, 1U << 16U);
        EXPECT_NEAR(model.mean_of_samples(wo, 1U << 16U), integral, 0.01 * integral) << degrees;
    }
}

TEST_P(EveryModel, IsNeverNegativeOrInfinite) {
    Bound model(GetParam().make());
    for (const double out : {0.0, 30.0, 89.0, 89.9999})
        for (const double in : {0.0, 30.0, 60.0, 89.0, 89.9999})
            for (const double turn : {0.0, 90.0, 180.0}) {
                const double value = model.reflect(at_angle(out), at_angle(in, turn));
                EXPECT_GE(value, 0);
                EXPECT_TRUE(std::isfinite(value)) << out << " " << in << " " << turn;
            }
}

INSTANTIATE_TEST_SUITE_P(
    All, EveryModel,
    testing::Values(
        Named{"Hall", [] { return hall(0.8, 3); }},
        Named{"Phong", [] { return phong(0.5, 0.4, 20); }},
        Named{"PhongGlossOnly", [] { return phong(0, 0.4, 5); }},
        Named{"Blinn", [] { return blinn(0.3, 0.6, 0.4); }},
        Named{"BlinnGlossOnly", [] { return blinn(0, 1, 0.6); }},
        Named{"Copper", [] { return cook_torrance(0, 0.3, library_metal("Cu")); }},
        Named{"Plastic",
              [] {
                  return cook_torrance(0.5, 0.4, {constant_spectrum(1.5), constant_spectrum(0)});
              }},
        Named{"HallGreenberg", [] { return hall_greenberg(0.4, 0.5, 10); }}),
    [](const auto& each) { return each.param.name; });

// (R.V)^n at the mirrored direction is 1, and (L.N) there is the cosine.
TEST(Phong, IsTheSumOfItsTerms) {
    Bound model(phong(0.5, 0.4, 20));
    EXPECT_NEAR(model.reflect(at_angle(30), at_angle(30, 180)), 0.5 * std::cos(kPi / 6) + 0.4,
                1e-6);
    // 10 degrees off: cos^20 = 0.736257
    EXPECT_NEAR(model.reflect(at_angle(30), at_angle(40, 180)),
                0.5 * std::cos(degrees_to_radians(40)) + 0.4 * 0.736257, 1e-6);
}

// Along the normal D = G = 1 and F = 0.04.
TEST(Blinn, HasAPeakOfOneTimesFresnel) {
    Bound model(blinn(0, 1, 0.2));
    EXPECT_NEAR(model.reflect(kNormal, kNormal), 0.04, 1e-7);
}

// Along the normal pi D G / 4 = 1 / (4 m^2); m = 0.25 makes it 4. F is copper's at each wavelength.
TEST(CookTorrance, HasTheFacetsPeakInTheMetalsColour) {
    Bound model(cook_torrance(0, 0.25, library_metal("Cu")));
    const auto f0 = normal_reflectance(library_metal("Cu"));
    for (const std::size_t i : {0U, 20U, 40U, 60U, 90U}) {
        const double lambda_nm = model.basis().wavelengths_nm()[i];
        EXPECT_NEAR(model.reflect(kNormal, kNormal, i), 4 * f0->at(lambda_nm), 1e-5) << lambda_nm;
    }
}

// Shadowing keeps facets from giving back more than came: the whole answer over pi is at most 1,
// for a metal that reflects everything.
TEST(CookTorrance, GivesBackAtMostWhatCame) {
    const ComplexIndex perfect{constant_spectrum(1e-3), constant_spectrum(100)};
    for (const double m : {0.1, 0.3, 1.0}) {
        Bound model(cook_torrance(0, m, perfect));
        for (const double degrees : {0.0, 60.0, 85.0}) {
            const double albedo = model.mean_of_samples(at_angle(degrees), 1U << 14U) / kPi;
            EXPECT_LE(albedo, 1 + 1e-3) << m << " " << degrees;
            EXPECT_GT(albedo, m < 0.2 ? 0.9 : 0.4) << m << " " << degrees;
        }
    }
}

/// Red over blue of what a copper highlight is made of.
double redness(double half_angle_degrees) {
    const ComplexIndex cu = library_metal("Cu");
    const double c = std::cos(degrees_to_radians(half_angle_degrees));
    return fresnel_reflectance(c, cu.n->at(650), cu.k->at(650)) /
           fresnel_reflectance(c, cu.n->at(450), cu.k->at(450));
}

// The colour shift: a highlight seen along the surface has the colour of the lamp.
TEST(CookTorrance, ShiftsTheColourOfCopper) {
    Bound model(cook_torrance(0, 0.3, library_metal("Cu")));
    const auto ratio = [&](double degrees) {
        const Vec3 wo = at_angle(degrees), wi = at_angle(degrees, 180);
        return model.reflect(wo, wi, 58) / model.reflect(wo, wi, 18);  // 650 nm, 450 nm
    };
    EXPECT_NEAR(ratio(0), redness(0), 1e-4);
    EXPECT_GT(ratio(0), 1.5);
    EXPECT_NEAR(ratio(80), redness(80), 1e-4);
    EXPECT_LT(ratio(89), 1.05);
}

// In an RGB basis every channel keeps its reflectance at normal incidence.
TEST(CookTorrance, KeepsItsColourInRgb) {
    const SpectralBasis rgb = SpectralBasis::rgb();
    SpectralTable table(rgb.size());
    const BoundIndex index = bind_index(library_metal("Au"), rgb, table);
    const auto wanted = rgb.factor(*normal_reflectance(library_metal("Au")));
    Float8Vector to(table.blocks());
    fresnel_reflectances(to.data(), 1, table.row(index.n), table.row(index.k), table.blocks());
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(to[0][i], std::min(wanted[i], 0.9999F), 1e-5);
}

// Fresnel divides: at normal incidence .04 goes back and .96 through, from either side.
TEST(HallGreenberg, DividesByFresnel) {
    HallGreenbergMaterial glass;
    glass.k_sr = glass.k_st = 1;
    Bound model(glass);
    for (const Boundary& b : {Boundary{1, 1.5, true}, Boundary{1.5, 1, false}}) {
        const Shares s = model.shares(1, b);
        EXPECT_NEAR(s.reflected.colour[0][0], 0.04, 1e-6);
        EXPECT_NEAR(s.refracted.colour[0][0], 0.96, 1e-6);
    }
    const Shares total = model.shares(std::cos(degrees_to_radians(60)), {1.5, 1, false});
    EXPECT_EQ(total.reflected.colour[0][0], 1);
    EXPECT_EQ(total.refracted.colour[0][0], 0);
    // From water: ((1.5 - 1.33) / (1.5 + 1.33))^2
    EXPECT_NEAR(model.shares(1, {1.33, 1.5, true}).reflected.colour[0][0], 0.00360849, 1e-6);
}

// Opaque, as neighbours of equation 2: the matt colour, or a metal's own.
TEST(EverySurface, GivesNeighboursItsColour) {
    const SpectralBasis basis = SpectralBasis::wavelengths(5);
    SpectralTable table(basis.size());
    CookTorranceMaterial copper;
    copper.index = library_metal("Cu");
    const Surface s = bind(copper, basis, table);
    EXPECT_NEAR(table.row(s.neighbour_reflectance)[7][2],
                normal_reflectance(library_metal("Cu"))->at(650), 1e-6);
    EXPECT_EQ(table.row(s.neighbour_transmittance)[7][2], 0);
    EXPECT_FALSE(s.transmits);
}

}  // namespace
}  // namespace bouguer::renderer
