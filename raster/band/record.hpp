// A frame as a record: what would be drawn, in window space, kept until the bands of a surface ask for it.
#pragma once

#include <cstddef>
#include <cstdint>

#include "raster/primitive/draw.hpp"
#include "raster/primitive/keep.hpp"
#include "raster/surface/accum.hpp"
#include <spangle/raster/clear.hpp>

namespace spangle::raster {

class VertexCode;

/// Lies in memory that is handed over once. States are stored once per change, equal ones once; primitives
/// share their vertices. What does not fit is not kept: the record is full, and of no use, until it is
/// cleared.
class Record : public Recorder {
  public:
    Record();
    Record(const Record&) = delete;
    Record& operator=(const Record&) = delete;

    /// `bytes` at `memory`, aligned to 8.
    void give(void* memory, std::size_t bytes);
    /// Called once, by what does not fit.
    void (*on_full)() = nullptr;

    bool empty() const { return used_ == 0; }
    bool full() const { return full_; }
    std::size_t size() const { return size_; }
    std::size_t used() const { return used_; }
    std::size_t peak() const { return peak_; }
    void clear();

    /// Primitives of this state are kept from now on. Its textures' texels must stay until clear().
    void take(DrawState& live);
    void clear(const ClearRequest& request);
    void accum(const AccumRequest& request);
    /// Stencil values of columns [x, x + count) of row y, under a mask, of a sample.
    void stencil(std::int32_t y, std::int32_t x, std::int32_t count, const std::uint8_t* values,
                 std::uint8_t mask, std::uint8_t sample);

    /// Draws all that lies in the surface's rows. With `count`, the counters of primitives that were never
    /// counted count; counted() says that they were.
    void replay(const Surface& band, bool count);
    /// Something was recorded whose fragments somebody counts.
    bool counts() const { return counts_; }
    void counted();
    /// The counters of states end.
    void forget_counters();

  private:
    struct State;
    struct Block;
    struct Item;
    struct Polygon;
    struct Run;
    class PixelKeeper;
    enum class Content : std::uint8_t;

    /// Rows [first, end).
    struct Rows {
        std::int32_t first, end;
        bool empty() const { return first >= end; }
    };

    static void keep_primitive(Recorder& self, const DrawState& state, const Primitive& primitive);
    static void keep_pixels(Recorder& self, const DrawState& state, const FixedVertex& at,
                            PixelSource& source);

    template <class T> T* at(std::uint32_t place) const { return reinterpret_cast<T*>(memory_ + place); }
    bool room(std::size_t bytes);
    std::uint32_t append(std::size_t bytes);
    State* stored(const DrawState& live);
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

    static constexpr int live_states = 2; ///< front and back faces
    static constexpr unsigned log2_vertices = 7;
    static constexpr std::uint32_t nowhere = 0xFFFFFFFF;

    std::uint8_t* memory_ = nullptr;
    std::size_t size_ = 0, used_ = 0, peak_ = 0;
    std::uint32_t block_ = nowhere;  ///< the last one, which may go on
    std::uint32_t states_ = nowhere; ///< the last one of their list
    std::uint32_t texture_ = nowhere;
    std::size_t counted_ = 0; ///< what lies before was counted
    bool full_ = false, counts_ = false;
    struct Live {
        const DrawState* state = nullptr;
        std::uint32_t stored = nowhere;
    } live_[live_states];
    unsigned next_live_ = 0;
    std::uint32_t vertex_[1u << log2_vertices];
    PrimitiveState primitive_; ///< of the one that is drawn
    Counters uncounted_;
};

} // namespace spangle::raster
