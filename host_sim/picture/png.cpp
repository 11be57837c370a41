#include <spangle/sim/image.hpp>

#include <cstring>

#include <png.h>

#include "host_sim/output/output.hpp"

namespace spangle::sim {

std::string encode_png(const Image& image, std::string& out) {
    if (image.rgba.empty())
        return "the picture is empty";
    png_image png;
    std::memset(&png, 0, sizeof png);
    png.version = PNG_IMAGE_VERSION;
    png.width = static_cast<png_uint_32>(image.width);
    png.height = static_cast<png_uint_32>(image.height);
    png.format = PNG_FORMAT_RGBA;
    // An opaque picture is written without the alpha that it does not use.
    std::vector<std::uint8_t> opaque;
    bool see_through = false;
    for (std::size_t i = 3; i < image.rgba.size(); i += 4)
        see_through = see_through || image.rgba[i] != 255;
    const void* pixels = image.rgba.data();
    if (!see_through) {
        png.format = PNG_FORMAT_RGB;
        for (std::size_t i = 0; i < image.rgba.size(); i += 4)
            opaque.insert(opaque.end(), &image.rgba[i], &image.rgba[i] + 3);
        pixels = opaque.data();
    }
    png_alloc_size_t size = 0;
    if (png_image_write_to_memory(&png, nullptr, &size, 0, pixels, 0, nullptr) == 0)
        return png.message;
    out.resize(size);
    if (png_image_write_to_memory(&png, out.data(), &size, 0, pixels, 0, nullptr) == 0)
        return png.message;
    out.resize(size);
    return "";
}

std::string write_png(const Image& image, const std::string& path) {
    std::string bytes;
    const std::string problem = encode_png(image, bytes);
    return problem.empty() ? write_file(path, bytes) : "cannot write '" + path + "': " + problem;
}

namespace {

/// Finishes what png_image_begin_read_from_... began. It frees `png`, whether the picture was read or not.
std::string finish_reading(png_image& png, Image& out) {
    const std::uint64_t width = png.width, height = png.height;
    if (width > longest_side || height > longest_side || width * height > most_pixels) {
        png_image_free(&png);
        return "it is " + std::to_string(width) + "x" + std::to_string(height) + "; at most " +
               std::to_string(longest_side) + " pixels a side and " + std::to_string(most_pixels >> 20) +
               " Mi together are read";
    }
    png.format = PNG_FORMAT_RGBA;
    Image image(static_cast<int>(width), static_cast<int>(height));
    if (png_image_finish_read(&png, nullptr, image.rgba.data(), 0, nullptr) == 0)
        return png.message;
    out = std::move(image);
    return "";
}

png_image reader() {
    png_image png;
    std::memset(&png, 0, sizeof png);
    png.version = PNG_IMAGE_VERSION;
    return png;
}

} // namespace

std::string read_png(const std::string& path, Image& out) {
    png_image png = reader();
    const std::string problem = png_image_begin_read_from_file(&png, path.c_str()) == 0
                                    ? std::string(png.message)
                                    : finish_reading(png, out);
    return problem.empty() ? "" : "cannot read '" + path + "': " + problem;
}

std::string decode_png(std::string_view bytes, Image& out) {
    png_image png = reader();
    return png_image_begin_read_from_memory(&png, bytes.data(), bytes.size()) == 0 ? std::string(png.message)
                                                                                   : finish_reading(png, out);
}

} // namespace spangle::sim
