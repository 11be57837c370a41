// Listens to contexts, and records what the program asks them for.
#pragma once

#include <map>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

#include "gl/context/watch.hpp"
#include "host_sim/profile/record.hpp"
#include "raster/span/draw_state.hpp"

#if SPANGLE_WATCHED

namespace spangle::profile {

/// Records contexts, which may be current to several threads. There is one recorder at a time, because spans
/// have no place to say who counts them.
class Recorder final : public gl::Watcher {
  public:
    /// Records keys and formats of the surfaces that the program draws to.
    Recorder();
    /// Records keys and formats as if the surfaces had these colours, and depths of 16 bits, or 24 where the
    /// program asks for stencils. Programs for PCs take the largest formats that a machine offers.
    explicit Recorder(PixelFormat colors);
    /// Records one context while this object lives.
    explicit Recorder(gl::Context& context);
    ~Recorder();
    /// Records another context until its end.
    void add(gl::Context& context);
    Recorder(const Recorder&) = delete;
    Recorder& operator=(const Recorder&) = delete;

    void command(gl::Context& context, const gl::CommandText& text, const gl::Arg* args,
                 unsigned count) override;
    void compiled(gl::Context& context, const raster::FragmentState& fragment,
                  raster::DrawState& state) override;

    void reached(gl::Range range, std::uint32_t value) override;

    /// Ends the record of everything that was asked for up to now.
    const Record& finish();

  private:
    friend struct Spans;
    std::size_t place_of(const raster::Key& key);
    void keep_one_color(const raster::FragmentState& fragment, const raster::Surface& surface,
                        const raster::DrawState& state);
    void note_state(gl::Context& context);
    void inspect_textures(gl::Context& context);
    void note_arguments(gl::Context& context, const gl::CommandText& text, const gl::Arg* args,
                        unsigned count);
    void value(std::uint32_t word);
    void note_switch(std::uint32_t word);
    /// Counts pixels for the key of a variant. Returns the function that draws them.
    raster::AnyFunction count(const std::pair<const raster::DrawState*, int>& variant, std::uint64_t pixels);

    raster::Surface target(const gl::Context& context) const;

    gl::Context* context_ = nullptr; ///< a context that outlives this object
    std::optional<PixelFormat> color_format_;
    bool has_stencil_ = false;
    std::mutex mutex_;
    Record record_;
    /// The number of changes of textures that were looked at, by address of the share group.
    std::map<const void*, std::uint32_t> texture_ids_;
    /// The function that draws a kind in a state, and the index of the key for which it counts.
    struct CountedFunction {
        raster::AnyFunction run;
        std::size_t key;
    };
    std::map<std::pair<const raster::DrawState*, int>, CountedFunction> counted_states_;
};

} // namespace spangle::profile

#endif
