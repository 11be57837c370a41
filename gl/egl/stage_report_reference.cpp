// Reports the errors that the shadow policy measures in each stage, for programs outside of this repository.
#include <spangle/reference.hpp>

#include "raster/reference/shadow.hpp"

namespace spangle {

struct StageReport::Records {
    raster::ShadowReport report;
    raster::ShadowReport* outer = nullptr;
};

StageReport::StageReport() : records_(std::make_unique<Records>()) {
    records_->outer = raster::report_shadow(&records_->report);
}

StageReport::~StageReport() {
    raster::report_shadow(records_->outer);
}

std::vector<StageError> StageReport::stages() const {
    std::vector<StageError> out;
    for (int i = 0; i < raster::shadow_stages; ++i) {
        const auto stage = static_cast<raster::ShadowStage>(i);
        const raster::ShadowRecord& r = records_->report[stage];
        if (r.count != 0)
            out.push_back({raster::name_of(stage), raster::unit_of(stage), r.count, r.worst, r.rms(), r.least,
                           r.greatest, r.saturated, r.flips});
    }
    return out;
}

void StageReport::clear() {
    records_->report = {};
}

} // namespace spangle
