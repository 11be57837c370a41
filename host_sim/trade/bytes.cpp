#include "host_sim/trade/bytes.hpp"

#include <fmt/format.h>

#include <spangle/GL/gl.h>

#include "host_sim/trade/offscreen.hpp"
#include "host_sim/trade/recording.hpp"

namespace spangle::trade {

namespace {

/// The hash FNV-1a of 64 bits.
struct Hash {
    std::uint64_t value = 0xCBF29CE484222325;

    void add(std::uint8_t byte) { value = (value ^ byte) * 0x100000001B3; }
    void add(const DrawnPicture& picture) {
        for (const std::uint8_t byte : picture.rgba)
            add(byte);
        for (const std::uint32_t depth : picture.depth)
            for (int bit = 0; bit < 32; bit += 8)
                add(static_cast<std::uint8_t>(depth >> bit));
    }
};

std::string hash_recording(Recording& from, const Tier& tier, const Format& format, const Setting& s,
                           Hash& hash) {
    CaptureReader frames;
    std::string problem = from.capture(format.format, tier.precision, s, frames);
    DrawnFrame frame;
    double time = 0;
    int count = 0;
    while (problem.empty() && frames.next(frame, time) && count++ < s.frames)
        hash.add(frame.picture);
    return problem.empty() && count != s.frames ? "the replay ended early" : problem;
}

} // namespace

std::string hash_frames(const Program& program, const Tier& tier, const Format& format,
                        const Setting& setting, std::uint64_t& out) {
    Hash hash;
    std::string problem;
    if (program.recording != nullptr) {
        Setting own = setting;
        problem = program.recording->settle(own);
        if (problem.empty())
            problem = hash_recording(*program.recording, tier, format, own, hash);
    } else {
        Offscreen screen;
        problem = screen.open(program, setting.width, setting.height, format.format, tier.precision,
                              setting.dither, own_knobs(tier));
        for (int f = 0; f < setting.frames && problem.empty(); ++f) {
            program.draw(f);
            hash.add(read_picture());
            if (const GLenum error = glGetError(); error != GL_NO_ERROR)
                problem = fmt::format("it raised GL error 0x{:04X}", error);
        }
    }
    out = hash.value;
    return problem.empty() ? "" : program.name + ": " + problem;
}

} // namespace spangle::trade
