// SPDX-License-Identifier: Apache-2.0
// Memory that runs out is an error like others: what asked for it is refused, and may ask again.
#pragma once

#include "renderer/core/result.h"

namespace bouguer {

/// For `catch (const std::bad_alloc&)`: Error{Busy}, code "out-of-memory". Allocates nothing: both
/// texts are short enough to lie inside their strings.
[[nodiscard]] inline tl::unexpected<Error> out_of_memory() {
    return fail(ErrorKind::Busy, "out of memory", "out-of-memory");
}

}  // namespace bouguer
