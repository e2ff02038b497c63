// SPDX-License-Identifier: Apache-2.0
#include "renderer/film/png_colour.h"

#include <algorithm>
#include <string>

#include "renderer/film/inflate.h"

namespace bouguer::renderer {
namespace {

constexpr std::size_t kMostProfileBytes = 1U << 24U;

tl::unexpected<Error> refuse(const std::string& reason) {
    return fail(ErrorKind::InvalidInput, reason, "bad-image");
}
tl::unexpected<Error> no_sense(const char* chunk) {
    return refuse(std::string("the image's chunk ") + chunk + " makes no sense");
}

unsigned byte_of(std::string_view data, std::size_t i) {
    return static_cast<std::uint8_t>(data[i]);
}

/// Fixed point of five decimals.
double hundred_thousandths(std::string_view data, std::size_t i) {
    std::uint32_t number = 0;
    for (std::size_t k = 4 * i; k < 4 * i + 4; ++k) number = number << 8U | byte_of(data, k);
    return number / 1e5;
}

using Kind = TransferCurve::Kind;

/// Values of ITU-T H.273, tables 2 and 3, that say what colour a number is.
struct Primaries {
    unsigned value;
    std::array<float, 8> chromaticities;
};
constexpr std::array kPrimaries{
    Primaries{1, {0.640F, 0.330F, 0.300F, 0.600F, 0.150F, 0.060F, 0.3127F, 0.3290F}},
    Primaries{4, {0.670F, 0.330F, 0.210F, 0.710F, 0.140F, 0.080F, 0.310F, 0.316F}},
    Primaries{5, {0.640F, 0.330F, 0.290F, 0.600F, 0.150F, 0.060F, 0.3127F, 0.3290F}},
    Primaries{6, {0.630F, 0.340F, 0.310F, 0.595F, 0.155F, 0.070F, 0.3127F, 0.3290F}},
    Primaries{7, {0.630F, 0.340F, 0.310F, 0.595F, 0.155F, 0.070F, 0.3127F, 0.3290F}},
    Primaries{8, {0.681F, 0.319F, 0.243F, 0.692F, 0.145F, 0.049F, 0.310F, 0.316F}},
    Primaries{9, {0.708F, 0.292F, 0.170F, 0.797F, 0.131F, 0.046F, 0.3127F, 0.3290F}},
    Primaries{10, {1, 0, 0, 1, 0, 0, 1.0F / 3, 1.0F / 3}},
    Primaries{11, {0.680F, 0.320F, 0.265F, 0.690F, 0.150F, 0.060F, 0.314F, 0.351F}},
    Primaries{12, {0.680F, 0.320F, 0.265F, 0.690F, 0.150F, 0.060F, 0.3127F, 0.3290F}},
    Primaries{22, {0.630F, 0.340F, 0.295F, 0.605F, 0.155F, 0.077F, 0.3127F, 0.3290F}},
};
struct Curve {
    unsigned value;
    TransferCurve curve;
};
constexpr std::array kCurves{
    Curve{1, {Kind::Bt709}}, Curve{4, {Kind::Power, 2.2}}, Curve{5, {Kind::Power, 2.8}},
    Curve{6, {Kind::Bt709}}, Curve{7, {Kind::Smpte240}},   Curve{8, {Kind::Linear}},
    Curve{13, {Kind::Srgb}}, Curve{14, {Kind::Bt709}},     Curve{15, {Kind::Bt709}},
};

template <class Entry, std::size_t N>
const Entry* entry_of(const std::array<Entry, N>& table, unsigned value) {
    const auto it =
        std::find_if(table.begin(), table.end(), [&](const Entry& e) { return e.value == value; });
    return it == table.end() ? nullptr : &*it;
}

/// Coding-independent code points.
Result<void> take_cicp(std::string_view data, PictureColour& colour) {
    if (data.size() != 4) return no_sense("cICP");
    const unsigned primaries = byte_of(data, 0), curve = byte_of(data, 1);
    const auto unread = [&](const std::string& what) {
        return refuse("the image's chunk cICP says " + what + ", which is not read");
    };
    if (byte_of(data, 2) != 0) return unread("that its numbers are not R, G, B");
    if (byte_of(data, 3) != 1) return unread("that its numbers are of narrow range");
    if (curve == 16) return unread("PQ (absolute luminances)");
    if (curve == 18) return unread("HLG (light for a screen in its room)");
    const Primaries* known = entry_of(kPrimaries, primaries);
    const Curve* known_curve = entry_of(kCurves, curve);
    if (known == nullptr) return unread("primaries " + std::to_string(primaries));
    if (known_curve == nullptr) return unread("transfer characteristics " + std::to_string(curve));
    colour = {known_curve->curve, known->chromaticities, {}};
    return {};
}

/// A name, a zero, the method of packing (0) and the packed profile.
Result<void> take_profile(std::string_view data, PictureColour& colour) {
    const std::size_t end = data.find('\0');
    if (end == std::string_view::npos || end < 1 || end > 79 || data.size() < end + 2 ||
        data[end + 1] != 0)
        return no_sense("iCCP");
    std::vector<std::uint8_t> profile;
    Inflater inflater(kMostProfileBytes, [&](std::string_view piece) {
        profile.insert(profile.end(), piece.begin(), piece.end());
    });
    const bool is_good = inflater.add(data.substr(end + 2)) && inflater.is_complete();
    if (inflater.size() > kMostProfileBytes)
        return refuse("the image's ICC profile has more than " + std::to_string(kMostProfileBytes) +
                      " bytes");
    if (!is_good || profile.empty()) return no_sense("iCCP");
    colour = {};
    colour.icc_profile = std::move(profile);
    return {};
}

Result<void> take_srgb(std::string_view data, PictureColour& colour) {
    if (data.size() != 1 || byte_of(data, 0) > 3) return no_sense("sRGB");  // the intent
    colour = {{Kind::Srgb}, {}, {}};
    return {};
}

/// The number is the light to the power of this.
Result<void> take_gamma(std::string_view data, PictureColour& colour) {
    if (data.size() != 4 || hundred_thousandths(data, 0) == 0) return no_sense("gAMA");
    const double gamma = hundred_thousandths(data, 0);
    colour.transfer =
        gamma == 1 ? TransferCurve{Kind::Linear} : TransferCurve{Kind::Power, 1 / gamma};
    return {};
}

/// White, red, green, blue.
Result<void> take_primaries(std::string_view data, PictureColour& colour) {
    if (data.size() != 32) return no_sense("cHRM");
    std::array<float, 8> c{};
    for (std::size_t i = 0; i < 8; ++i)
        c[(i + 6) % 8] = static_cast<float>(hundred_thousandths(data, i));
    colour.chromaticities = c;
    return {};
}

struct Statement {
    std::string_view chunk;
    Result<void> (*take)(std::string_view, PictureColour&);
};
/// From the one that counts least to the one that counts most; the first two go together.
constexpr std::array kStatements{
    Statement{"cHRM", &take_primaries}, Statement{"gAMA", &take_gamma},
    Statement{"sRGB", &take_srgb},      Statement{"iCCP", &take_profile},
    Statement{"cICP", &take_cicp},
};

}  // namespace

Result<PictureColour> png_colour(const PngFile& file) {
    PictureColour colour;
    for (const Statement& statement : kStatements) {
        const auto it = file.statements.find(statement.chunk);
        if (it == file.statements.end()) continue;
        if (auto good = statement.take(it->second, colour); !good)
            return tl::unexpected(std::move(good).error());
    }
    return colour;
}

}  // namespace bouguer::renderer
