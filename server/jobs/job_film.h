// SPDX-License-Identifier: Apache-2.0
// What was rendered of a job, to be shown otherwise without rendering: its OpenEXR file is the
// film.
#pragma once

#include <string>

#include "api/output_texts.h"
#include "renderer/render.h"
#include "server/jobs/job_service.h"

namespace bouguer::server {

/// The film of a job and how the job shows it.
struct JobFilm {
    renderer::Picture picture;  ///< to the rounding of the file's floats; exact where it keeps XYZ
    renderer::OutputSettings output;
    bool final = false;  ///< the job has ended: the picture never changes
};

/// Of the newest pass while the job runs. Errors as JobService::file().
[[nodiscard]] Result<JobFilm> film_of(const JobService& jobs, const JobId& id);

/// "image.png" or "image.exr" made anew, with what `texts` say in place of the job's own settings;
/// a job's automatic exposure is kept until another is asked for. Errors as JobService::file() and
/// api::read_output_texts().
[[nodiscard]] Result<ResultFile> image_anew(const JobService& jobs, const JobId& id,
                                            const std::string& name, const api::OutputTexts& texts);

}  // namespace bouguer::server
