// SPDX-License-Identifier: Apache-2.0
#include "server/log.h"

#include <spdlog/sinks/stdout_sinks.h>
#include <spdlog/spdlog.h>

#include "api/json_builder.h"
#include "server/utc_time.h"

namespace bouguer::server {
namespace {

spdlog::logger& logger() {
    static const auto instance = [] {
        auto made = std::make_shared<spdlog::logger>(
            "bouguer", std::make_shared<spdlog::sinks::stderr_sink_mt>());
        made->set_pattern("%v");
        made->flush_on(spdlog::level::info);
        return made;
    }();
    return *instance;
}

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

}  // namespace

void set_log_level(LogLevel level) { logger().set_level(spdlog_level(level)); }

void log_event(LogLevel level, std::string_view event,
               std::initializer_list<std::pair<std::string_view, std::string>> fields) noexcept {
    try {
        if (!logger().should_log(spdlog_level(level))) return;
        api::JsonObject line;
        line.set("time", utc_text(unix_ms())).set("level", name_of(level)).set("event", event);
        for (const auto& [key, value] : fields) {
            if (!value.empty()) line.set(key, value);
        }
        logger().log(spdlog_level(level), line.text());
    } catch (...) {  // NOLINT(bugprone-empty-catch): nothing is left to tell it to
    }
}

}  // namespace bouguer::server
