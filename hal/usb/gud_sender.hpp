// The thread behind a GUD display: it sends frames while the next ones are drawn, and asks devices that want
// it for their connector's status.
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <thread>

#include "hal/usb/gud_frame.hpp"
#include "hal/usb/gud_session.hpp"

namespace spangle::hal {

class GudSender {
  public:
    GudSender(GudSession& session, std::uint32_t poll_ms);
    /// No frame may be under way when this is called.
    ~GudSender();
    GudSender(const GudSender&) = delete;
    GudSender& operator=(const GudSender&) = delete;

    /// Starts to send a frame; one may be under way at a time. The frame is the sender's until wait() gives
    /// it back, and nobody else can reach it.
    void start(std::unique_ptr<GudFrame> frame);
    bool busy() const { return is_sending_; } ///< true while a frame is sent, for which wait() waits
    struct SentFrame {
        std::unique_ptr<GudFrame> frame; ///< the frame that was sent; null: none was started
        Result<void> outcome;
    };
    SentFrame wait();

    /// Runs `use` with the session while nothing else uses it; no frame may be under way.
    template <class Use> Result<void> with_exclusive_session(Use use) {
        const std::lock_guard lock(mutex_);
        const Result<void> result = use(session_);
        last_poll_ = std::chrono::steady_clock::now();
        state_changed_.notify_all(); // wakes the thread, because the device may now want polls
        return result;
    }

  private:
    GudSession& session_;
    const std::chrono::milliseconds poll_period_;
    std::mutex mutex_; ///< whoever holds this lock may use the session
    std::condition_variable state_changed_;
    bool is_stopping_ = false;
    std::atomic<bool> is_sending_ = false;
    std::unique_ptr<GudFrame> frame_; ///< the frame that is sent, or was sent last
    Result<void> outcome_;
    std::chrono::steady_clock::time_point last_poll_;
    std::thread thread_;

    void run();
    Result<void> send(const GudFrame& frame);
    bool wants_polls_now() const { return session_.is_alive() && session_.wants_polls(); }
};

} // namespace spangle::hal
