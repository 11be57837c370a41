#include <spangle/sim/verdict.hpp>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <sstream>

namespace spangle::sim {

namespace {

namespace fs = std::filesystem;

std::string color_text(const std::uint8_t* p) {
    char text[16];
    std::snprintf(text, sizeof text, "#%02X%02X%02X", p[0], p[1], p[2]);
    return std::string(text) + (p[3] == 255 ? "" : " alpha " + std::to_string(p[3]));
}

std::string size_text(const Image& image) {
    return std::to_string(image.width) + "x" + std::to_string(image.height);
}

std::string describe(const Mismatch& m, const Image& actual, const Image& expected) {
    if (!m.same_size)
        return "it is " + size_text(actual) + ", expected is " + size_text(expected);
    return "the first of " + std::to_string(m.differing) + " differing pixels (of " +
           std::to_string(m.pixels) + ") is (" + std::to_string(m.first_x) + ", " +
           std::to_string(m.first_y) + "), " + color_text(actual.at(m.first_x, m.first_y)) + " instead of " +
           color_text(expected.at(m.first_x, m.first_y)) + "; the largest difference of a channel is " +
           std::to_string(m.max_difference) + "/255";
}

/// Writes evidence of a failure. Returns "\n  actual: FILE", or why the file could not be written.
std::string write_evidence(const char* what, const Image& image, const std::string& path) {
    const std::string problem = write_png(image, path);
    std::error_code ignored;
    return std::string("\n  ") + what + ": " +
           (problem.empty() ? fs::absolute(path, ignored).string() : problem);
}

std::string leave_both(const Image& actual, const Image& expected, const std::string& stem) {
    return write_evidence("actual", actual, stem + ".actual.png") +
           write_evidence("difference", difference_picture(actual, expected), stem + ".difference.png");
}

bool updating() {
    const char* const wish = std::getenv("SPANGLE_UPDATE_GOLDEN");
    return wish != nullptr && std::string(wish) == "1";
}

Verdict update(const Image& actual, const std::string& golden) {
    if (const std::string problem = write_png(actual, golden); !problem.empty())
        return {false, problem};
    std::fprintf(stderr, "SPANGLE_UPDATE_GOLDEN: wrote %s\n", golden.c_str());
    return {};
}

/// The lines of the art. The line breaks around it belong to the raw string literal.
std::vector<std::string> rows_of(const std::string& art) {
    std::vector<std::string> rows;
    std::istringstream in(art.substr(!art.empty() && art.front() == '\n' ? 1 : 0));
    for (std::string row; std::getline(in, row);)
        rows.push_back(row);
    return rows;
}

/// What is wrong with the art itself; empty if nothing is.
std::string bad_art(const std::vector<std::string>& rows, const Legend& legend) {
    for (std::size_t y = 0; y < rows.size(); ++y) {
        if (rows[y].size() != rows[0].size())
            return "line " + std::to_string(y + 1) + " of the art has " + std::to_string(rows[y].size()) +
                   " characters, the first has " + std::to_string(rows[0].size());
        for (const char c : rows[y])
            if (c != '?' && legend.count(c) == 0)
                return std::string("the legend does not say what '") + c + "' is";
    }
    return "";
}

/// The art as a picture. Where a pixel of `actual` has the character's colour, the pixel is copied, because
/// it may hold more bits than the panel keeps.
Image draw(const std::vector<std::string>& rows, const Legend& legend, const Image& actual) {
    Image out(rows.empty() ? 0 : static_cast<int>(rows[0].size()), static_cast<int>(rows.size()));
    if (out.width != actual.width || out.height != actual.height)
        return out;
    for (int y = 0; y < out.height; ++y)
        for (int x = 0; x < out.width; ++x) {
            const char c = rows[static_cast<std::size_t>(y)][static_cast<std::size_t>(x)];
            const std::uint8_t* const is = actual.at(x, y);
            std::uint8_t* const to = out.at(x, y);
            std::copy_n(is, 4, to);
            if (c == '?')
                continue;
            const std::uint32_t color = legend.at(c);
            const std::uint8_t wanted[3] = {static_cast<std::uint8_t>(color >> 16),
                                            static_cast<std::uint8_t>(color >> 8),
                                            static_cast<std::uint8_t>(color)};
            if (is[0] >> 3 != wanted[0] >> 3 || is[1] >> 2 != wanted[1] >> 2 || is[2] >> 3 != wanted[2] >> 3)
                std::copy_n(wanted, 3, to);
        }
    return out;
}

} // namespace

Mismatch mismatch(const Image& actual, const Image& expected, int tolerance) {
    Mismatch m;
    m.same_size = actual.width == expected.width && actual.height == expected.height;
    if (!m.same_size)
        return m;
    for (int y = 0; y < actual.height; ++y)
        for (int x = 0; x < actual.width; ++x) {
            int worst = 0;
            for (int c = 0; c < 4; ++c)
                worst = std::max(worst, std::abs(actual.at(x, y)[c] - expected.at(x, y)[c]));
            ++m.pixels;
            m.max_difference = std::max(m.max_difference, worst);
            if (worst > tolerance && m.differing++ == 0) {
                m.first_x = x;
                m.first_y = y;
            }
        }
    return m;
}

Verdict check_golden(const Image& actual, const std::string& golden, int tolerance, Evidence evidence) {
    const std::string stem = fs::path(golden).replace_extension().string();
    std::error_code ignored;
    if (!fs::exists(golden, ignored)) {
        if (updating())
            return update(actual, golden);
        return {
            false,
            "there is no golden picture " + fs::absolute(golden, ignored).string() +
                "; look at what was drawn, and run once with SPANGLE_UPDATE_GOLDEN=1 if it is right" +
                (evidence == Evidence::none ? "" : write_evidence("actual", actual, stem + ".actual.png"))};
    }
    Image expected;
    if (const std::string problem = read_png(golden, expected); !problem.empty())
        return updating() ? update(actual, golden) : Verdict{false, problem};
    const Mismatch m = mismatch(actual, expected, tolerance);
    if (!m)
        return {};
    if (updating())
        return update(actual, golden);
    return {false, describe(m, actual, expected) + "\n  golden: " + fs::absolute(golden, ignored).string() +
                       (evidence == Evidence::none ? "" : leave_both(actual, expected, stem))};
}

Verdict check_hash(const Image& actual, const std::string& expected, const std::string& evidence_stem) {
    const std::string is = hash(actual);
    if (is == expected)
        return {};
    return {
        false,
        "its hash is " + is + " instead of " + expected +
            (evidence_stem.empty() ? "" : write_evidence("actual", actual, evidence_stem + ".actual.png"))};
}

Verdict check_ascii(const Image& actual, const std::string& art, const Legend& legend,
                    const std::string& evidence_stem) {
    const std::vector<std::string> rows = rows_of(art);
    if (const std::string problem = bad_art(rows, legend); !problem.empty())
        return {false, problem};
    const Image expected = draw(rows, legend, actual);
    const Mismatch m = mismatch(actual, expected);
    if (!m)
        return {};
    return {false,
            describe(m, actual, expected) +
                (m.same_size && actual.width <= 100 ? "; it looks like\n" + to_ascii(actual, legend) : "") +
                (evidence_stem.empty() ? "" : leave_both(actual, expected, evidence_stem))};
}

} // namespace spangle::sim
