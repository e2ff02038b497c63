// SPDX-License-Identifier: Apache-2.0
#include "server/line_writer.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <future>
#include <memory>
#include <optional>
#include <sstream>
#include <vector>

namespace bouguer::server {
namespace {

using namespace std::chrono_literals;

/// A pipe whose reader reads when the test says so.
class Pipe {
  public:
    Pipe() { EXPECT_EQ(::pipe2(ends_.data(), O_CLOEXEC), 0); }
    ~Pipe() {
        close_writer();
        ::close(ends_[0]);
    }
    Pipe(const Pipe&) = delete;
    Pipe& operator=(const Pipe&) = delete;

    [[nodiscard]] int writer() const { return ends_[1]; }
    void close_writer() {
        if (ends_[1] >= 0) ::close(std::exchange(ends_[1], -1));
    }
    /// The next line without its line feed; waits for it. Empty: nothing more comes.
    std::optional<std::string> line() {
        std::string text;
        for (char c = 0; ::read(ends_[0], &c, 1) == 1;) {
            if (c == '\n') return text;
            text += c;
        }
        return std::nullopt;
    }

  private:
    std::array<int, 2> ends_{-1, -1};
};

std::string lost(std::uint64_t dropped) { return "lost " + std::to_string(dropped) + "\n"; }

TEST(LineWriter, WritesInOrderAndAllAtTheEnd) {
    Pipe pipe;
    {
        LineWriter writer(pipe.writer(), &lost, {.patience = 1min});
        for (int i = 0; i < 100; ++i) writer.add(std::to_string(i) + "\n");
    }
    pipe.close_writer();
    for (int i = 0; i < 100; ++i) EXPECT_EQ(pipe.line(), std::to_string(i));
    EXPECT_FALSE(pipe.line());
}

TEST(LineWriter, WritesLongLinesWhole) {
    Pipe pipe;
    const std::string text(200'000, 'x');
    LineWriter writer(pipe.writer(), &lost);
    writer.add(text + "\n");
    EXPECT_EQ(pipe.line(), text);
}

// 20 MB for a reader that does not read: a writer that waited would wait for ever here.
TEST(LineWriter, NeverWaitsAndTellsWhatItDropped) {
    constexpr std::uint64_t kLines = 200'000;
    Pipe pipe;
    LineWriter writer(pipe.writer(), &lost, {.bytes = 100'000});
    for (std::uint64_t i = 0; i < kLines; ++i) {
        writer.add(std::to_string(i) + std::string(100, ' ') + "\n");
    }
    std::uint64_t told = 0;  // written, or counted where they would stand
    std::uint64_t dropped = 0;
    while (told < kLines) {
        const std::string line = *pipe.line();
        if (line.substr(0, 5) == "lost ") {
            dropped += std::stoull(line.substr(5));
            told += std::stoull(line.substr(5));
        } else {
            ASSERT_EQ(std::stoull(line), told++);
        }
    }
    EXPECT_EQ(told, kLines);
    EXPECT_GT(dropped, 0U);
    writer.add("after\n");
    EXPECT_EQ(pipe.line(), "after");
}

// Lines are dropped when memory is short, too; then there may be none for the note.
TEST(LineWriter, TellsLaterWhatItHasNoMemoryToTell) {
    Pipe pipe;
    std::promise<void> tried;
    {
        LineWriter writer(pipe.writer(),
                          [&, first = true](std::uint64_t dropped) mutable {
                              if (!std::exchange(first, false)) return lost(dropped);
                              tried.set_value();
                              throw std::bad_alloc();
                          },
                          {.bytes = 200, .patience = 1min});
        writer.add(std::string(500, 'x'));
        tried.get_future().wait();
        writer.add("good\n");
    }
    pipe.close_writer();
    EXPECT_EQ(pipe.line(), "good");
    EXPECT_EQ(pipe.line(), "lost 1");
}

TEST(LineWriter, EndsThoughNobodyReads) {
    Pipe pipe;
    auto writer = std::make_unique<LineWriter>(
        pipe.writer(), &lost, LineWriterOptions{.bytes = 1'000'000, .patience = 20ms});
    writer->add(std::string(900'000, 'x'));
    writer.reset();
    SUCCEED() << "here";
}

TEST(LineWriter, CountsWhatTheSystemRefuses) {
    Pipe pipe;
    const int fd = ::open("/dev/full", O_WRONLY | O_CLOEXEC);
    ASSERT_GE(fd, 0);
    std::promise<void> refused;
    LineWriter writer(fd, [&, first = true](std::uint64_t dropped) mutable {
        if (std::exchange(first, false)) refused.set_value();
        return lost(dropped);
    });
    writer.add("nowhere\n");
    refused.get_future().wait();
    ASSERT_EQ(::dup2(pipe.writer(), fd), fd);
    std::vector<std::string> lines;
    writer.add("there\n");
    for (int i = 0; i < 2; ++i) lines.push_back(*pipe.line());
    // the first note may have been written after the change already
    EXPECT_NE(std::find(lines.begin(), lines.end(), "there"), lines.end());
    EXPECT_NE(std::find(lines.begin(), lines.end(), "lost 1"), lines.end());
    ::close(fd);
}

}  // namespace
}  // namespace bouguer::server
