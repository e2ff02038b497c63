// SPDX-License-Identifier: Apache-2.0
#include "server/cli/output_file.h"

#include <fstream>

#include "server/storage/durable_file.h"

namespace bouguer::server {

Result<void> write_output(const std::filesystem::path& file, std::string_view bytes) {
    std::error_code unknown;
    const auto target = std::filesystem::weakly_canonical(file, unknown);
    const auto status = std::filesystem::status(target, unknown);
    if (!std::filesystem::exists(status) || std::filesystem::is_regular_file(status)) {
        return replace_file(target.empty() ? file : target, bytes);
    }
    std::ofstream out(target, std::ios::binary);
    out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    out.close();
    if (!out) return fail(ErrorKind::Internal, "cannot write to " + file.string());
    return {};
}

}  // namespace bouguer::server
