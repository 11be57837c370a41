// How different do two pictures look? A mean after FLIP (Andersson and others, 2020): both pictures are
// blurred as the eye does at 67 pixels a degree, and compared as colours of CIELab by the HyAB distance.
// FLIP's second part, which raises the error at edges and points, is left out: this is "FLIP-like", and
// figures of the two are not to be mixed.
#pragma once

#include <spangle/sim/image.hpp>

namespace spangle::trade {

/// 0: the same; 1: pure green against pure blue. Mean over all pixels; both pictures have one size.
double perceived_difference(const sim::Image& a, const sim::Image& b);

} // namespace spangle::trade
