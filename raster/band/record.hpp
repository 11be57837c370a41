// A frame as a record of its primitives in window space, kept until the bands of a surface are drawn.
#pragma once

#include <cstddef>
#include <cstdint>

#include "raster/primitive/draw.hpp"
#include "raster/primitive/keep.hpp"
#include "raster/surface/accum.hpp"
#include <spangle/raster/clear.hpp>

namespace spangle::raster {

class VertexCode;

/// The record lies in memory that is given once. A state is stored once per change, and equal states are
/// stored once. Primitives share their vertices. A primitive that does not fit is not stored. The record is
/// then full, and of no use until it is cleared.
class Record : public Recorder {
  public:
    Record();
    Record(const Record&) = delete;
    Record& operator=(const Record&) = delete;

    /// Takes `bytes` bytes of memory at `memory`, which is aligned to 8.
    void give(void* memory, std::size_t bytes);
    /// Called once in a frame, when a primitive does not fit into the record's memory.
    void (*on_full)() = nullptr;

    bool empty() const { return used_ == 0; }
    bool full() const { return is_full_; }
    std::size_t size() const { return size_; }
    std::size_t used() const { return used_; }
    std::size_t peak() const { return peak_; }
    void clear();

    /// Records primitives of this state from now on. The texels of its textures must stay until clear().
    void take(DrawState& live);
    void clear(const ClearRequest& request);
    void accum(const AccumRequest& request);
    /// Records stencil values for columns [x, x + count) of row y, for one sample. Only the bits of `mask`
    /// are written.
    void stencil(std::int32_t y, std::int32_t x, std::int32_t count, const std::uint8_t* values,
                 std::uint8_t mask, std::uint8_t sample);

    /// Draws the part of the record in the surface's rows. With `count`, primitives that have not been
    /// counted yet update the counters of their states. mark_counted() marks them as counted.
    void replay(const Surface& band, bool count);
    /// Whether the record holds primitives that are to be counted and have not been counted.
    bool has_uncounted() const { return has_uncounted_; }
    void mark_counted();
    /// Must be called before the counters end to which recorded states point.
    void forget_counters();

  private:
    struct State;
    struct Block;
    struct Item;
    struct Polygon;
    struct Run;
    class PixelRecorder;
    enum class Content : std::uint8_t;

    /// A range of rows, [first, end).
    struct Rows {
        std::int32_t first, end;
        bool empty() const { return first >= end; }
    };

    static void record_primitive(Recorder& self, const DrawState& state, const Primitive& primitive);
    static void record_pixels(Recorder& self, const DrawState& state, const FixedVertex& at,
                              PixelSource& source);

    template <class T> T* at(std::uint32_t place) const { return reinterpret_cast<T*>(memory_ + place); }
    bool room(std::size_t bytes);
    std::uint32_t append(std::size_t bytes);
    State* find_or_store(const DrawState& live);
    State* store(const DrawState& live);
    State* equal_to(const State& state) const;
    bool store_textures(DrawState& draw);
    const Texture* store_texture(const Texture& texture);
    template <class T> const T* store_bytes(const T& value);
    Block* open(Content content, std::uint32_t state, Rows rows, std::size_t bytes);
    void add(const DrawState& live, const Primitive& primitive);
    void add_polygon(const DrawState& live, const Primitive& polygon, std::uint32_t state, Rows rows);
    std::uint32_t find_vertex(const std::uint32_t* words, int count) const;
    void remember_vertex(const std::uint32_t* words, int count, std::uint32_t place);

    void replay_block(Block& block, const Surface& band, bool count);
    void replay_primitives(Block& block, DrawState& draw, const Surface& band);
    void replay_polygon(Block& block, DrawState& draw, const Surface& band);
    void replay_pixels(Block& block, DrawState& draw, const Surface& band);
    template <class Draw> void each_target(const Surface& band, std::uint8_t only, Draw draw);
    void draw_item(const DrawState& draw, const Surface& target, const Item& item, const FixedVertex* corner,
                   std::int32_t extent, LineStipple stipple);
    void prepare(const Surface& band);

    static constexpr int live_states = 2; ///< states of front and back faces
    static constexpr unsigned log2_vertices = 7;
    static constexpr std::uint32_t nowhere = 0xFFFFFFFF;

    std::uint8_t* memory_ = nullptr;
    std::size_t size_ = 0, used_ = 0, peak_ = 0;
    std::uint32_t block_ = nowhere; ///< the last block, which may take more items; `nowhere` if there is none
    std::uint32_t states_ = nowhere; ///< head of the list of states
    std::uint32_t texture_ = nowhere;
    std::size_t counted_bytes_ = 0; ///< bytes of the record whose primitives have been counted
    bool is_full_ = false, has_uncounted_ = false;
    struct LiveState {
        const DrawState* state = nullptr;
        std::uint32_t stored = nowhere;
    } live_states_[live_states];
    unsigned next_live_state_ = 0;
    std::uint32_t vertex_[1u << log2_vertices];
    PrimitiveState primitive_; ///< state of the primitive that is being drawn
    Counters discarded_counters_;
};

} // namespace spangle::raster
