#include "host_sim/boards/player.hpp"

#include "gl/context/context.hpp"
#include "gl/pixel/fragment_setup.hpp"

namespace spangle::sim {

namespace {

class Observer final : public demo::Watcher {
  public:
    Observer(const scenes::Scene& scene, const std::function<void(const PlayedFrame&)>& presented)
        : scene_(scene), on_present_(presented) {}

    void begin_frame() override {
        hash_ = {};
        counters_ = {};
        gl::observe(*gl::current_context(), &counters_, false);
    }
    void drawn(const demo::Rows& rows) override { hash_.add(rows); }
    void presented() override { on_present_({scene_, frame_++, hash_.value(), counters_.fragments}); }

  private:
    const scenes::Scene& scene_;
    const std::function<void(const PlayedFrame&)>& on_present_;
    raster::Counters counters_;
    demo::PictureHash hash_;
    int frame_ = 0;
};

} // namespace

std::string play(Desk& desk, const std::vector<std::string>& ids, int frames,
                 const std::function<void(const PlayedFrame&)>& presented) {
    for (const std::string& id : ids) {
        const scenes::Scene* const scene = scenes::find(id.c_str());
        if (scene == nullptr)
            return "no scene '" + id + "'";
        Observer observer(*scene, presented);
        if (const char* const problem = demo::play(desk.display(), *scene, frames, observer))
            return id + ": " + problem + " failed";
    }
    return desk.violations();
}

} // namespace spangle::sim
