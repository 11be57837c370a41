#include "host_sim/capture/capture_file.hpp"

#include <algorithm>
#include <cstring>
#include <string_view>
#include <type_traits>

#include "raster/reference/shadow.hpp"

namespace spangle::trade {

namespace {

constexpr std::string_view magic = "spangle capture 1\n";
constexpr std::int32_t is_frame = 1, is_end = 2;
constexpr std::int32_t longest_side = 1 << 15;
constexpr std::uint64_t most_stages = 64, longest_name = 256;

template <class Value> void put(std::string& out, const Value& value) {
    static_assert(std::is_trivially_copyable_v<Value>);
    out.append(reinterpret_cast<const char*>(&value), sizeof value);
}

template <class Value> bool get(std::istream& in, Value& value) {
    static_assert(std::is_trivially_copyable_v<Value>);
    return static_cast<bool>(in.read(reinterpret_cast<char*>(&value), sizeof value));
}

/// The flags of a pixel in the file.
enum Flag : std::uint8_t { snapped = 1, exact = 2, drawn = 4 };

/// Finds the stage that was written by its name. Returns false where no stage has the name.
bool name_stage(std::string_view name, StageError& out) {
    for (int i = 0; i < raster::shadow_stages; ++i) {
        const auto stage = static_cast<raster::ShadowStage>(i);
        if (name == raster::name_of(stage)) {
            out.stage = raster::name_of(stage);
            out.unit = raster::unit_of(stage);
            return true;
        }
    }
    return false;
}

void put_text(std::string& out, std::string_view text) {
    put(out, static_cast<std::uint64_t>(text.size()));
    out += text;
}

bool get_text(std::istream& in, std::string& text) {
    std::uint64_t length = 0;
    if (!get(in, length) || length > longest_name)
        return false;
    text.resize(length);
    return static_cast<bool>(in.read(text.data(), static_cast<std::streamsize>(length)));
}

} // namespace

void coarsen(DrawnPicture& picture) {
    constexpr int coarse = 16;
    for (std::uint32_t& code : picture.depth)
        code >>= picture.depth_bits > coarse ? picture.depth_bits - coarse : 0;
    picture.depth_bits = std::min(picture.depth_bits, coarse);
}

std::vector<bool> upside_down(const std::vector<bool>& mask, int width) {
    std::vector<bool> out;
    out.reserve(mask.size());
    for (std::size_t row = mask.size(); row != 0; row -= static_cast<std::size_t>(width))
        for (std::size_t x = row - static_cast<std::size_t>(width); x < row; ++x)
            out.push_back(mask[x]);
    return out;
}

std::string CaptureWriter::open(const std::string& path) {
    std::string problem = file_.open(path);
    if (problem.empty())
        file_.write(magic);
    return problem;
}

void CaptureWriter::add(const DrawnFrame& frame, double microseconds) {
    const DrawnPicture& p = frame.picture;
    std::string out;
    put(out, is_frame);
    put(out, microseconds);
    put(out, std::int32_t{p.width});
    put(out, std::int32_t{p.height});
    put(out, std::int32_t{p.depth_bits});
    out.append(reinterpret_cast<const char*>(p.rgba.data()), p.rgba.size());
    out.append(reinterpret_cast<const char*>(p.depth.data()), p.depth.size() * sizeof p.depth[0]);
    const std::size_t pixels = p.rgba.size() / 4;
    for (std::size_t i = 0; i < pixels; ++i)
        out += static_cast<char>((frame.coverage.snapped[i] ? snapped : 0) |
                                 (frame.coverage.exact[i] ? exact : 0) | (frame.mask[i] ? drawn : 0));
    file_.write(out);
}

std::string CaptureWriter::finish(const CaptureEnd& end) {
    std::string out;
    put(out, is_end);
    put(out, end.frames);
    put(out, end.mismatches);
    put_text(out, end.missed);
    put(out, static_cast<std::uint64_t>(end.stages.size()));
    for (const StageError& stage : end.stages) {
        put_text(out, stage.stage);
        for (const std::uint64_t count : {stage.count, stage.saturated, stage.flips})
            put(out, count);
        for (const double figure : {stage.worst, stage.rms, stage.least, stage.greatest})
            put(out, figure);
    }
    file_.write(out);
    return file_.commit();
}

std::string CaptureReader::open(const std::string& path) {
    file_.open(path, std::ios::binary);
    std::string begin(magic.size(), '\0');
    if (!file_ || !file_.read(begin.data(), static_cast<std::streamsize>(begin.size())) || begin != magic)
        return "'" + path + "' is no capture of this build";
    return "";
}

bool CaptureReader::next(DrawnFrame& frame, double& microseconds) {
    std::int32_t kind = 0;
    if (is_complete_ || !get(file_, kind))
        return false;
    if (kind == is_end) {
        is_complete_ = read_end();
        return false;
    }
    DrawnPicture& p = frame.picture;
    std::int32_t width = 0, height = 0, bits = 0;
    if (kind != is_frame || !get(file_, microseconds) || !get(file_, width) || !get(file_, height) ||
        !get(file_, bits) || width < 0 || height < 0 || width > longest_side || height > longest_side)
        return false;
    p.width = width;
    p.height = height;
    p.depth_bits = bits;
    const std::size_t pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    p.rgba.resize(4 * pixels);
    p.depth.resize(bits != 0 ? pixels : 0);
    std::string flags(pixels, '\0');
    if (!file_.read(reinterpret_cast<char*>(p.rgba.data()), static_cast<std::streamsize>(p.rgba.size())) ||
        !file_.read(reinterpret_cast<char*>(p.depth.data()),
                    static_cast<std::streamsize>(p.depth.size() * sizeof p.depth[0])) ||
        !file_.read(flags.data(), static_cast<std::streamsize>(pixels)))
        return false;
    const auto flagged = [&flags](Flag flag) {
        std::vector<bool> out(flags.size());
        std::transform(flags.begin(), flags.end(), out.begin(), [flag](char c) { return (c & flag) != 0; });
        return out;
    };
    frame.coverage = {flagged(snapped), flagged(exact)};
    frame.mask = flagged(drawn);
    return true;
}

bool CaptureReader::read_end() {
    std::uint64_t count = 0;
    if (!get(file_, end_.frames) || !get(file_, end_.mismatches) || !get_text(file_, end_.missed) ||
        !get(file_, count) || count > most_stages)
        return false;
    for (std::uint64_t i = 0; i < count; ++i) {
        StageError stage{};
        std::string name;
        if (!get_text(file_, name) || !name_stage(name, stage))
            return false;
        for (std::uint64_t* const to : {&stage.count, &stage.saturated, &stage.flips})
            if (!get(file_, *to))
                return false;
        for (double* const to : {&stage.worst, &stage.rms, &stage.least, &stage.greatest})
            if (!get(file_, *to))
                return false;
        end_.stages.push_back(stage);
    }
    return true;
}

} // namespace spangle::trade
