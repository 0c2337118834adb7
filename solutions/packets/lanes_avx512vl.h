// Eight doubles in two registers of thirty-two, and masks in registers of their own: processors with AVX-512 whose own
// full registers slow down what is done in halves beside them (NOTES.md).
#pragma once

#include "packets/float_masks.h"
#include "packets/reals_in_pairs.h"

namespace rays::packets {

/// For each lane yes or no.
struct Mask {
    __mmask8 lo, hi;  ///< four lanes each, in the lower bits

    unsigned bits() const { return static_cast<unsigned>(lo) | static_cast<unsigned>(hi) << 4; }
    bool any() const { return (lo | hi) != 0; }

    static Mask of(unsigned bits) { return halves(bits & 15, bits >> 4); }

    friend Mask operator&(Mask a, Mask b) { return halves(a.lo & b.lo, a.hi & b.hi); }
    friend Mask operator|(Mask a, Mask b) { return halves(a.lo | b.lo, a.hi | b.hi); }
    friend Mask operator^(Mask a, Mask b) { return halves(a.lo ^ b.lo, a.hi ^ b.hi); }
    /// a, but where b.
    friend Mask operator-(Mask a, Mask b) { return halves(a.lo & ~b.lo, a.hi & ~b.hi); }

private:
    template <class Bits>
    static Mask halves(Bits lo, Bits hi) {
        return {static_cast<__mmask8>(lo), static_cast<__mmask8>(hi)};
    }
};

template <int how>
Mask compared(Reals a, Reals b) {
    return {_mm256_cmp_pd_mask(a.lo, b.lo, how), _mm256_cmp_pd_mask(a.hi, b.hi, how)};
}

inline Reals select(Mask where, Reals then, Reals otherwise) {
    return {_mm256_mask_blend_pd(where.lo, otherwise.lo, then.lo),
            _mm256_mask_blend_pd(where.hi, otherwise.hi, then.hi)};
}

/// As floats see it.
inline FloatMask narrow(Mask m) { return static_cast<FloatMask>(m.bits()); }
/// As doubles see it.
inline Mask widen(FloatMask mask) { return Mask::of(mask); }

}  // namespace rays::packets
