// Tells how different two pictures look: a mean after FLIP (Andersson and others, 2020). Both pictures are
// blurred as the eye does at 67 pixels a degree, and compared as colours of CIELab by the HyAB distance.
// FLIP's second part, which raises the error at edges and points, is left out. The measure is therefore
// "FLIP-like", and its figures must not be mixed with those of FLIP.
#pragma once

#include <spangle/sim/image.hpp>

namespace spangle::trade {

/// The mean difference over all pixels of two pictures of one size. 0: the same; 1: pure green against pure
/// blue.
double perceived_difference(const sim::Image& a, const sim::Image& b);

} // namespace spangle::trade
