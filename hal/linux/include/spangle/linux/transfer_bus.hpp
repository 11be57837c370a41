// What every Linux bus shares: tokens and the thread that carries transfers, buffers, and the lines beside
// the data: reset, backlight, tearing effect.
#pragma once

#include <array>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

#include <spangle/hal/bus.hpp>
#include <spangle/linux/lines.hpp>

namespace spangle::hal {

/// The lines of a panel module beside its bus. What is not wired stays empty.
struct PanelPins {
    LineRef reset;     ///< the reset line; low resets the panel
    LineRef backlight; ///< the backlight's line; high lights it
    LineRef te;        ///< the TE line, which rises when vertical blanking begins
};

/// The base of the buses of hosts: GpioBus, I2cBus, SpidevBus, FtdiBus.
class TransferBus : public Bus {
  public:
    /// A bus is not copied.
    TransferBus(const TransferBus&) = delete;
    /// A bus is not assigned.
    TransferBus& operator=(const TransferBus&) = delete;

    Result<Buffer> acquire(std::size_t size) final;
    /// One list is under way at a time: Fault::busy while one is.
    Result<Token> submit(const Op* ops, std::size_t count) final;
    bool done(Token token) const final;
    /// After Fault::timeout the list is still under way. Outcomes of the last 16 lists are remembered.
    Result<void> wait(Token token, std::uint32_t timeout_micros) final;

    /// Switches a backlight that has a line of its own. Fault::busy: a list is under way.
    Result<void> backlight(bool on);

  protected:
    /// The value of BusCaps::late_us on hosts. A thread may wait for a processor, and a kernel for its
    /// worker.
    static constexpr std::uint32_t late_us = 1000000;

    /// What a byte that is sent means to the controller.
    enum class Byte { command, parameter, pixel };

    /// `asynchronous`: a thread carries the lists while the next frame is drawn; else submit() does.
    TransferBus(const PanelPins& pins, bool asynchronous);
    /// Derived classes must have called stop() before.
    ~TransferBus();
    /// Waits for the running list and ends the thread. First thing in a derived destructor.
    void stop();
    /// Requests the pins again; nothing may be under way.
    Result<void> open_pins();
    /// Whether a list is under way.
    bool busy() const;

    // The pins beside the data. A bus that drives some of them itself overrides these.
    /// Whether the bus can wait for TE.
    virtual bool has_te() const { return pins_.te.wired(); }
    /// Whether the bus drives a reset line.
    virtual bool has_reset() const { return pins_.reset.wired(); }
    /// Whether the bus drives a backlight line.
    virtual bool has_backlight() const { return pins_.backlight.wired(); }
    /// Drives the reset line.
    virtual Result<void> set_reset(bool high);
    /// Drives the backlight line.
    virtual Result<void> set_backlight(bool on);
    /// Waits for TE's edge and returns its time in nanoseconds. Fault::timeout: there was none.
    virtual Result<std::uint64_t> await_te(std::uint32_t at_most_micros);

    /// The rule this op breaks on this bus, or null. Called before anything of the list is sent.
    virtual const char* refusal(const Op& op) const = 0;
    /// The chip is addressed from here to the end of the list.
    virtual Result<void> begin() { return {}; }
    /// Sends bytes, or keeps them until flush().
    virtual Result<void> put(Byte kind, const std::uint8_t* bytes, std::size_t count) = 0;
    /// Returns when all bytes put are on the [wire](docs/glossary.md#wire).
    virtual Result<void> flush() { return {}; }
    /// Reads an answer. It is called only where caps() has a read clock.
    virtual Result<void> read(const Op&) { return {}; }
    /// Is called after the last op, or the one that failed. Bytes that were put and not flushed are dropped.
    virtual Result<void> end() { return {}; }

    /// Owns the text of the last error.
    ErrorText error_;

  private:
    struct Outcome {
        std::uint32_t token = 0; ///< number of the list that had this outcome; 0: none
        Error error;
        std::array<char, 320> text{};
    };

    PanelPins pins_;
    Lines reset_, backlight_;
    EdgeLine te_;
    bool asynchronous_;
    std::vector<std::unique_ptr<std::uint8_t[]>> buffers_;

    mutable std::mutex mutex_; ///< guards the members below
    mutable std::condition_variable changed_;
    std::vector<Op> ops_;
    std::uint32_t last_token_ = 0;
    bool running_ = false, stopping_ = false;
    std::array<Outcome, 16> outcomes_;
    std::thread thread_;

    const char* refusal_of(const Op& op) const;
    void carry();
    void finish(const Result<void>& result);
    Result<void> run_list();
    Result<void> run(const Op& op);
    Result<void> wait_line(const Op& op);
    Result<void> put_rows(const Op& op);
    Result<void> put_repeat(const Op& op);
    Result<void> pulse_reset(std::uint32_t micros);
};

} // namespace spangle::hal
