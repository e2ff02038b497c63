// SPDX-License-Identifier: Apache-2.0
#include "renderer/spectrum/spectrum_notes.h"

#include <algorithm>
#include <utility>

#include "renderer/spectrum/colour.h"

namespace bouguer::renderer {
namespace {

constexpr int kSteps = 256;

double integral(const Spectrum& spectrum, double low_nm, double high_nm) {
    if (!(high_nm > low_nm)) return 0;
    const double step_nm = (high_nm - low_nm) / kSteps;
    double sum = 0;
    for (int i = 0; i < kSteps; ++i) {
        sum += spectrum.tent_mean(low_nm + (i + 0.5) * step_nm, step_nm);
    }
    return sum * step_nm;
}

}  // namespace

void SpectrumNoteList::add(std::string where, double value) {
    ++count_;
    const auto place =
        std::upper_bound(worst_.begin(), worst_.end(), value,
                         [](double v, const SpectrumNote& note) { return v > note.value; });
    if (place - worst_.begin() >= static_cast<std::ptrdiff_t>(kMostKept)) return;
    worst_.insert(place, {std::move(where), value});
    if (worst_.size() > kMostKept) worst_.pop_back();
}

double share_outside_range(const Spectrum& spectrum, double low_nm, double high_nm) {
    const double below = integral(spectrum, low_nm, std::min(high_nm, kLambdaMin_nm));
    const double above = integral(spectrum, std::max(low_nm, kLambdaMax_nm), high_nm);
    const double outside = below + above;
    if (!(outside > 0)) return 0;
    return outside / (outside + integral(spectrum, std::max(low_nm, kLambdaMin_nm),
                                         std::min(high_nm, kLambdaMax_nm)));
}

}  // namespace bouguer::renderer
