#include "hal/usb/gud_sender.hpp"

#include <utility>

namespace spangle::hal {

GudSender::GudSender(GudSession& session, std::uint32_t poll_ms)
    : session_(session), period_(poll_ms), thread_([this] { run(); }) {}

GudSender::~GudSender() {
    {
        const std::lock_guard lock(mutex_);
        stopping_ = true;
    }
    changed_.notify_all();
    thread_.join();
}

void GudSender::start(std::unique_ptr<GudFrame> frame) {
    {
        const std::lock_guard lock(mutex_);
        frame_ = std::move(frame);
        under_way_ = true;
    }
    changed_.notify_all();
}

GudSender::Sent GudSender::wait() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return !under_way_; });
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
    while (!stopping_) {
        if (under_way_) {
            outcome_ = send(*frame_);
            under_way_ = false;
            changed_.notify_all();
        } else if (!polls()) {
            changed_.wait(lock);
        } else if (std::chrono::steady_clock::now() < last_poll_ + period_) {
            changed_.wait_until(lock, last_poll_ + period_);
        } else {
            session_.poll();
            last_poll_ = std::chrono::steady_clock::now();
        }
    }
}

} // namespace spangle::hal
