// SPDX-License-Identifier: Apache-2.0
#include "renderer/film/icc_profile.h"

#include <array>
#include <cmath>
#include <span>
#include <string_view>
#include <utility>

#include "renderer/spectrum/chromatic_adaptation.h"

namespace bouguer::renderer {
namespace {

/// The white of the profile connection space, as the standard writes it.
constexpr std::array<double, 3> kD50{0.9642, 1, 0.8249};

/// Big-endian fields, one behind the other.
class Bytes {
  public:
    Bytes& u16(unsigned v) { return byte(v >> 8U).byte(v); }
    Bytes& u32(std::size_t v) {
        return u16(static_cast<unsigned>(v >> 16U) & 0xffffU)
            .u16(static_cast<unsigned>(v & 0xffffU));
    }
    Bytes& zeros(std::size_t count) {
        data_.resize(data_.size() + count);
        return *this;
    }
    /// Four letters.
    Bytes& name(std::string_view letters) {
        data_.insert(data_.end(), letters.begin(), letters.end());
        return *this;
    }
    /// s15Fixed16Number
    Bytes& number(double v) {
        return u32(static_cast<std::uint32_t>(static_cast<std::int32_t>(std::lround(v * 65536))));
    }
    Bytes& numbers(std::span<const double> values) {
        for (const double v : values) number(v);
        return *this;
    }
    Bytes& append(const Bytes& other) {
        data_.insert(data_.end(), other.data_.begin(), other.data_.end());
        return *this;
    }
    [[nodiscard]] std::size_t size() const { return data_.size(); }
    [[nodiscard]] std::vector<std::uint8_t> take() { return std::move(data_); }

  private:
    Bytes& byte(unsigned v) {
        data_.push_back(static_cast<std::uint8_t>(v & 0xffU));
        return *this;
    }
    std::vector<std::uint8_t> data_;
};

/// A text in one language (English), ASCII.
Bytes text_element(std::string_view text) {
    Bytes b;
    b.name("mluc").u32(0).u32(1).u32(12).name("enUS").u32(2 * text.size()).u32(28);
    for (const char c : text) b.u16(static_cast<unsigned char>(c));
    return b.zeros((4 - b.size() % 4) % 4);
}

Bytes xyz_element(std::span<const double> xyz) {
    return std::move(Bytes{}.name("XYZ ").u32(0).numbers(xyz));
}

Bytes matrix_element(const Matrix3& m) {
    Bytes b;
    b.name("sf32").u32(0);
    for (const auto& row : m) b.numbers(row);
    return b;
}

/// Encoded -> linear: ((a x + b)^g from d on, c x below) of sRGB, or the identity.
Bytes curve_element(const Display& display) {
    constexpr std::array kSrgb{2.4, 1 / 1.055, 0.055 / 1.055, 1 / 12.92, 0.04045};
    Bytes b;
    b.name("para").u32(0);
    if (display.encode == &srgb_encode) return b.u16(3).u16(0).numbers(kSrgb);
    return b.u16(0).u16(0).number(1);
}

Bytes header(std::size_t size) {
    Bytes b;
    b.u32(size).u32(0).u32(0x04400000).name("mntr").name("RGB ").name("XYZ ");
    b.u16(2020).u16(1).u16(1).zeros(6);  // a date, always the same
    b.name("acsp").zeros(28);            // platform, flags, maker, model, attributes, intent
    b.numbers(kD50).zeros(48);           // creator, digest (none), reserved
    return b;
}

}  // namespace

std::vector<std::uint8_t> icc_profile(const Display& display) {
    const Chromaticity d50 = chromaticity({kD50[0], kD50[1], kD50[2]});
    const Matrix3 adapt = adaptation_matrix(Adaptation::Bradford, display.chromaticities[3], d50);
    const Matrix3 to_pcs = adapt * inverse(display.from_xyz);
    const auto primary = [&](std::size_t j) {
        return xyz_element(std::array{to_pcs[0][j], to_pcs[1][j], to_pcs[2][j]});
    };
    const std::pair<std::string_view, Bytes> tags[]{
        {"desc", text_element("Bouguer " + display.name)},
        {"cprt", text_element("No copyright")},
        {"wtpt", xyz_element(kD50)},
        {"chad", matrix_element(adapt)},
        {"rXYZ", primary(0)},
        {"gXYZ", primary(1)},
        {"bXYZ", primary(2)},
        {"rTRC", curve_element(display)},
        {"gTRC", curve_element(display)},
        {"bTRC", curve_element(display)},
    };
    constexpr std::size_t kHeader = 128;
    std::size_t offset = kHeader + 4 + 12 * std::size(tags);
    Bytes table, elements;
    table.u32(std::size(tags));
    for (const auto& [tag, element] : tags) {
        table.name(tag).u32(offset).u32(element.size());
        elements.append(element);
        offset += element.size();
    }
    return header(offset).append(table).append(elements).take();
}

}  // namespace bouguer::renderer
