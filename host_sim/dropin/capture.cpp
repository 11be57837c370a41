#include "host_sim/dropin/capture.hpp"

#include <cstdio>
#include <cstdlib>

#include "gl/context/context.hpp"
#include "gl/pixel/fragment_setup.hpp"
#include "host_sim/capture/thread_time.hpp"
#include "host_sim/dropin/options.hpp"

namespace spangle::dropin {

namespace {

constexpr int bad_end = 1;

void check(const std::string& problem) {
    if (problem.empty())
        return;
    std::fprintf(stderr, "spangle: %s\n", problem.c_str());
    std::_Exit(bad_end);
}

bool asked = false;
Capture* the_capture = nullptr; // never freed: it lives as long as the program may draw

} // namespace

Capture* Capture::get() {
    if (!asked && !options().capture.empty())
        the_capture = new Capture;
    asked = true;
    return the_capture;
}

void Capture::finish_if_any() {
    if (the_capture != nullptr)
        the_capture->finish();
}

Capture::Capture() {
    check(file_.open(options().capture));
    if (!options().times_only)
        counters_.observer = &frames_;
    frame_begin_us_ = trade::thread_microseconds();
}

void Capture::watch(gl::Context& context) {
    context.fragment_ops.dither = options().dither;
    if (stages_ == nullptr && options().precision > EGL_PRECISION_DOUBLE_SPANGLE)
        stages_ = std::make_unique<StageReport>();
    gl::observe(context, &counters_, false);
}

void Capture::take(const raster::Surface& picture) {
    const double time = trade::thread_microseconds() - frame_begin_us_;
    if (is_finished_ || counters_.fragments == 0)
        return;
    counters_.fragments = 0;
    file_.add(options().times_only ? trade::DrawnFrame{} : frames_.take(picture), time);
    if (++frame_count_ == static_cast<std::uint64_t>(options().frames)) {
        finish();
        std::_Exit(0);
    }
    frame_begin_us_ = trade::thread_microseconds();
}

void Capture::finish() {
    if (is_finished_)
        return;
    is_finished_ = true;
    trade::CaptureEnd end;
    end.frames = frame_count_;
    end.mismatches = frames_.mismatches();
    end.missed = has_missing_function_ ? "a function of OpenGL 2.0 or later" : "";
    if (stages_ != nullptr)
        end.stages = stages_->stages();
    check(file_.finish(end));
}

} // namespace spangle::dropin
