// The functions that the page's script calls. One view is shown; choices that are compared with native ones
// have views of their own.
#include <cstdio>
#include <string>

#include <emscripten/emscripten.h>

#include "host_sim/page/view.hpp"

using namespace spangle;

namespace {

page::View shown;
sim::Image picture;
std::string text; // the last returned text, valid until the next call

const char* keep(std::string words) {
    text = std::move(words);
    return text.c_str();
}

std::uint8_t* keep(sim::Image image) {
    picture = std::move(image);
    return picture.rgba.data();
}

std::string lines(int count, const char* (*name)(int), const char* (*title)(int)) {
    std::string list;
    for (int i = 0; i < count; ++i)
        list += std::string(name(i)) + "\t" + title(i) + "\n";
    return list;
}

} // namespace

extern "C" {

/// The functions for lists return a line for each entry: name, tab, title.
EMSCRIPTEN_KEEPALIVE const char* page_scenes() {
    return keep(lines(
        scenes::all().count, [](int i) { return scenes::all().first[i].id; },
        [](int i) { return scenes::all().first[i].title; }));
}
EMSCRIPTEN_KEEPALIVE const char* page_boards() {
    return keep(lines(
        page::board_count(), [](int i) { return page::board_of(i).name; },
        [](int i) { return page::board_of(i).summary; }));
}
EMSCRIPTEN_KEEPALIVE const char* page_formats(int board) {
    std::string list;
    for (const page::Format& format : page::formats_of(page::board_of(board)))
        list += std::string(format.name) + "\n";
    return keep(list);
}

EMSCRIPTEN_KEEPALIVE const char* page_open(int board, int scene, int tier, int format) {
    return keep(shown.open({board, scene, tier, format}));
}
EMSCRIPTEN_KEEPALIVE int page_has_camera() {
    return shown.has_camera() ? 1 : 0;
}
EMSCRIPTEN_KEEPALIVE void page_orbit(float yaw, float pitch) {
    shown.orbit(yaw, pitch);
}
/// Draws the next frame, or the last one again.
EMSCRIPTEN_KEEPALIVE const char* page_draw(int next) {
    return keep(shown.draw(next != 0));
}
EMSCRIPTEN_KEEPALIVE const char* page_present() {
    return keep(shown.present());
}

EMSCRIPTEN_KEEPALIVE std::uint8_t* page_glass() {
    return keep(shown.glass());
}
EMSCRIPTEN_KEEPALIVE std::uint8_t* page_memory() {
    return keep(shown.memory());
}
EMSCRIPTEN_KEEPALIVE int page_width() {
    return picture.width;
}
EMSCRIPTEN_KEEPALIVE int page_height() {
    return picture.height;
}

EMSCRIPTEN_KEEPALIVE double page_busy_ns() {
    return static_cast<double>(shown.counters().busy_ns);
}
EMSCRIPTEN_KEEPALIVE int page_frame_bytes() {
    return static_cast<int>(shown.log().bytes());
}
EMSCRIPTEN_KEEPALIVE int page_frame_commands() {
    return static_cast<int>(shown.log().commands());
}
EMSCRIPTEN_KEEPALIVE const char* page_violations() {
    return keep(shown.violations());
}

/// Returns a line for each command of the last frame: its byte, and the first of the bytes that follow.
EMSCRIPTEN_KEEPALIVE const char* page_bus() {
    std::string list;
    char word[32];
    for (const page::BusLog::Entry& entry : shown.log().entries()) {
        std::snprintf(word, sizeof word, entry.has_command ? "%02X " : "-- ", entry.command);
        list += word;
        const std::size_t told =
            entry.bytes < page::BusLog::most_bytes ? entry.bytes : page::BusLog::most_bytes;
        for (std::size_t i = 0; i < told; ++i) {
            std::snprintf(word, sizeof word, " %02x", entry.first[i]);
            list += word;
        }
        if (entry.bytes > told) {
            std::snprintf(word, sizeof word, " ... %u bytes", static_cast<unsigned>(entry.bytes));
            list += word;
        }
        list += '\n';
    }
    return keep(list);
}

EMSCRIPTEN_KEEPALIVE const char* page_digest(int board, int scene, int tier, int format) {
    return keep(page::digest_of({board, scene, tier, format}));
}

} // extern "C"
