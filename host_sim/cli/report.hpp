// The figures of a run, over all its frames.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <spangle/hal/panel_display.hpp>

namespace spangle::cli {

/// The error of one stage of the pipeline in integers, compared with its double twin
/// (raster/reference/shadow.hpp).
struct StageError {
    std::string stage, unit;
    std::uint64_t count;     ///< number of values compared
    double max, rms;         ///< largest and root-mean-square |fixed - double|, in `unit`
    double least, greatest;  ///< range of the values in double
    std::uint64_t saturated; ///< number of fixed values at a limit of their range
};

/// Memory in bytes. The first three lie in the memory of spangle::memory; a window's colour buffer belongs to
/// the display.
struct Memory {
    std::size_t context, surface;
    /// The most that Spangle took for context, surface, textures and lists; with --compare also for the
    /// reference.
    std::size_t peak;
    std::size_t process; ///< the program with its simulator; 0 where it is not known
};

/// Bytes of a window that is drawn in bands.
struct BandMemory {
    std::size_t buffers; ///< bytes of the display's buffers: for pixels as drawn, and as sent
    std::size_t planes;  ///< depth planes, without the record of commands
    std::size_t record;  ///< record of commands of the longest frame
};

struct Report {
    std::string scene, board, precision;
    int frames = 0;
    std::uint64_t fragments = 0, triangles = 0;
    double identical_565_percent = 100.0;  ///< percent of covered pixels, against the double reference
    int max_lsb = 0;                       ///< largest difference of a colour channel, in steps of RGB565
    double psnr_565_db = 99.0;             ///< dB; 99 when identical
    std::uint64_t coverage_mismatches = 0; ///< pixels, against brute force on the tier's own snapped vertices
    std::uint64_t coverage_unsnapped = 0;  ///< pixels, against unsnapped vertices in double
    std::uint64_t coverage_snapping = 0;   ///< pixels, against vertices in double, ideally snapped to n.8
    std::uint64_t covered = 0;             ///< pixel samples that the coverage was compared in
    bool compared = false; ///< with --compare: the figures from identical_565_percent on are measured
    std::uint64_t bus_bytes = 0, bus_commands = 0;
    std::uint64_t bus_pixel_bytes = 0;            ///< bytes of bus_bytes that belong to no command
    std::uint64_t full_frame_bytes = 0;           ///< bytes of one whole frame on the bus, without commands
    double fps_at_bus_clock = 0.0;                ///< frames a second; 0 without a board
    double virtual_fps = 0.0;                     ///< frames a second of drawing and sending, in virtual time
    std::optional<double> measured_fps;           ///< frames a second of a real display, drawing included
    std::optional<hal::PresentCounters> presents; ///< set when the command line said how to present
    std::string picture_hash;                     ///< hash of the last frame's picture
    std::optional<Memory> memory;                 ///< set with the option --stats
    std::optional<BandMemory> bands;              ///< set with the option --band-height
    std::vector<StageError> stages;               ///< errors of stages, of a run in shadow precision
};

/// One JSON object, whose keys are named as the fields.
std::string to_json(const Report& report);

/// The report as a table for people.
std::string to_table(const Report& report);

} // namespace spangle::cli
