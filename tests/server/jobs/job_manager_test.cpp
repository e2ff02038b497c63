// SPDX-License-Identifier: Apache-2.0
#include "server/jobs/job_manager.h"

#include <gtest/gtest.h>

#include <thread>

#include "server/jobs/job_film.h"
#include "server/log.h"
#include "server/storage/memory_job_store.h"
#include "server/storage/memory_result_store.h"
#include "tests/server/jobs/small_job.h"
#include "tests/server/jobs/wait_until.h"
#include "tests/support/named_bytes.h"

namespace bouguer::server {
namespace {

using namespace std::chrono_literals;

class JobManagerTest : public testing::Test {
  protected:
    JobManagerTest() { set_log_level(LogLevel::Error); }

    std::unique_ptr<JobManager> start(JobManagerOptions options = {.threads = 2}) {
        auto manager = std::make_unique<JobManager>(jobs_, results_, assets_, options);
        EXPECT_TRUE(manager->start());
        return manager;
    }
    static JobId submit(JobManager& manager, const std::string& body) {
        auto submitted = manager.submit(body, "");
        EXPECT_TRUE(submitted) << submitted.error().message;
        return submitted ? submitted->view.job.id : "";
    }
    static JobState state_of(const JobManager& manager, const JobId& id) {
        return manager.find(id)->job.state;
    }
    static void wait_for_end(const JobManager& manager, const JobId& id) {
        wait_until([&] { return is_final(state_of(manager, id)); });
    }
    static void wait_for_picture(const JobManager& manager, const JobId& id) {
        wait_until([&] { return !manager.find(id)->images.empty(); });
    }

