// SPDX-License-Identifier: Apache-2.0
#include <unistd.h>

#include <chrono>
#include <iostream>
#include <thread>

#include "server/cli/command_line.h"
#include "server/cli/commands.h"
#include "server/cli/daemon.h"
#include "server/cli/document.h"
#include "server/cli/stop_signal.h"
#include "server/http/authority.h"
#include "server/line_writer.h"
#include "server/log.h"
#include "server/storage/durable_file.h"

namespace bouguer::server {
namespace {

namespace fs = std::filesystem;

/// The file in the data folder that tells other processes the port; gone with the object.
class PortFile {
  public:
    explicit PortFile(fs::path path) : path_(std::move(path)) {}
    ~PortFile() {
        std::error_code ignored;
        fs::remove(path_, ignored);
    }
    PortFile(const PortFile&) = delete;
    PortFile& operator=(const PortFile&) = delete;

    [[nodiscard]] Result<void> write(int port) const {
        return replace_file(path_, std::to_string(port) + "\n");
    }

  private:
    fs::path path_;
};

/// On standard output, which nobody may be reading either.
std::unique_ptr<LineWriter> standard_output() {
    return std::make_unique<LineWriter>(STDOUT_FILENO, [](std::uint64_t lines) {
        return std::to_string(lines) + " lines were lost\n";
    });
}

void announce(LineWriter& out, const ListenAddress& address) {
    out.add("listening on " + url_of(address) + "\n");
    log_event(LogLevel::Info, "listening", {{"url", url_of(address)}});
    if (is_loopback(address.host)) return;
    log_event(LogLevel::Warning, "open-to-all",
              {{"url", url_of(address)},
               {"detail",
                "other machines can reach this address and there is no login: whoever "
                "can reach the port can use the service"}});
}

/// The listener for health, which tells strangers nothing else.
void announce_health(LineWriter& out, const ServeOptions& options, int port) {
    const auto asked = listen_address_from(options.health_listen);
    if (!asked) return;
    const std::string url = url_of({asked->host, port});
    out.add("health at " + url + "\n");
    log_event(LogLevel::Info, "health-listening", {{"url", url}});
}

/// The orderly end: seen from outside first, and only then closed.
void end(Daemon& daemon, const ServeOptions& options) {
    log_event(LogLevel::Info, "draining",
              {{"delay_seconds", std::to_string(options.drain_delay_s)}});
    daemon.refuse_new_jobs();
    std::this_thread::sleep_for(std::chrono::seconds(options.drain_delay_s));
    daemon.drain();
    log_event(LogLevel::Info, "stopped", {});
}

/// From the first byte on disk to the last answer.
Result<void> serve(const ServeOptions& options, const ListenAddress& asked) {
    StopSignal stop;
    const IgnoredSignals ignored;
    auto daemon = Daemon::start(options, asked);
    if (!daemon) return tl::unexpected(daemon.error());
    const ListenAddress address{asked.host, daemon->port()};
    const PortFile port_file(options.data / "port");
    if (auto written = port_file.write(address.port); !written) {
        log_event(LogLevel::Warning, "port-file", {{"error", written.error().message}});
    }
    const auto out = standard_output();
    announce(*out, address);
    announce_health(*out, options, daemon->health_port());
    stop.wait();
    end(*daemon, options);
    return {};
}

}  // namespace

int run_serve(const ServeOptions& options) {
    const auto asked = listen_address_from(options.listen);
    if (!asked) {
        std::cerr << "bouguer: --listen wants HOST:PORT, e.g. 127.0.0.1:8080\n";
        return kExitBadInput;
    }
    if (!is_loopback(asked->host) && !options.allow_remote) {
        std::cerr << "bouguer: " << asked->host
                  << " can be reached from other machines, and there is no login; say "
                     "--allow-remote if that is wanted\n";
        return kExitBadInput;
    }
    // what is said here can be interrupted: the signals are their own masters again
    if (auto served = serve(options, *asked); !served) {
        print_error(std::cerr, served.error());
        return kExitFailed;
    }
    return kExitOk;
}

}  // namespace bouguer::server
