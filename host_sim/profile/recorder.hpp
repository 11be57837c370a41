// Listens to one context and writes down what the program asks it for.
#pragma once

#include <map>
#include <utility>

#include "gl/context/watch.hpp"
#include "host_sim/profile/record.hpp"
#include "raster/span/draw_state.hpp"

#if SPANGLE_WATCHED

namespace spangle::profile {

/// One at a time: spans have no place to say who counts them.
class Recorder final : public gl::Watcher {
  public:
    /// The context is watched as long as this lives.
    explicit Recorder(gl::Context& context);
    ~Recorder();
    Recorder(const Recorder&) = delete;
    Recorder& operator=(const Recorder&) = delete;

    void command(gl::Context& context, const gl::CommandText& text, const gl::Arg* args,
                 unsigned count) override;
    void compiled(gl::Context& context, const raster::FragmentState& fragment,
                  raster::DrawState& state) override;

    /// All that was asked for up to now.
    const Record& finish();

  private:
    friend struct Spans;
    std::size_t place_of(const raster::Key& key);
    void inspect(gl::Context& context);
    void inspect_textures(gl::Context& context);
    void arguments(gl::Context& context, const gl::CommandText& text, const gl::Arg* args, unsigned count);
    void value(std::uint32_t word);

    gl::Context& context_;
    Record record_;
    std::uint32_t texture_changes_ = 0;
    bool textures_seen_ = false;
    /// What a state draws each kind with, and the key it counts for.
    struct Counted {
        raster::AnyFunction run;
        std::size_t key;
    };
    std::map<std::pair<const raster::DrawState*, int>, Counted> counted_;
};

} // namespace spangle::profile

#endif