    MemoryJobStore jobs_;
    MemoryResultStore results_;
    tests::NoAssets assets_;
};

/// One mesh, whatever its name; counts how often it is opened.
class CountedMesh final : public tests::NamedBytes {
  public:
    [[nodiscard]] Result<std::string> bytes(std::string_view) const override {
        ++opened;
        return std::string("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    }
    mutable std::atomic<int> opened = 0;
};

/// How often the file of a job is opened from its submission to its end.
int times_opened(JobStore& jobs, ResultStore& results, const JobManagerOptions& options) {
    const CountedMesh mesh;
    JobManager manager(jobs, results, mesh, options);
    EXPECT_TRUE(manager.start());
    const auto submitted = manager.submit(
        R"({"format":"bouguer-job/1","scene":{"format":"bouguer-scene/1",
            "camera":{"type":"perspective","from":[0,0,9],"at":[0,0,0],"resolution":[4,4]},
            "materials":{"m":{"type":"hall","k_sr":1}},
            "objects":[{"name":"o","material":"m","shape":{"type":"file","path":"a.obj"}}]},
            "stop":{"samples":1}})",
        "");
    EXPECT_TRUE(submitted) << submitted.error().message;
    while (submitted && !is_final(manager.find(submitted->view.job.id)->job.state)) {
        std::this_thread::sleep_for(1ms);
    }
    EXPECT_EQ(manager.find(submitted->view.job.id)->job.state, JobState::Done);
    return mesh.opened;
}

// Its first bytes and then all of them: what submitting has read the worker does not read again,
// unless there was no room to keep it.
TEST_F(JobManagerTest, ReadsTheFilesOfAJobOnce) {
    EXPECT_EQ(times_opened(jobs_, results_, {.threads = 1}), 2);
    EXPECT_EQ(times_opened(jobs_, results_, {.threads = 1, .accepted_bytes = 0}), 4);
}

// The good scene with a lamp that gives nothing: said by the check, by the submission, its answer
// and by the report, with what the picture shows behind it.
TEST_F(JobManagerTest, TellsWarningsEverywhere) {
    const auto manager = start();
    std::string body = small_job(1);
    const std::string lights = R"("lights":[)";
    body.insert(body.find(lights) + lights.size(),
                R"({"type":"point","position":[0,5,0],"intensity":0},)");
    const std::string code = R"("code":"lamp-without-light")",
                      at = R"("pointer":"/scene/lights/0")";
    const auto said = [&](const std::string& text) {
        return text.find(code) != std::string::npos && text.find(at) != std::string::npos;
    };
    EXPECT_TRUE(said(manager->validate(body).value()));
    const auto submitted = manager->submit(body, "");
    ASSERT_TRUE(submitted) << submitted.error().message;
    EXPECT_TRUE(said(submitted_job_json(*submitted)));
    wait_for_end(*manager, submitted->view.job.id);
    const auto report = manager->file(submitted->view.job.id, "report.json");
    ASSERT_TRUE(report);
    EXPECT_TRUE(said(report->content.all().value()));
    EXPECT_FALSE(said(manager->validate(small_job(1)).value()));
}

TEST_F(JobManagerTest, RendersWhatIsSubmitted) {
    const auto manager = start();
    const auto submitted = manager->submit(small_job(4, R"(,"labels":{"a":"b"})"), "");
    ASSERT_TRUE(submitted) << submitted.error().message;
    EXPECT_FALSE(submitted->replayed);
    EXPECT_EQ(submitted->view.job.name, "ball");
    const JobId id = submitted->view.job.id;
    wait_for_end(*manager, id);
    const auto view = manager->find(id);
    ASSERT_TRUE(view);
    EXPECT_EQ(view->job.state, JobState::Done) << view->job.failure;
    EXPECT_EQ(view->job.labels.at("a"), "b");
    EXPECT_EQ(view->images, (std::vector<std::string>{"image.exr", "image.png"}));
    EXPECT_EQ(view->progress.samples, 4U);
    EXPECT_EQ(view->progress.fraction, 1.0);
    for (const char* name : {"image.png", "image.exr", "report.json", "error.json", "error.csv",
                             "error.png", "plan.json", "health.json"}) {
        const auto file = manager->file(id, name);
        ASSERT_TRUE(file) << name;
        EXPECT_TRUE(file->final) << name;
        EXPECT_FALSE(file->content.empty()) << name;
        EXPECT_EQ(file->digest.size(), 64U) << name;
    }
    EXPECT_EQ(manager->file(id, "passwd").error().kind, ErrorKind::NotFound);
}

TEST_F(JobManagerTest, GivesTheSameBytesForAnyNumberOfThreads) {
    std::string exr;
    for (const int threads : {1, 2, 7}) {
        const auto manager = start({.threads = threads});
        const JobId id = submit(*manager, small_job(8, "", "[70,50]"));
        wait_for_end(*manager, id);
        const auto file = manager->file(id, "image.exr");
        ASSERT_TRUE(file);
        if (exr.empty()) exr = file->content.all().value();
        EXPECT_EQ(file->content.all().value(), exr) << threads << " threads";
    }
}

// The whole way: what is kept of a job shows it as if it had been rendered so.
TEST_F(JobManagerTest, ShowsAJobAgainAsIfRenderedSo) {
    const auto manager = start();
    const auto job = [](const std::string& more) {
        return small_job(4, R"(,"output":{"color_space":"xyz")" + more + "}");
    };
    const JobId plain = submit(*manager, job(""));
    const JobId otherwise = submit(
        *manager,
        job(R"(,"display":"display-p3","exposure":2,"adaptation":"bradford","gamut":"desaturate")"));
    wait_for_end(*manager, plain);
    wait_for_end(*manager, otherwise);
    const auto again = image_anew(*manager, plain, "image.png",
                                  {{"display", "display-p3"},
                                   {"exposure", "2"},
                                   {"adaptation", "bradford"},
                                   {"gamut", "desaturate"}});
    ASSERT_TRUE(again) << again.error().message;
    EXPECT_EQ(again->content.all().value(),
              manager->file(otherwise, "image.png")->content.all().value());
    EXPECT_TRUE(again->final);
}

TEST_F(JobManagerTest, ShowsTheNewestPassOfARunningJobOtherwise) {
    const auto manager = start();
    const JobId id = submit(*manager, endless_job());
    EXPECT_FALSE(image_anew(*manager, id, "image.png", {{"exposure", "2"}}) &&
                 manager->find(id)->images.empty());
    wait_for_picture(*manager, id);
    const auto again = image_anew(*manager, id, "image.png", {{"exposure", "2"}});
    ASSERT_TRUE(again) << again.error().message;
    EXPECT_FALSE(again->final);
    EXPECT_TRUE(image_anew(*manager, id, "image.exr", {{"color_space", "acescg"}}));
}

TEST_F(JobManagerTest, RefusesBadDocumentsAndStoresNothing) {
    const auto manager = start();
    EXPECT_EQ(manager->submit("{", "").error().kind, ErrorKind::Malformed);
    const auto refused = manager->submit(small_job(4, R"(,"colour":1)"), "");
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().kind, ErrorKind::InvalidInput);
    EXPECT_EQ(refused.error().problems.at(0).pointer, "/colour");
    EXPECT_TRUE(manager->list(10, "", std::nullopt)->jobs.empty());
}

