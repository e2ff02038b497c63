// SPDX-License-Identifier: Apache-2.0
#include "server/http/door.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/epoll.h>
#include <sys/resource.h>

#include "tests/server/http/raw_client.h"

namespace bouguer::server {
namespace {

using testing::RawClient;

/// Lets the process open no more files as long as it lives.
class NoDescriptors {
  public:
    NoDescriptors() {
        getrlimit(RLIMIT_NOFILE, &before_);
        const FileDescriptor next(::open("/dev/null", O_RDONLY | O_CLOEXEC));
        rlimit none = before_;
        none.rlim_cur = static_cast<rlim_t>(next.get());
        setrlimit(RLIMIT_NOFILE, &none);
    }
    ~NoDescriptors() { setrlimit(RLIMIT_NOFILE, &before_); }
    NoDescriptors(const NoDescriptors&) = delete;
    NoDescriptors& operator=(const NoDescriptors&) = delete;

  private:
    rlimit before_{};
};

class DoorTest : public ::testing::Test {
  protected:
    /// Whether a client is said to wait.
    [[nodiscard]] bool rings(int patience_ms) const {
        epoll_event event{};
        return ::epoll_wait(epoll_.get(), &event, 1, patience_ms) == 1;
    }

    FileDescriptor epoll_{::epoll_create1(EPOLL_CLOEXEC)};
    Door door_{std::move(*Listener::open("127.0.0.1", 0)), epoll_.get(), 7};
    const Door::Clock::time_point now_ = Door::Clock::now();
};

TEST_F(DoorTest, LetsClientsIn) {
    const RawClient client(door_.port());
    ASSERT_TRUE(rings(2000));
    const auto accepted = door_.accept(now_);
    ASSERT_TRUE(accepted);
    EXPECT_EQ(accepted->client, "127.0.0.1");
    EXPECT_FALSE(door_.accept(now_));
    EXPECT_FALSE(door_.is_resting()) << "that nobody waits is no reason";
}

TEST_F(DoorTest, RestsOutOfDescriptorsAndLosesNobody) {
    const RawClient client(door_.port());
    ASSERT_TRUE(rings(2000));
    {
        const NoDescriptors none;
        EXPECT_FALSE(door_.accept(now_));
    }
    EXPECT_TRUE(door_.is_resting());
    EXPECT_FALSE(rings(0)) << "a client waits, but who would call it in?";
    door_.look(now_ + Door::kRest / 2);
    EXPECT_TRUE(door_.is_resting());
    door_.look(now_ + Door::kRest);
    EXPECT_FALSE(door_.is_resting());
    ASSERT_TRUE(rings(2000));
    EXPECT_TRUE(door_.accept(now_));
}

}  // namespace
}  // namespace bouguer::server
