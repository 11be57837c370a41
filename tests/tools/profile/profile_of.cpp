// Records a program or a scene in one tier. Writes its profile, and prints a hash of each frame, drawn
// without the recorder.
#include <cstdio>
#include <cstring>
#include <fstream>
#include <memory>

#include <spangle/message.hpp>

#include "gl/context/context.hpp"
#include "host_sim/profile/emit.hpp"
#include "host_sim/profile/recorder.hpp"
#include "tests/tools/bench/headless.hpp"
#include "tests/tools/bench/picture_hash.hpp"
#include "tests/tools/profile/find_program.hpp"

namespace {

using namespace spangle;

constexpr int width = 320, height = 240, first_frame = 2, end_frame = 5;

/// Returns false after an error, and prints it.
bool draw(const programs::Program& program, EGLint precision, profile::Record* record) {
    bench::Headless gl;
    if (!gl.open(width, height, precision))
        return false;
    const auto recorder =
        record != nullptr ? std::make_unique<profile::Recorder>(*gl::current_context()) : nullptr;
    program.setup(width, height);
    program.draw(1);
    for (int frame = first_frame; frame < end_frame; ++frame) {
        program.draw(frame);
        if (record == nullptr)
            std::printf("frame %08X\n", bench::picture_hash(width, height));
    }
    if (record != nullptr)
        *record = recorder->finish();
    return glGetError() == GL_NO_ERROR;
}

} // namespace

int main(int count, char** words) {
    if (count == 2 && std::strcmp(words[1], "--list") == 0) {
        for (const programs::Program* program : programs::all)
            std::printf("%s\n", program->name);
        return 0;
    }
    const programs::Program program = count >= 4 ? programs::find(words[1]) : programs::Program{};
    if (program.name == nullptr) {
        std::puts("usage: profile_of PROGRAM exact|balanced|fast PROFILE.cmake [small]");
        return 2;
    }
    on_message([](unsigned, const char* text) { std::fprintf(stderr, "%s\n", text); });
    const EGLint precision = std::strcmp(words[2], "exact") == 0      ? EGL_PRECISION_EXACT_SPANGLE
                             : std::strcmp(words[2], "balanced") == 0 ? EGL_PRECISION_BALANCED_SPANGLE
                                                                      : EGL_PRECISION_FAST_SPANGLE;
    profile::Record record;
    if (!draw(program, precision, &record) || !draw(program, precision, nullptr))
        return 1;
    std::string settings = words[3], list = settings.substr(0, settings.rfind('.')) + ".inc";
    const profile::Choice choice{program.name, list.substr(list.rfind('/') + 1), count > 4};
    const profile::Profile made = profile::make(record, choice);
    std::ofstream(settings) << profile::settings(made, record, choice);
    std::ofstream(list) << profile::fused_lines(made);
    std::printf("chain %d\n", made.chain ? 1 : 0);
    for (const profile::KeyUse& use : record.keys)
        std::printf("key %llu %s\n", static_cast<unsigned long long>(use.pixels),
                    profile::words(use.key).c_str());
    return 0;
}
