// A display as GL's window system sees it: a buffer to draw into, and a present that carries what changed.
#pragma once

#include <cstdint>

#include <spangle/format.hpp>
#include <spangle/hal/palette.hpp>
#include <spangle/hal/result.hpp>
#include <spangle/hal/wire.hpp>

namespace spangle::hal {

/// What a present does while the frame before is still on the [wire](docs/glossary.md#wire).
/// - `block` waits.
/// - `drop` does not send the frame; the next one presented in time carries its changes, too.
/// - `coalesce` does the same, but still sends the frame, at the latest in finish(), unless another is drawn
///   over it first.
enum class Pacing : std::uint8_t { block, drop, coalesce };

/// What a display is. It stays the same after init(), except where a WindowSystem says otherwise.
struct DisplayInfo {
    /// The name that people read, in static memory.
    const char* name = "";
    /// The size of the picture in pixels.
    std::int32_t width = 0, height = 0;
    /// The format of the buffers to draw into.
    PixelFormat format = PixelFormat::rgb565_be;
    bool keeps_buffer = false; ///< acquire() always gives the same buffer, with what was drawn before
    WireFormat wire = WireFormat::none; ///< what a present converts pixels to; none: they travel as they are
    /// Rows that a buffer holds: frames are acquired and presented [band](docs/glossary.md#band) by band; 0:
    /// whole.
    std::int32_t band_height = 0;
    std::int32_t band_unit = 1; ///< bands begin and end at multiples of so many rows, or with the picture
};

/// The buffer of the frame being drawn, top row first, in the display's pixel format.
struct Frame {
    /// The first byte of the top row. The memory stays the display's, and may be written until the next
    /// present().
    std::uint8_t* pixels = nullptr;
    std::int32_t stride = 0; ///< bytes from one row to the next one down
    std::int32_t age = 0; ///< 0: undefined; n: the buffer has the frame before n frames (EGL_EXT_buffer_age)
    RowExtents* extents = nullptr; ///< what the rasterizer touches this frame
};

/// Where frames go. EGL draws to one; programs without GL may call it themselves, from one thread. The order
/// of a frame is acquire(), drawing, present(). Errors are values; those of the bus pass through unchanged.
class Display {
  public:
    /// What this display is; it may be asked before init(), too.
    virtual DisplayInfo info() const = 0;
    /// Resets and initialises the controller. Must succeed before the others are called. It may be called
    /// again after a fault. Fault::bad_argument and Fault::unsupported: the description breaks a rule, or the
    /// bus cannot do what it asks for. Fault::wrong_device: another controller answers. Fault::no_answer:
    /// none does.
    virtual Result<void> init() = 0;
    /// The buffer to draw the next frame into; the same until present() succeeds. Fault::busy: none is free
    /// yet. Fault::bad_argument: init() did not succeed. Fault::unsupported: frames are drawn in bands.
    virtual Result<Frame> acquire() = 0;
    /// Sends what differs between the panel's memory and the surface. On an error nothing is forgotten: the
    /// next present sends it again. Errors are those of the bus, and those of acquire().
    virtual Result<void> present() = 0;
    /// Waits until the last frame presented is shown; what was drawn since stays where it is. Errors are
    /// those of the bus.
    virtual Result<void> finish() { return {}; }
    /// Sets new colours, red, green and blue bytes each, of the indices from `first` on, on displays of
    /// PixelFormat::index8. Arguments: first, count, and 3 * count bytes, which are copied.
    /// Fault::unsupported: the display has no palette. Fault::bad_argument: indices outside 0 to 255; no
    /// colour was set.
    virtual Result<void> set_palette(std::int32_t, std::int32_t, const std::uint8_t*) {
        return Error{Fault::unsupported, "display: it has no palette"};
    }
    /// Sets the swap interval. 0: presents do not wait (EGL 1.4, 3.9.3). 1: presents wait as the display was
    /// set up to.
    virtual void swap_interval(std::int32_t) {}

    /// Replaces acquire() where info().band_height is not 0. It returns the black buffer of rows [first,
    /// first + rows) of a frame, whose pixels and extents begin with row `first`. Frames begin with row 0 and
    /// go on downwards.
    virtual Result<Frame> acquire_band(std::int32_t, std::int32_t) { return whole_frames(); }
    /// Replaces present(): sends what differs between the panel's memory and the band that was acquired.
    virtual Result<void> present_band() { return whole_frames(); }

  protected:
    ~Display() = default;
    /// The error of a display that has no bands.
    static Error whole_frames() { return {Fault::unsupported, "display: frames of this display are whole"}; }
};

} // namespace spangle::hal
