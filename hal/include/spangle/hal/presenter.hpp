// Sends rows of a buffer: in which windows, as which pixels, and from which moment on.
#pragma once

#include <cstddef>
#include <cstdint>

#include <spangle/hal/bus_buffer.hpp>
#include <spangle/hal/pacer.hpp>
#include <spangle/hal/panel_config.hpp>
#include <spangle/hal/panel_memory.hpp>
#include <spangle/hal/row_hash.hpp>
#include <spangle/hal/transfer.hpp>

namespace spangle::hal {

class FramePlan;

/// Rows of a buffer that are sent.
struct SentRows {
    /// The buffer, whose top row is the picture's row `first`. It is lent to the transfer.
    BusBuffer* buffer = nullptr;
    /// The first row, and the number of rows.
    std::int32_t first = 0, count = 0;
};

/// Plans the windows of the [damage](docs/glossary.md#damage) and puts its pixels on the
/// [wire](docs/glossary.md#wire).
///
/// Contract:
/// - send() sends the damage and nothing else, in the windows that cost least on this bus; send_all() sends
///   every pixel of the rows. Both return while the last list is on the wire: Transfer tells when it ends.
/// - Nothing is on the wire when they are called. With empty damage nothing goes out.
/// - Damage ends where bytes do; see DamageBook::widen().
/// - Frames that must be one list are made of so few windows that one list holds them.
/// - Pixels of another format on the wire are converted into memory of its own; then that memory is lent to
///   the transfer, and the buffer may be drawn into at once.
class Presenter {
  public:
    /// Functions that not every display calls. Those that no display names are not linked.
    struct Parts {
        /// Delays a transfer so that it leads or lags the beam.
        void (*sync)(Presenter&, FramePlan&) = nullptr;
        /// Counts the operations of a plan, for frames that are one list.
        std::size_t (*count_ops)(const Presenter&, FramePlan&) = nullptr;
    };
    /// The parts of a presenter. `waits_for_beam`: the display's frames wait for the beam. `is_one_list`:
    /// each frame must be one list.
    static constexpr Parts parts(bool waits_for_beam, bool is_one_list);

    /// All arguments must outlive the presenter. Of `memory` it uses the plan, the palette and the code of
    /// hashes.
    Presenter(const PanelMemory& memory, Transfer& transfer, Pacer& pacer)
        : memory_(memory), transfer_(transfer), pacer_(pacer) {}
    /// Acquires the memory of converted pixels from the bus, if the description asks for it, once.
    Result<void> acquire_wire();

    /// Sends the damage, which is one span of columns for each row. Where `hash` is enabled, only the cells
    /// in it that changed are sent. `parts` are the parts of the presenter that this display links.
    Result<void> send(const SentRows& rows, const RowSpan* damage, const RowHash& hash, const Parts& parts);
    /// Sends every pixel of the rows.
    Result<void> send_all(const SentRows& rows);

  private:
    Result<void> send_windows(FramePlan& plan, const Parts& parts);
    Result<void> append_windows(const Rect& area);
    Result<void> append_window(const Rect& window);
    std::size_t convert(const Rect& window);
    std::size_t pixel_ops(const Rect& window) const;
    std::size_t ops_of(FramePlan& plan) const;
    SafeStart safe_start(FramePlan& plan) const;
    template <class Visit> void rehearse(FramePlan& plan, Visit visit) const;
    void append_sync(FramePlan& plan);
    void begin(const SentRows& rows);
    Result<void> end();

    const PanelLayout& layout() const { return transfer_.layout(); }

    const PanelMemory& memory_;
    Transfer& transfer_;
    Pacer& pacer_;
    BusBuffer* buffer_ = nullptr; ///< the buffer whose pixels are sent
    std::int32_t first_ = 0;      ///< the row of the picture that is the buffer's top row
    BusBuffer wire_;              ///< memory of pixels converted to another format
    std::size_t wire_end_ = 0;    ///< bytes of wire_ that the list under way uses
};

constexpr Presenter::Parts Presenter::parts(bool waits_for_beam, bool is_one_list) {
    Parts parts;
    if (waits_for_beam)
        parts.sync = [](Presenter& presenter, FramePlan& plan) { presenter.append_sync(plan); };
    if (is_one_list)
        parts.count_ops = [](const Presenter& presenter, FramePlan& plan) { return presenter.ops_of(plan); };
    return parts;
}

} // namespace spangle::hal
