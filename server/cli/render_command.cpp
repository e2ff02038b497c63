// SPDX-License-Identifier: Apache-2.0
#include <filesystem>
#include <future>
#include <iostream>
#include <thread>

#include "server/cli/command_line.h"
#include "server/cli/commands.h"
#include "server/cli/document.h"
#include "server/cli/output_file.h"
#include "server/cli/progress_bar.h"
#include "server/cli/stop_signal.h"
#include "server/jobs/prepare_render.h"
#include "server/jobs/worker_pool.h"

namespace bouguer::server {
namespace {

using namespace std::chrono_literals;

/// How often signals are looked for and the bar is drawn.
constexpr auto kTick = 50ms;

/// Hands the outcome over to the thread that waits.
class Outcome final : public RenderListener {
  public:
    bool begin(const JobId&) noexcept override { return true; }
    void progress(const JobId&, const JobProgress&) noexcept override {}
    void preview(const JobId&, const JobProgress&) noexcept override {}
    void end(const JobId&, RenderOutcome outcome) noexcept override {
        promise_.set_value(std::move(outcome));
    }
    [[nodiscard]] std::future<RenderOutcome> future() { return promise_.get_future(); }

  private:
    std::promise<RenderOutcome> promise_;
};

/// The result that belongs into a file of that extension; empty for others.
std::string result_for(const std::filesystem::path& file) {
    const std::string extension = file.extension().string();
    return extension == ".png" || extension == ".exr" ? "image" + extension : "";
}

/// Renders `job` to its end or to a signal.
RenderOutcome render(api::JobRequest job, int threads, StopSignal& stop) {
    SceneCache scenes(0);
    Outcome outcome;
    auto future = outcome.future();
    Scheduler scheduler;
    auto task = std::make_shared<RenderTask>(
        "command-line", 0, 0, [&] { return prepare_render(job, scenes); }, outcome);
    scheduler.add_again(task);
    WorkerPool workers(scheduler, threads);
    ProgressBar bar;
    while (future.wait_for(kTick) != std::future_status::ready) {
        if (stop.has_come()) {
            if (task->cancel()) return RenderOutcome{JobState::Cancelled, {}, {}, {}, {}};
            workers.wake();
        }
        bar.draw(task->progress());
    }
    return future.get();
}

Result<void> write_results(const RenderOptions& options, const RenderOutcome& outcome) {
    const auto write = [&](const std::filesystem::path& file, const std::string& result) {
        auto written = write_output(file, outcome.files.at(result));
        if (written) std::cout << "wrote " << file.string() << "\n";
        return written;
    };
    for (const auto& file : options.outputs) {
        if (auto written = write(file, result_for(file)); !written) return written;
    }
    if (options.report) return write(*options.report, "report.json");
    return {};
}

void print_summary(const JobProgress& progress) {
    std::cout << progress.samples << " samples a pixel in " << progress.seconds << " s, "
              << static_cast<double>(progress.rays) / 1e6 << " million rays";
    if (progress.relative_rmse) {
        std::cout << ", relative RMSE " << progress.relative_rmse->value << " ("
                  << progress.relative_rmse->low << " to " << progress.relative_rmse->high << ")";
    }
    std::cout << "\n";
}

int finish(const RenderOptions& options, const RenderOutcome& outcome) {
    if (outcome.state == JobState::Failed) {
        std::cerr << "bouguer: " << outcome.failure << "\n";
        return kExitFailed;
    }
    const bool is_whole = outcome.state == JobState::Done;
    if (outcome.files.empty()) {
        std::cerr << "bouguer: stopped before the first pass was complete; nothing is written\n";
        return kExitFailed;
    }
    if (auto written = write_results(options, outcome); !written) {
        print_error(std::cerr, written.error());
        return kExitFailed;
    }
    print_summary(outcome.progress);
    print_warnings(std::cerr, outcome.warnings);
    if (const auto& pass = outcome.unfinished_pass) {
        std::cerr << "bouguer: the time was over in the first pass; " << pass->without_sample
                  << " of " << pass->pixels << " pixels have no sample and are black\n";
    }
    if (!is_whole) std::cerr << "bouguer: stopped; what is written is the newest complete pass\n";
    return is_whole ? kExitOk : kExitFailed;
}

}  // namespace

int run_render(const RenderOptions& options) {
    StopSignal stop;
    for (const auto& file : options.outputs) {
        if (result_for(file).empty()) {
            std::cerr << "bouguer: " << file.string() << ": pictures end in .png or .exr\n";
            return kExitBadInput;
        }
    }
    auto job = read_document(options.document);
    if (!job) return print_error(std::cerr, job.error());
    if (auto applied = apply_overrides(*job, options.overrides); !applied) {
        return print_error(std::cerr, applied.error());
    }
    const int threads = options.threads > 0 ? options.threads
                                            : static_cast<int>(std::thread::hardware_concurrency());
    return finish(options, render(std::move(*job), threads, stop));
}

}  // namespace bouguer::server
