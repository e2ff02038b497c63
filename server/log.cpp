// SPDX-License-Identifier: Apache-2.0
#include "server/log.h"

#include <spdlog/sinks/base_sink.h>
#include <spdlog/spdlog.h>
#include <unistd.h>

#include <mutex>

#include "api/json_builder.h"
#include "server/line_writer.h"
#include "server/log_text.h"
#include "server/utc_time.h"

namespace bouguer::server {
namespace {

spdlog::level::level_enum spdlog_level(LogLevel level) {
    switch (level) {
        case LogLevel::Info:
            return spdlog::level::info;
        case LogLevel::Warning:
            return spdlog::level::warn;
        case LogLevel::Error:
            return spdlog::level::err;
    }
    return spdlog::level::err;
}

std::string_view name_of(LogLevel level) {
    switch (level) {
        case LogLevel::Info:
            return "info";
        case LogLevel::Warning:
            return "warning";
        case LogLevel::Error:
            return "error";
    }
    return "error";
}

using Fields = std::initializer_list<std::pair<std::string_view, std::string>>;

/// One event as a line of JSON, without a line feed.
std::string line_of(LogLevel level, std::string_view event, Fields fields) {
    api::JsonObject line;
    line.set("time", utc_text(unix_ms())).set("level", name_of(level)).set("event", event);
    for (const auto& [key, value] : fields) {
        if (!value.empty()) line.set(key, value);
    }
    return escape_invisible(line.text());
}

/// Hands lines over to a thread that writes them to standard error: whoever logs goes on.
class StandardError : public spdlog::sinks::base_sink<std::mutex> {
  protected:
    void sink_it_(const spdlog::details::log_msg& message) override {
        writer_.add(std::string(message.payload.data(), message.payload.size()) + "\n");
    }
    void flush_() override {}

  private:
    LineWriter writer_{STDERR_FILENO, [](std::uint64_t dropped) {
                           return line_of(LogLevel::Warning, "log-dropped",
                                          {{"count", std::to_string(dropped)}}) +
                                  "\n";
                       }};
};

/// Lives until the program ends in order; what waits is written then.
spdlog::logger& logger() {
    static const auto instance =
        std::make_shared<spdlog::logger>("bouguer", std::make_shared<StandardError>());
    return *instance;
}

}  // namespace

void set_log_level(LogLevel level) { logger().set_level(spdlog_level(level)); }

void log_event(LogLevel level, std::string_view event,
               std::initializer_list<std::pair<std::string_view, std::string>> fields) noexcept {
    try {
        if (!logger().should_log(spdlog_level(level))) return;
        logger().log(spdlog_level(level), line_of(level, event, fields));
    } catch (...) {  // NOLINT(bugprone-empty-catch): nothing is left to tell it to
    }
}

}  // namespace bouguer::server
