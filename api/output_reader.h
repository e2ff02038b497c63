// SPDX-License-Identifier: Apache-2.0
// What a document says of how the picture is shown and stored.
#pragma once

#include "api/json_reader.h"
#include "api/output_texts.h"

namespace bouguer::api {

/// Reads into `output`, whose values are the defaults:
///
///     display      a name of renderer::displays()
///     exposure     "auto" or a factor, (0, 1e30]
///     adaptation   none | bradford | cat16; cat16 by default where a white is given
///     white        [x, y] or an illuminant of the library; only with adaptation. By default the
///                  scene's own light, which then has one colour
///     gamut        clip | desaturate
///     color_space  of the EXR: rec709 | xyz | display-p3 | acescg
///
/// Keys of other scopes stay unknown to the reader.
void read_output(JsonReader& reader, OutputScope scope, renderer::OutputSettings& output);

}  // namespace bouguer::api
