// SPDX-License-Identifier: Apache-2.0
// libFuzzer entry for the headers of pictures: whatever the bytes, sides that can be multiplied or
// an error. Build as job_document_fuzz.cpp says.
#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "renderer/film/image_header.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace bouguer::renderer;
    const MemorySource file({reinterpret_cast<const char*>(data), size});
    const auto header = read_image_header(file);
    if (!header) return 0;
    if (header->width >= 1ULL << 31U || header->height >= 1ULL << 31U) std::abort();
    if (header->channels < 0 || header->channels > 1024) std::abort();
    return 0;
}
