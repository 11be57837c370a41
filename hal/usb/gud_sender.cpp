#include "hal/usb/gud_sender.hpp"

#include <utility>

namespace spangle::hal {

GudSender::GudSender(GudSession& session, std::uint32_t poll_ms)
    : session_(session), poll_period_(poll_ms), thread_([this] { run(); }) {}

GudSender::~GudSender() {
    {
        const std::lock_guard lock(mutex_);
        is_stopping_ = true;
    }
    state_changed_.notify_all();
    thread_.join();
}

void GudSender::start(std::unique_ptr<GudFrame> frame) {
    {
        const std::lock_guard lock(mutex_);
        frame_ = std::move(frame);
        is_sending_ = true;
    }
    state_changed_.notify_all();
}

GudSender::SentFrame GudSender::wait() {
    std::unique_lock lock(mutex_);
    state_changed_.wait(lock, [this] { return !is_sending_; });
    return {std::move(frame_), outcome_};
}

Result<void> GudSender::send(const GudFrame& frame) {
    for (const GudFrame::Band& band : frame.bands)
        if (const auto r = session_.send(band.buffer, frame.wire.data() + band.at); !r)
            return r;
    return {};
}

/// The thread. A frame that was started is sent first, whatever else is due.
void GudSender::run() {
    std::unique_lock lock(mutex_);
    while (!is_stopping_) {
        if (is_sending_) {
            outcome_ = send(*frame_);
            is_sending_ = false;
            state_changed_.notify_all();
        } else if (!wants_polls_now()) {
            state_changed_.wait(lock);
        } else if (std::chrono::steady_clock::now() < last_poll_ + poll_period_) {
            state_changed_.wait_until(lock, last_poll_ + poll_period_);
        } else {
            session_.poll();
            last_poll_ = std::chrono::steady_clock::now();
        }
    }
}

} // namespace spangle::hal
