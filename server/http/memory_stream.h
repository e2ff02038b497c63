// SPDX-License-Identifier: Apache-2.0
// What the HTTP library takes for a socket: a request line to read, a string to write to.
#pragma once

#include <httplib.h>

#include <string>

namespace bouguer::server {

/// Reads never block and writes never fail: the network is the front's business.
class MemoryStream final : public httplib::Stream {
  public:
    MemoryStream(std::string input, std::string& output)
        : input_(std::move(input)), output_(&output) {}

    [[nodiscard]] bool is_readable() const override { return true; }
    [[nodiscard]] bool is_writable() const override { return true; }
    ssize_t read(char* to, std::size_t size) override {
        const std::size_t n = input_.copy(to, size, at_);
        at_ += n;
        return static_cast<ssize_t>(n);
    }
    ssize_t write(const char* from, std::size_t size) override {
        output_->append(from, size);
        return static_cast<ssize_t>(size);
    }
    void get_remote_ip_and_port(std::string& ip, int& port) const override {
        ip.clear();
        port = 0;
    }
    void get_local_ip_and_port(std::string& ip, int& port) const override {
        ip.clear();
        port = 0;
    }
    /// The library compares it with FD_SETSIZE; there is no socket here.
    [[nodiscard]] socket_t socket() const override { return 0; }

  private:
    std::string input_;
    std::string* output_;
    std::size_t at_ = 0;
};

}  // namespace bouguer::server
