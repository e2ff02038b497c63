// SPDX-License-Identifier: Apache-2.0
#include "renderer/spectrum/primary_reflectances.h"

#include "renderer/spectrum/colour.h"
#include "renderer/spectrum/data_table.h"
#include "renderer/spectrum/sampled_spectrum.h"
#include "renderer/spectrum/smooth_reflectance.h"

namespace bouguer::renderer {
namespace {

using Primaries = std::array<SpectrumPtr, 3>;

Primaries sampled(const DataTable& table) {
    Primaries made;
    for (std::size_t i = 0; i < made.size(); ++i)
        made[i] = std::make_shared<SampledSpectrum>(table.wavelengths_nm, table.columns[i].values);
    return made;
}

/// Columns: how much of each of `primaries` makes exactly red, exactly green, exactly blue. A
/// column adds up to 1 because the primaries add up to white.
Matrix3 exact_mixtures(const Primaries& primaries) {
    Matrix3 colours{};
    for (std::size_t i = 0; i < 3; ++i) {
        const auto rgb = rec709_of_reflectance(*primaries[i]);
        for (std::size_t k = 0; k < 3; ++k) colours[k][i] = rgb[k];
    }
    return inverse(colours);
}

Primaries make_primaries() {
    const DataTable published = read_table("primaries_srgb");
    const Matrix3 mixtures = exact_mixtures(sampled(published));
    DataTable exact = published;
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t row = 0; row < exact.wavelengths_nm.size(); ++row) {
            double sum = 0;
            for (std::size_t k = 0; k < 3; ++k)
                sum += mixtures[k][i] * published.columns[k].values[row];
            exact.columns[i].values[row] = sum;
        }
    }
    return sampled(exact);
}

}  // namespace

const std::array<SpectrumPtr, 3>& srgb_primary_reflectances() {
    static const Primaries primaries = make_primaries();
    return primaries;
}

}  // namespace bouguer::renderer