TEST_F(JobManagerTest, RefusesWhatNeedsTooMuchMemory) {
    JobManagerOptions options{.threads = 1};
    options.documents.memory_bytes = 100'000'000;
    const auto manager = start(options);
    const auto refused = manager->submit(small_job(1, "", "[1000,1000]"), "");
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, "over-limit");
    EXPECT_TRUE(manager->submit(small_job(1), ""));
}

TEST_F(JobManagerTest, ReplaysAnIdempotencyKey) {
    const auto manager = start();
    const auto first = manager->submit(small_job(), "key");
    const auto again = manager->submit(small_job(), "key");
    ASSERT_TRUE(first && again);
    EXPECT_TRUE(again->replayed);
    EXPECT_EQ(again->view.job.id, first->view.job.id);
    EXPECT_EQ(manager->submit(small_job(5), "key").error().code, "idempotency-key-reused");
    EXPECT_EQ(manager->list(10, "", std::nullopt)->jobs.size(), 1U);
}

TEST_F(JobManagerTest, IsBusyWhenTheQueueIsFull) {
    const auto manager = start({.threads = 1, .scheduler = {.tasks = 2}});
    const JobId a = submit(*manager, endless_job());
    const JobId b = submit(*manager, endless_job());
    const auto refused = manager->submit(small_job(), "");
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().kind, ErrorKind::Busy);
    EXPECT_EQ(manager->list(10, "", std::nullopt)->jobs.size(), 2U) << "it must not be stored";
    ASSERT_TRUE(manager->cancel(a));
    ASSERT_TRUE(manager->cancel(b));
    wait_until([&] { return manager->submit(small_job(), "").has_value(); });
}

// Jobs that were accepted and have ended are out of the estimate, however they ended.
TEST_F(JobManagerTest, ThereIsNothingToWaitForWhenAllHaveEnded) {
    const auto manager = start({.threads = 1});
    EXPECT_EQ(manager->retry_after_s(), 1);
    const JobId running = submit(*manager, endless_job());
    const JobId waiting = submit(*manager, endless_job());
    ASSERT_TRUE(manager->cancel(running));
    ASSERT_TRUE(manager->cancel(waiting));
    wait_until([&] { return manager->retry_after_s() == 1; });
}

TEST_F(JobManagerTest, ANewJobShowsSomethingWhileALongOneRuns) {
    const auto manager = start({.threads = 1});
    const JobId long_job = submit(*manager, endless_job(R"(,"priority":100)"));
    wait_for_picture(*manager, long_job);
    const JobId late = submit(*manager, endless_job(R"(,"priority":-100)"));
    wait_for_picture(*manager, late);
    EXPECT_EQ(state_of(*manager, long_job), JobState::Running);
}

TEST_F(JobManagerTest, CancelsARunningJob) {
    const auto manager = start();
    const JobId id = submit(*manager, endless_job());
    wait_for_picture(*manager, id);
    const auto cancelled = manager->cancel(id);
    ASSERT_TRUE(cancelled);
    EXPECT_EQ(cancelled->job.state, JobState::Cancelled);
    wait_until([&] {
        const auto file = manager->file(id, "image.png");
        return file && file->final;
    });
    const auto again = manager->cancel(id);
    ASSERT_TRUE(again) << "cancelling is idempotent";
    EXPECT_EQ(again->job.state, JobState::Cancelled);
    EXPECT_GT(again->progress.samples, 0U);
}

TEST_F(JobManagerTest, EndsAJobAtTheServersLimit) {
    const auto manager = start({.threads = 2, .max_seconds = 0.1});
    const JobId id = submit(*manager, endless_job());
    wait_for_end(*manager, id);
    EXPECT_EQ(state_of(*manager, id), JobState::Done);
    const std::string report = manager->file(id, "report.json")->content.all().value();
    EXPECT_NE(report.find(R"("stopped_by":"server-limit")"), std::string::npos);
    EXPECT_TRUE(manager->file(id, "image.png"));
}

