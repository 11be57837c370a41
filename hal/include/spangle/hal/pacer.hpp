// When a frame may go out: the refresh of the panel, the tearing-effect line, a [wire](docs/glossary.md#wire)
// that is busy.
#pragma once

#include <cstdint>

#include <spangle/hal/panel_config.hpp>
#include <spangle/hal/refresh.hpp>
#include <spangle/hal/transfer.hpp>

namespace spangle::hal {

/// What became of the frames presented so far.
struct PresentCounters {
    std::uint32_t sent = 0;            ///< frames of which at least one window was sent
    std::uint32_t put_off = 0;         ///< frames dropped, or merged with the next, because the wire was busy
    std::uint32_t led = 0, lagged = 0; ///< tear-free frames that started in the blanking, or behind the beam
    std::uint32_t unsafe = 0;          ///< frames for which no start was free of tears
};

/// Times frames against the scan of the panel and against the wire.
///
/// Contract:
/// - It never sends pixels. measure() sends a list of waits; append_sync() appends waits to the list that is
///   filled, ahead of the first window.
/// - measure() succeeds without a result where no refresh is seen, or none that is plausible: the datasheet's
///   time stays.
/// - Where every start would tear, a frame starts in the blanking, or at once, and is counted as unsafe.
/// - A wait ends with Fault::timeout after two refreshes and `grace_us`.
class Pacer {
  public:
    /// The time that the scan-out is given to show itself, beyond two refreshes.
    static constexpr std::uint32_t grace_us = 100000;

    /// Makes a pacer of the frames that go out over `transfer`. The transfer must outlive the pacer.
    explicit Pacer(Transfer& transfer) : transfer_(transfer) {}

    /// Times a few refreshes, if frames are to be tear-free.
    Result<void> measure();
    /// The refresh as it is known; unknown where the panel's datasheet says nothing.
    Refresh refresh() const;
    /// Makes the transfer that is filled lead or lag the scan.
    void append_sync(const SafeStart& start);

    /// Whether presents wait for a busy wire where the display was set up so: the swap interval is not 0.
    void waits(bool so) { waits_ = so; }
    /// Whether a present is put off, because the wire is busy and it need not wait. It counts those.
    bool puts_off();

    /// What became of the frames so far.
    const PresentCounters& counters() const { return counters_; }
    /// Counts a frame that was sent.
    void count_sent() { ++counters_.sent; }

  private:
    const PanelConfig& config() const { return transfer_.layout().config; }

    Transfer& transfer_;
    std::int32_t line_ns_ = 0;   ///< time of a line of the scan; measured for tear-free displays only
    std::uint32_t moments_[2]{}; ///< the times between which measure() counts refreshes
    bool waits_ = true;
    PresentCounters counters_;
};

} // namespace spangle::hal
