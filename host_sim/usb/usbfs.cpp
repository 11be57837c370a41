#include "host_sim/usb/usbfs.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <mutex>

#include <fcntl.h>
#include <linux/ioctl.h>
#include <linux/usbdevice_fs.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace spangle::sim {
namespace {

constexpr unsigned usb_major = 189;
constexpr std::size_t page = 4096;
constexpr std::uint32_t capabilities = USBDEVFS_CAP_ZERO_PACKET | USBDEVFS_CAP_BULK_CONTINUATION |
                                       USBDEVFS_CAP_NO_PACKET_SIZE_LIM | USBDEVFS_CAP_REAP_AFTER_DISCONNECT;

} // namespace

class UsbfsFile final : public OpenFile {
  public:
    explicit UsbfsFile(UsbfsDevice& device) : device_(device), descriptors_(device.function_.descriptors()) {
        int ends[2] = {-1, -1};
        if (pipe2(ends, O_NONBLOCK | O_CLOEXEC) != 0)
            return;
        read_end_ = ends[0];
        write_end_ = ends[1];
        fcntl(write_end_, F_SETPIPE_SZ, page);
        fill();
        device_.files_.push_back(this);
    }
    ~UsbfsFile() override {
        hang_up();
        std::erase(device_.files_, this);
    }

    int descriptor() override { return write_end_; }

    void hang_up() {
        if (read_end_ >= 0)
            ::close(read_end_);
        read_end_ = -1;
        is_gone_ = true;
    }

    long read(void* into, std::size_t count) override {
        const std::size_t left = position_ < descriptors_.size() ? descriptors_.size() - position_ : 0;
        const std::size_t taken = std::min(count, left);
        if (taken != 0) // nothing is copied for a device without descriptors
            std::memcpy(into, descriptors_.data() + position_, taken);
        position_ += taken;
        return static_cast<long>(taken);
    }
    long seek(long offset) override {
        position_ = static_cast<std::size_t>(offset);
        return offset;
    }

    long ioctl(unsigned long request, void* argument, std::size_t) override {
        switch (request) {
        case USBDEVFS_CONNECTINFO:
            *static_cast<usbdevfs_connectinfo*>(argument) = {2, 0};
            return 0;
        case USBDEVFS_GET_CAPABILITIES:
            *static_cast<std::uint32_t*>(argument) = capabilities;
            return 0;
        case USBDEVFS_GET_SPEED:
            return 3; // USB_SPEED_HIGH
        case USBDEVFS_GETDRIVER:
            if (!device_.kernel_driver)
                return -ENODATA;
            std::memcpy(static_cast<usbdevfs_getdriver*>(argument)->driver, "gud", 4);
            return 0;
        case USBDEVFS_IOCTL: // disconnects or connects the kernel's driver
            return set_driver(static_cast<const usbdevfs_ioctl*>(argument)->ioctl_code ==
                              static_cast<int>(USBDEVFS_CONNECT));
        case USBDEVFS_DISCONNECT_CLAIM:
            set_driver(false);
            [[fallthrough]];
        case USBDEVFS_CLAIMINTERFACE:
            return device_.kernel_driver || device_.claimed_elsewhere ? -EBUSY : 0;
        case USBDEVFS_RELEASEINTERFACE:
        case USBDEVFS_SETINTERFACE:
            return 0;
        case USBDEVFS_CLEAR_HALT:
            device_.function_.clear_halt();
            return 0;
        case USBDEVFS_CONTROL:
            return control(*static_cast<usbdevfs_ctrltransfer*>(argument));
        case USBDEVFS_SUBMITURB:
            return submit(static_cast<usbdevfs_urb*>(argument));
        case USBDEVFS_DISCARDURB:
            return discard_urb(static_cast<usbdevfs_urb*>(argument));
        case USBDEVFS_REAPURBNDELAY:
            return reap_urb(static_cast<usbdevfs_urb**>(argument));
        default:
            return -ENOTTY;
        }
    }
    /// Transfers of a device that went are still reaped.
    bool answers_when_dead(unsigned long request) const override { return request == USBDEVFS_REAPURBNDELAY; }

  private:
    UsbfsDevice& device_;
    std::vector<std::uint8_t> descriptors_;
    std::size_t position_ = 0;
    int read_end_ = -1, write_end_ = -1;
    bool is_gone_ = false;
    std::deque<usbdevfs_urb*> pending_urbs_,
        completed_urbs_; ///< transfers that the device has; transfers to be reaped

    void fill() {
        const char zeros[page] = {};
        // The program's own write() is interposed, and would take this file for a device.
        while (syscall(SYS_write, write_end_, zeros, page) > 0) {
        }
    }
    void drain() {
        char bytes[page];
        while (read_end_ >= 0 && ::read(read_end_, bytes, page) > 0) {
        }
    }
    long set_driver(bool attached) {
        device_.kernel_driver = attached;
        return 0;
    }
    long control(usbdevfs_ctrltransfer& c) {
        const UsbSetup setup = {c.bRequestType, c.bRequest, c.wValue, c.wIndex, c.wLength};
        std::vector<std::uint8_t> in;
        if (!device_.function_.control(setup, static_cast<const std::uint8_t*>(c.data), in))
            return -EPIPE;
        std::copy(in.begin(), in.end(), static_cast<std::uint8_t*>(c.data));
        return static_cast<long>(in.size());
    }

