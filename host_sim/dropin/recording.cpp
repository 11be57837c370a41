#include "host_sim/dropin/recording.hpp"

#include "gl/context/context.hpp"
#include "host_sim/dropin/options.hpp"
#include "host_sim/output/output.hpp"
#include "host_sim/profile/record_text.hpp"
#include "host_sim/profile/recorder.hpp"

namespace spangle::dropin {

#if SPANGLE_WATCHED

namespace {

/// The program's recorder, which is never freed: it lives as long as the program may draw.
profile::Recorder& recorder() {
    static profile::Recorder* const made =
        options().record_format ? new profile::Recorder(*options().record_format) : new profile::Recorder;
    return *made;
}

} // namespace

void record(gl::Context& context) {
    if (!options().record.empty())
        recorder().add(context);
}

std::string write_recording() {
    if (options().record.empty())
        return "";
    return sim::write_file(options().record, profile::to_text(recorder().finish()));
}

#else

void record(gl::Context&) {}

std::string write_recording() {
    return options().record.empty() ? ""
                                    : "this build does not record: it leaves out messages or display lists";
}

#endif

} // namespace spangle::dropin
