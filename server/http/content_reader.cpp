// SPDX-License-Identifier: Apache-2.0
#include "server/http/content_reader.h"

#include <exception>

namespace bouguer::server {
namespace {

Result<std::string> bytes_of(ContentReader::Request& request) {
    try {
        std::string bytes = std::move(request.room);
        auto read = request.content.read(0, request.content.size(), bytes);
        if (!read) return tl::unexpected(std::move(read).error());
        return bytes;
    } catch (const std::exception&) {
        return tl::unexpected(Error{});  // no memory, not even for words
    }
}

}  // namespace

ContentReader::ContentReader(Deliver deliver) : deliver_(std::move(deliver)) {
    thread_ = std::thread([this] { run(); });
}

ContentReader::~ContentReader() { stop(); }

void ContentReader::ask(Request request) {
    {
        const std::lock_guard lock(mutex_);
        queue_.push_back(std::move(request));
    }
    some_.notify_one();
}

void ContentReader::stop() {
    {
        const std::lock_guard lock(mutex_);
        stopping_ = true;
    }
    some_.notify_one();
    if (thread_.joinable()) thread_.join();
}

void ContentReader::run() {
    for (;;) {
        std::unique_lock lock(mutex_);
        some_.wait(lock, [this] { return stopping_ || !queue_.empty(); });
        if (stopping_) return;
        Request request = std::move(queue_.front());
        queue_.pop_front();
        lock.unlock();
        deliver_(request.connection, bytes_of(request));
    }
}

}  // namespace bouguer::server
