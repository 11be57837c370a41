#include "tests/unit/hal_kernel/drm_card.hpp"

#include <cerrno>
#include <cstring>
#include <memory>
#include <stdexcept>
#include <string>

#include <drm_fourcc.h>
#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>
#include <xf86drm.h>
#include <xf86drmMode.h>

#include "tests/unit/hal_kernel/files.hpp"

namespace kernel_test {
namespace {

void demand(bool done, const char* what) {
    if (!done)
        throw std::runtime_error(std::string("DRM: ") + what + ": " + std::strerror(errno));
}

template <auto release> struct Release {
    template <class T> void operator()(T* what) const { release(what); }
};
using Resources = std::unique_ptr<drmModeRes, Release<drmModeFreeResources>>;
using Connector = std::unique_ptr<drmModeConnector, Release<drmModeFreeConnector>>;

} // namespace

/// The kernel makes the node a moment before the card behind it can be opened.
DrmCard::DrmCard(const char* path, unsigned bits) : bits_(bits) {
    await("open the card", [&] {
        file_ = open(path, O_RDWR | O_CLOEXEC);
        return file_ >= 0 || errno != ENODEV;
    });
    demand(file_ >= 0, path);
    set_mode();
}

DrmCard::~DrmCard() {
    if (pixels_ != nullptr)
        munmap(pixels_, size_);
    close(file_); // also frees buffer and framebuffer
}

void DrmCard::set_mode() {
    const Resources resources(drmModeGetResources(file_));
    demand(resources != nullptr && resources->count_connectors > 0, "resources");
    std::uint32_t connector_id = resources->connectors[0];
    const Connector connector(drmModeGetConnector(file_, connector_id));
    demand(connector != nullptr && connector->count_modes > 0, "modes of the connector");
    width_ = connector->modes[0].hdisplay;
    height_ = connector->modes[0].vdisplay;
    make_buffer();
    demand(drmModeSetCrtc(file_, resources->crtcs[0], framebuffer_, 0, 0, &connector_id, 1,
                          connector->modes) == 0,
           "mode set");
}

void DrmCard::make_buffer() {
    const auto width = static_cast<std::uint32_t>(width_), height = static_cast<std::uint32_t>(height_);
    demand(drmModeCreateDumbBuffer(file_, width, height, bits_, 0, &handle_, &pitch_, &size_) == 0, "buffer");
    const std::uint32_t handles[4] = {handle_}, pitches[4] = {pitch_}, offsets[4] = {};
    const std::uint32_t format = bits_ == 16 ? DRM_FORMAT_RGB565 : DRM_FORMAT_XRGB8888;
    demand(drmModeAddFB2(file_, width, height, format, handles, pitches, offsets, &framebuffer_, 0) == 0,
           "framebuffer");
    std::uint64_t offset = 0;
    demand(drmModeMapDumbBuffer(file_, handle_, &offset) == 0, "map");
    void* const mapped =
        mmap(nullptr, size_, PROT_READ | PROT_WRITE, MAP_SHARED, file_, static_cast<off_t>(offset));
    demand(mapped != MAP_FAILED, "mmap");
    pixels_ = static_cast<std::uint8_t*>(mapped);
    std::memset(pixels_, 0, size_);
}

std::uint8_t* DrmCard::at(int x, int y) const {
    return pixels_ + static_cast<std::size_t>(y) * pitch_ + static_cast<std::size_t>(x) * (bits_ / 8);
}

void DrmCard::put(int x, int y, std::uint32_t word) {
    std::memcpy(at(x, y), &word, bits_ / 8);
}

std::uint32_t DrmCard::get(int x, int y) const {
    std::uint32_t word = 0;
    std::memcpy(&word, at(x, y), bits_ / 8);
    return word;
}

void DrmCard::flush(spangle::Rect area) {
    drmModeClip clip = {static_cast<std::uint16_t>(area.x), static_cast<std::uint16_t>(area.y),
                        static_cast<std::uint16_t>(area.x + area.w),
                        static_cast<std::uint16_t>(area.y + area.h)};
    demand(drmModeDirtyFB(file_, framebuffer_, &clip, 1) == 0, "flush");
}

} // namespace kernel_test
