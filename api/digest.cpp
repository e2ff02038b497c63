// SPDX-License-Identifier: Apache-2.0
#include "api/digest.h"

#include <openssl/evp.h>

#include <array>

namespace bouguer::api {
namespace {

constexpr std::string_view kPrefix = "sha256-";

}  // namespace

std::string sha256_hex(std::string_view bytes) {
    std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
    unsigned int size = 0;
    EVP_Digest(bytes.data(), bytes.size(), digest.data(), &size, EVP_sha256(), nullptr);
    constexpr std::string_view kDigits = "0123456789abcdef";
    std::string hex;
    hex.reserve(2UL * size);
    for (unsigned int i = 0; i < size; ++i) {
        hex += kDigits[digest[i] >> 4U];
        hex += kDigits[digest[i] & 15U];
    }
    return hex;
}

std::string digest_of(std::string_view bytes) { return std::string(kPrefix) + sha256_hex(bytes); }

bool is_digest(std::string_view text) {
    constexpr std::size_t kDigits = 64;
    return text.size() == kPrefix.size() + kDigits && text.starts_with(kPrefix) &&
           text.find_first_not_of("0123456789abcdef", kPrefix.size()) == std::string_view::npos;
}

}  // namespace bouguer::api