    long submit(usbdevfs_urb* urb) {
        if (is_gone_)
            return -ENODEV;
        urb->actual_length = 0;
        urb->status = -EINPROGRESS;
        pending_urbs_.push_back(urb);
        device_.most_under_way =
            std::max(device_.most_under_way, static_cast<int>(pending_urbs_.size() + completed_urbs_.size()));
        run();
        return 0;
    }

    long discard_urb(usbdevfs_urb* urb) {
        const auto it = std::find(pending_urbs_.begin(), pending_urbs_.end(), urb);
        if (it == pending_urbs_.end())
            return -EINVAL;
        pending_urbs_.erase(it);
        finish(urb, -ENOENT);
        return 0;
    }

    long reap_urb(usbdevfs_urb** urb) {
        if (completed_urbs_.empty()) {
            if (!is_gone_)
                fill();
            return is_gone_ ? -ENODEV : -EAGAIN;
        }
        *urb = completed_urbs_.front();
        completed_urbs_.pop_front();
        return 0;
    }

    void finish(usbdevfs_urb* urb, int status) {
        urb->status = status;
        completed_urbs_.push_back(urb);
        drain();
    }

    /// Works off the transfers in order, until the device keeps one.
    void run() {
        while (!pending_urbs_.empty()) {
            usbdevfs_urb* const urb = pending_urbs_.front();
            const bool bulk = urb->type == USBDEVFS_URB_TYPE_BULK;
            const auto fate = bulk && device_.fate
                                  ? device_.fate(static_cast<std::size_t>(urb->buffer_length))
                                  : UsbfsDevice::Fate::normal;
            if (fate == UsbfsDevice::Fate::silent)
                return;
            pending_urbs_.pop_front();
            switch (fate) {
            case UsbfsDevice::Fate::unplug:
                finish(urb, -ESHUTDOWN);
                for (usbdevfs_urb* other : pending_urbs_)
                    finish(other, -ESHUTDOWN);
                pending_urbs_.clear();
                device_.unplug();
                return;
            case UsbfsDevice::Fate::stall:
                finish(urb, -EPIPE);
                break;
            case UsbfsDevice::Fate::error:
                finish(urb, -EPROTO);
                break;
            default:
                finish(urb, carry(*urb, fate == UsbfsDevice::Fate::cut));
            }
        }
    }

    int send(usbdevfs_urb& urb, std::size_t count) {
        if (!device_.function_.bulk_out(urb.endpoint, static_cast<const std::uint8_t*>(urb.buffer), count))
            return -EPIPE;
        urb.actual_length = static_cast<int>(count);
        return 0;
    }

    int receive(usbdevfs_urb& urb) {
        std::vector<std::uint8_t> in;
        if (!device_.function_.bulk_in(urb.endpoint, static_cast<std::size_t>(urb.buffer_length), in))
            return -EPIPE;
        std::copy(in.begin(), in.end(), static_cast<std::uint8_t*>(urb.buffer));
        urb.actual_length = static_cast<int>(in.size());
        return 0;
    }

    int carry(usbdevfs_urb& urb, bool cut) {
        if (urb.type != USBDEVFS_URB_TYPE_BULK)
            return setup(urb);
        const auto count = static_cast<std::size_t>(urb.buffer_length);
        return (urb.endpoint & 0x80) != 0 ? receive(urb) : send(urb, cut ? count / 2 : count);
    }

    int setup(usbdevfs_urb& urb) {
        auto* const bytes = static_cast<std::uint8_t*>(urb.buffer);
        const auto word = [&](int at) { return static_cast<std::uint16_t>(bytes[at] | bytes[at + 1] << 8); };
        const UsbSetup setup = {bytes[0], bytes[1], word(2), word(4), word(6)};
        std::vector<std::uint8_t> in;
        if (!device_.function_.control(setup, bytes + 8, in))
            return -EPIPE;
        std::copy(in.begin(), in.end(), bytes + 8);
        urb.actual_length = static_cast<int>((setup.type & 0x80) != 0 ? in.size() : setup.length);
        return 0;
    }
};

void UsbfsDevice::attach(Kernel& kernel, const std::string& path) {
    kernel_ = &kernel;
    path_ = path;
    kernel.add_device(path, *this, usb_major, 1);
}

void UsbfsDevice::unplug() {
    // No call on a file of the device may run meanwhile, because it would write into a pipe that nobody
    // reads.
    const std::lock_guard lock(*kernel_);
    kernel_->unplug(path_);
    for (UsbfsFile* file : files_)
        file->hang_up();
}

void UsbfsDevice::plug() {
    kernel_->plug(path_);
}

std::unique_ptr<OpenFile> UsbfsDevice::open() {
    return std::make_unique<UsbfsFile>(*this);
}

int UsbfsDevice::gone_error() const {
    return ENODEV;
}

} // namespace spangle::sim