TEST_F(JobManagerTest, CancelsAQueuedJob) {
    const auto manager = start({.threads = 1, .scheduler = {.active_tasks = 1}});
    const JobId running = submit(*manager, endless_job());
    wait_for_picture(*manager, running);
    const JobId queued = submit(*manager, endless_job());
    EXPECT_EQ(manager->queue_length(), 1U);
    EXPECT_EQ(manager->file(queued, "image.png").error().code, "job-not-finished");
    ASSERT_TRUE(manager->cancel(queued));
    EXPECT_EQ(state_of(*manager, queued), JobState::Cancelled);
    EXPECT_EQ(manager->queue_length(), 0U);
    EXPECT_EQ(manager->file(queued, "image.png").error().code, "no-result");
    EXPECT_EQ(state_of(*manager, running), JobState::Running);
}

TEST_F(JobManagerTest, AnEndedJobStaysAsItIsWhenCancelled) {
    const auto manager = start();
    const JobId id = submit(*manager, small_job());
    wait_for_end(*manager, id);
    EXPECT_EQ(manager->cancel(id)->job.state, JobState::Done);
}

TEST_F(JobManagerTest, RemovesAJobWithItsFiles) {
    const auto manager = start();
    const JobId done = submit(*manager, small_job());
    wait_for_end(*manager, done);
    const JobId running = submit(*manager, endless_job());
    wait_for_picture(*manager, running);
    for (const JobId& id : {done, running}) {
        ASSERT_TRUE(manager->remove(id));
        EXPECT_EQ(manager->find(id).error().kind, ErrorKind::NotFound);
        EXPECT_EQ(manager->remove(id).error().kind, ErrorKind::NotFound);
    }
    manager->stop();
    EXPECT_TRUE(results_.names(done)->empty());
    EXPECT_TRUE(results_.names(running)->empty()) << "what a worker was writing must go too";
}

TEST_F(JobManagerTest, UnknownJobsAreNotFound) {
    const auto manager = start();
    const JobId id = "01890a5d-ac96-774b-bcce-b302099a8057";
    EXPECT_EQ(manager->find(id).error().kind, ErrorKind::NotFound);
    EXPECT_EQ(manager->cancel(id).error().kind, ErrorKind::NotFound);
    EXPECT_EQ(manager->file(id, "image.png").error().kind, ErrorKind::NotFound);
    EXPECT_EQ(manager->subscribe(id, [](const JobEvent&) {}).error().kind, ErrorKind::NotFound);
}

TEST_F(JobManagerTest, TellsTheWholeStoryOfAJob) {
    const auto manager = start();
    const JobId id = submit(*manager, endless_job());
    std::mutex mutex;
    std::vector<JobEvent> events;
    auto subscription = manager->subscribe(id, [&](const JobEvent& event) {
        const std::lock_guard lock(mutex);
        events.push_back(event);
    });
    ASSERT_TRUE(subscription);
    wait_until([&] {
        const std::lock_guard lock(mutex);
        const auto has = [&](const char* type) {
            return std::any_of(events.begin(), events.end(),
                               [&](const JobEvent& event) { return event.type == type; });
        };
        return has("preview") && has("progress");
    });
    ASSERT_TRUE(manager->cancel(id));
    wait_until([&] {
        const std::lock_guard lock(mutex);
        return events.back().type == "done";
    });
    EXPECT_EQ(events.front().type, "snapshot");
    EXPECT_NE(events.back().data.find(R"("state":"cancelled")"), std::string::npos);
    EXPECT_EQ(events.back().data.find('\n'), std::string::npos);
    // Whoever comes late is told how it ended.
    std::string types;
    const auto late =
        manager->subscribe(id, [&](const JobEvent& event) { types += event.type + " "; });
    ASSERT_TRUE(late);
    EXPECT_EQ(types, "snapshot done ");
}

TEST_F(JobManagerTest, PutsRunningJobsBackIntoTheQueueWhenItStops) {
    const auto manager = start();
    const JobId id = submit(*manager, endless_job());
    wait_for_picture(*manager, id);
    manager->stop();
    EXPECT_EQ(jobs_.find(id)->state, JobState::Queued);
    EXPECT_FALSE(manager->readiness().ready);
    EXPECT_EQ(manager->readiness().reason, "draining");
    EXPECT_EQ(manager->submit(small_job(), "").error().code, "draining");
}

