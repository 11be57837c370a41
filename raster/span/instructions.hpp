// What runs fragments is compiled once for each instruction set that a build can choose at run time. Its
// names lie in a namespace of the set, so that no two sets share a function: the linker would keep one of
// them, and a processor may lack its instructions. Types that all sets share lie outside of it.
#pragma once

#ifndef SPANGLE_INSTRUCTIONS
/// The namespace: base, what the compiler's options allow, or avx2 (chain_avx2.cpp).
#define SPANGLE_INSTRUCTIONS base
#endif
