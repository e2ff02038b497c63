// SPDX-License-Identifier: Apache-2.0
#include "renderer/film/inflate.h"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

namespace bouguer::renderer {
namespace {

/// zlib counts its input in this.
constexpr std::size_t kMostAtOnce = std::numeric_limits<uInt>::max();

}  // namespace

std::uint32_t crc32_of(std::string_view bytes) {
    return static_cast<std::uint32_t>(
        crc32_z(0, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()));
}

Inflater::Inflater(std::uint64_t most_bytes, std::function<void(std::string_view)> take)
    : stream_(std::make_unique<z_stream_s>()), most_bytes_(most_bytes), take_(std::move(take)) {
    is_begun_ = inflateInit(stream_.get()) == Z_OK;
}

Inflater::~Inflater() { inflateEnd(stream_.get()); }

bool Inflater::add(std::string_view packed) {
    std::array<char, 65536> out;
    if (!is_begun_) return false;
    while (!packed.empty() && !is_complete_) {
        const std::size_t count = std::min(packed.size(), kMostAtOnce);
        stream_->next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed.data()));
        stream_->avail_in = static_cast<uInt>(count);
        do {
            stream_->next_out = reinterpret_cast<Bytef*>(out.data());
            stream_->avail_out = static_cast<uInt>(out.size());
            const int state = inflate(stream_.get(), Z_NO_FLUSH);
            const std::size_t made = out.size() - stream_->avail_out;
            size_ += made;
            if ((state != Z_OK && state != Z_STREAM_END && state != Z_BUF_ERROR) ||
                size_ > most_bytes_)
                return false;
            take_({out.data(), made});
            is_complete_ = state == Z_STREAM_END;
        } while (!is_complete_ && stream_->avail_out == 0);
        packed.remove_prefix(count);
    }
    return true;
}

}  // namespace bouguer::renderer