// What a crash leaves behind: a job that is "running" in the store and nobody who runs it.
TEST_F(JobManagerTest, ARestartGivesTheSameBytesAsAnUninterruptedRun) {
    const std::string body = small_job(64, "", "[70,50]");
    JobId whole;
    {
        const auto manager = start();
        whole = submit(*manager, body);
        wait_for_end(*manager, whole);
    }
    JobId interrupted;
    {
        const auto manager = start({.threads = 1});
        interrupted = submit(*manager, body);
        wait_for_picture(*manager, interrupted);
        manager->stop();
    }
    ASSERT_EQ(jobs_.find(interrupted)->state, JobState::Queued);
    EXPECT_EQ(jobs_.find(interrupted)->attempts, 0U) << "an orderly stop is no crash";
    ASSERT_TRUE(jobs_.transition(interrupted, {JobState::Queued, JobState::Running, 1}));
    const auto manager = start();
    wait_for_end(*manager, interrupted);
    EXPECT_EQ(state_of(*manager, interrupted), JobState::Done);
    EXPECT_EQ(manager->file(interrupted, "image.exr")->content.all().value(),
              manager->file(whole, "image.exr")->content.all().value());
    EXPECT_EQ(manager->file(interrupted, "image.png")->content.all().value(),
              manager->file(whole, "image.png")->content.all().value());
}

TEST_F(JobManagerTest, AJobThatCannotBeTakenUpAgainFailsAlone) {
    Job broken;
    broken.id = "01890a5d-ac96-774b-bcce-b302099a8057";
    broken.request = "{}";
    ASSERT_TRUE(jobs_.insert(broken, {}));
    const auto manager = start();
    const JobId good = submit(*manager, small_job());
    wait_for_end(*manager, broken.id);
    wait_for_end(*manager, good);
    EXPECT_EQ(state_of(*manager, broken.id), JobState::Failed);
    EXPECT_NE(manager->find(broken.id)->job.failure, "");
    EXPECT_EQ(state_of(*manager, good), JobState::Done);
}

TEST_F(JobManagerTest, ValidatesWithoutRendering) {
    const auto manager = start();
    const auto good = manager->validate(small_job());
    ASSERT_TRUE(good);
    EXPECT_NE(good->find(R"("valid":true)"), std::string::npos);
    EXPECT_NE(good->find(R"("plan":{)"), std::string::npos);
    EXPECT_NE(good->find(R"("notes":{"uplift":{"count":0,)"), std::string::npos);
    EXPECT_EQ(manager->validate("[]").error().kind, ErrorKind::InvalidInput);
    EXPECT_TRUE(manager->list(10, "", std::nullopt)->jobs.empty());
}

/// Gives a job as it was before `after_read`, which may let time go by.
class SlowReader final : public MemoryJobStore {
  public:
    Result<Job> find(const JobId& id) const override {
        auto job = MemoryJobStore::find(id);
        if (const auto hook = std::exchange(after_read, {})) hook(id);
        return job;
    }
    Result<JobListing> list(std::size_t limit, const std::string& cursor,
                            std::optional<JobState> state) const override {
        auto page = MemoryJobStore::list(limit, cursor, state);
        if (const auto hook = std::exchange(after_read, {})) hook(page->jobs.at(0).id);
        return page;
    }
    mutable std::function<void(const JobId&)> after_read;  ///< called once
};

// Between reading a job and asking its task for more, the job may end: what a client sees is of
// before or of after.
TEST_F(JobManagerTest, ShowsAJobThatEndsWhileItIsLookedAt) {
    const auto look = [](const JobManager& manager, const JobId& id, int way) {
        if (way == 0) return manager.find(id).value();
        return manager.list(1, "", std::nullopt)->jobs.at(0);
    };
    for (const int way : {0, 1}) {
        SlowReader jobs;
        JobManager manager(jobs, results_, assets_, {.threads = 1});
        ASSERT_TRUE(manager.start());
        const JobId id = submit(manager, endless_job());
        wait_for_picture(manager, id);
        const auto cancel_and_wait = [&](const JobId& read) {
            ASSERT_TRUE(manager.cancel(read));
            wait_until([&] { return !results_.names(read)->empty(); });
            std::this_thread::sleep_for(20ms);  // until the task is most likely forgotten
        };
        jobs.after_read = cancel_and_wait;
        const JobView view = look(manager, id, way);
        EXPECT_FALSE(view.images.empty()) << way;
        EXPECT_GT(view.progress.samples, 0U) << way;
    }
}

