#include "host_sim/cli/report.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace spangle::cli {

std::string to_json(const Report& r) {
    nlohmann::ordered_json out = {
        {"scene", r.scene},
        {"board", r.board},
        {"precision", r.precision},
        {"frames", r.frames},
        {"fragments", r.fragments},
        {"triangles", r.triangles},
        {"identical_565_percent", nullptr},
        {"max_lsb", nullptr},
        {"psnr_565_db", nullptr},
        {"coverage_mismatches", nullptr},
        {"coverage_unsnapped", nullptr},
        {"bus_bytes", r.bus_bytes},
        {"bus_commands", r.bus_commands},
        {"bus_pixel_bytes", r.bus_pixel_bytes},
        {"full_frame_bytes", r.full_frame_bytes},
        {"fps_at_bus_clock", r.fps_at_bus_clock},
        {"picture_hash", r.picture_hash},
    };
    if (r.compared) {
        out["identical_565_percent"] = r.identical_565_percent;
        out["max_lsb"] = r.max_lsb;
        out["psnr_565_db"] = r.psnr_565_db;
        out["coverage_mismatches"] = r.coverage_mismatches;
        out["coverage_unsnapped"] = r.coverage_unsnapped;
        out["coverage_snapping"] = r.coverage_snapping;
    }
    if (r.measured_fps)
        out["measured_fps"] = *r.measured_fps;
    if (r.presents)
        out["presents"] = {{"sent", r.presents->sent},     {"put_off", r.presents->put_off},
                           {"led", r.presents->led},       {"lagged", r.presents->lagged},
                           {"unsafe", r.presents->unsafe}, {"fps", r.virtual_fps}};
    if (r.memory)
        out["memory"] = {{"context", r.memory->context},
                         {"surface", r.memory->surface},
                         {"peak", r.memory->peak},
                         {"process", r.memory->process}};
    if (r.bands)
        out["bands"] = {
            {"buffers", r.bands->buffers}, {"planes", r.bands->planes}, {"record", r.bands->record}};
    for (const StageError& s : r.stages)
        out["stages"].push_back({{"stage", s.stage},
                                 {"unit", s.unit},
                                 {"count", s.count},
                                 {"max", s.max},
                                 {"rms", s.rms},
                                 {"least", s.least},
                                 {"greatest", s.greatest},
                                 {"saturated", s.saturated}});
    return out.dump(2) + "\n";
}

std::string to_table(const Report& r) {
    const auto per_frame = [&r](std::uint64_t n) {
        return static_cast<double>(n) / (r.frames > 0 ? r.frames : 1);
    };
    std::string out = fmt::format("{} on {}, {} precision, {} frame{}, picture {}\n", r.scene, r.board,
                                  r.precision, r.frames, r.frames == 1 ? "" : "s", r.picture_hash);
    out += fmt::format("  per frame   {:>10.0f} triangles  {:>10.0f} fragments\n", per_frame(r.triangles),
                       per_frame(r.fragments));
    if (r.bus_bytes > 0)
        out += fmt::format(
            "  bus         {:>10.0f} bytes      {:>10.1f} commands   {:.0f} % of a full frame{}\n",
            per_frame(r.bus_bytes), per_frame(r.bus_commands),
            100.0 * per_frame(r.bus_pixel_bytes) / static_cast<double>(r.full_frame_bytes),
            r.measured_fps ? "" : fmt::format("   {:.1f} fps at the bus clock", r.fps_at_bus_clock));
    if (r.measured_fps)
        out += fmt::format("  display     {:>10.1f} frames a second, measured\n", *r.measured_fps);
    if (r.presents)
        out += fmt::format("  presents    {:>10} sent, {} put off; {} led the beam, {} lagged behind it, {} "
                           "could not but tear; {:.1f} fps\n",
                           r.presents->sent, r.presents->put_off, r.presents->led, r.presents->lagged,
                           r.presents->unsafe, r.virtual_fps);
    if (r.compared)
        out += fmt::format(
            "  error       {:>10.4f} % of {} covered pixels identical in RGB565, worst channel {} steps, "
            "PSNR {:.1f} dB\n"
            "  coverage    {:>10} pixels off brute force on snapped vertices, {} off unsnapped ones ({} by "
            "ideal snapping alone)\n",
            r.identical_565_percent, r.covered, r.max_lsb, r.psnr_565_db, r.coverage_mismatches,
            r.coverage_unsnapped, r.coverage_snapping);
    if (r.memory)
        out += fmt::format(
            "  memory      {:>10} bytes of context, {} of surface, {} at most in all{}; process {:.1f} MB\n",
            r.memory->context, r.memory->surface, r.memory->peak, r.compared ? " (the reference's, too)" : "",
            static_cast<double>(r.memory->process) * 1e-6);
    if (r.bands)
        out += fmt::format("  bands       {:>10} bytes of display buffers, {} of depth, {} of record\n",
                           r.bands->buffers, r.bands->planes, r.bands->record);
    if (!r.stages.empty())
        out += fmt::format("  {:<13} {:>10} {:>11} {:>11}  {:<12} {:>10}   {}\n", "integers", "values",
                           "max error", "rms error", "unit", "saturated", "range");
    for (const StageError& s : r.stages)
        out += fmt::format("  {:<13} {:>10} {:>11.2e} {:>11.2e}  {:<12} {:>10}   {:.6g} .. {:.6g}\n", s.stage,
                           s.count, s.max, s.rms, s.unit, s.saturated, s.least, s.greatest);
    return out;
}

} // namespace spangle::cli
