// Who listens to the wires: a text log, a VCD file.
#pragma once

#include <cstdint>
#include <cstdio>
#include <string>

#include <spangle/sim/violations.hpp>

namespace spangle::sim {

class Listener {
  public:
    virtual ~Listener() = default;
    virtual void byte(Time begin, unsigned period_ns, bool data, std::uint8_t value) = 0;
    virtual void chip_select(Time at, bool selected) = 0;
    virtual void reset(Time at, bool low) = 0;
};

/// Value change dump for GTKWave or PulseView. Serial: CS DC SCK SDA RST; parallel: CS DC WR D[7:0] RST.
class VcdFile final : public Listener {
  public:
    VcdFile(const std::string& path, bool parallel);
    ~VcdFile() override;
    VcdFile(const VcdFile&) = delete;
    VcdFile& operator=(const VcdFile&) = delete;
    bool good() const { return file_ != nullptr; }

    void byte(Time begin, unsigned period_ns, bool data, std::uint8_t value) override;
    void chip_select(Time at, bool selected) override;
    void reset(Time at, bool low) override;

  private:
    std::FILE* file_;
    bool parallel_;
    int dc_ = -1, sda_ = -1;
    Time last_ = ~Time{0};

    void at(Time t);
};

} // namespace spangle::sim