TEST_F(JobManagerTest, HasTheFileOfAJobThatEndsWhileItIsAskedFor) {
    SlowReader jobs;
    JobManager manager(jobs, results_, assets_, {.threads = 1});
    ASSERT_TRUE(manager.start());
    const JobId id = submit(manager, endless_job());
    wait_for_picture(manager, id);
    jobs.after_read = [&](const JobId& read) {
        ASSERT_TRUE(manager.cancel(read));
        wait_until([&] { return !results_.names(read)->empty(); });
        std::this_thread::sleep_for(20ms);  // until the task is most likely forgotten
    };
    EXPECT_TRUE(manager.file(id, "image.exr"));
}

/// What a process leaves behind that ended `crashes` times while it rendered the job.
JobId add_crashed(JobStore& jobs, const std::string& body, int crashes, int number = 1) {
    Job job;
    job.id = "01890a5d-ac96-774b-bcce-00000000000" + std::to_string(number);
    const auto request = api::parse_job(body, {}, tests::NoAssets());
    job.request = request->canonical;
    job.digest = request->digest;
    job.scene_digest = request->scene_digest;
    EXPECT_TRUE(jobs.insert(job, {}));
    for (int i = 0; i < crashes; ++i) {
        if (i > 0) {
            EXPECT_TRUE(jobs.transition(job.id, {JobState::Running, JobState::Queued, 1}));
        }
        EXPECT_TRUE(jobs.transition(job.id, {JobState::Queued, JobState::Running, 1}));
    }
    return job.id;
}

TEST_F(JobManagerTest, AJobThatEndedTheProcessThreeTimesIsNotBegunAgain) {
    const JobId crashed = add_crashed(jobs_, small_job(), 3);
    const JobId suspect = add_crashed(jobs_, small_job(), 2, 2);
    const auto manager = start();
    EXPECT_EQ(state_of(*manager, crashed), JobState::Failed);
    EXPECT_EQ(manager->find(crashed)->job.failure_code, "crashed-the-server");
    EXPECT_NE(job_json(*manager->find(crashed)).find(R"("attempts":3)"), std::string::npos);
    wait_for_end(*manager, suspect);
    EXPECT_EQ(state_of(*manager, suspect), JobState::Done);
    EXPECT_EQ(manager->find(suspect)->job.attempts, 3U);
}

TEST_F(JobManagerTest, TheLastBeginOfASuspectIsAloneAndFirst) {
    const JobId innocent = add_crashed(jobs_, endless_job(R"(,"priority":100)"), 0, 1);
    const JobId suspect = add_crashed(jobs_, endless_job(), 2, 2);
    const auto manager = start();
    wait_for_picture(*manager, suspect);
    EXPECT_EQ(state_of(*manager, innocent), JobState::Queued);
    ASSERT_TRUE(manager->cancel(suspect));
    wait_for_picture(*manager, innocent);
}

TEST_F(JobManagerTest, DoesNotRenderWhatWasNotAccepted) {
    Job job;
    job.id = "01890a5d-ac96-774b-bcce-b302099a8057";
    const auto accepted = api::parse_job(small_job(4), {}, assets_);
    job.digest = accepted->digest;
    job.scene_digest = accepted->scene_digest;
    job.request = api::parse_job(small_job(5), {}, assets_)->canonical;  // one number differs
    ASSERT_TRUE(jobs_.insert(job, {}));
    const auto manager = start();
    wait_for_end(*manager, job.id);
    EXPECT_EQ(state_of(*manager, job.id), JobState::Failed);
    EXPECT_EQ(manager->find(job.id)->job.failure_code, "store-damaged");
}

// The job was accepted by a process that had more.
TEST_F(JobManagerTest, AJobThatNoLongerFitsFailsBeforeItTakesMemory) {
    const JobId id = add_crashed(jobs_, small_job(1, "", "[1000,1000]"), 0);
    JobManagerOptions options{.threads = 1};
    options.documents.memory_bytes = 100'000'000;
    const auto manager = start(options);
    wait_for_end(*manager, id);
    EXPECT_EQ(manager->find(id)->job.failure_code, "over-limit");
}

}  // namespace
}  // namespace bouguer::server
