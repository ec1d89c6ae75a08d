#pragma once
/// \file
/// The screening of path_screening.h for any mechanism whose guiding link starts at the crank pin, in lanes.

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>

#include "analysis/four_bar/pose.h"
#include "analysis/numbers/lanes.h"
#include "synthesis/mechanism/path_screening.h"

namespace mechwright {

/// Sums over the targets, complex ones as vectors.
template <class T>
struct PathMoments {
    T weight{0.0};
    Vector<T> p{0.0, 0.0};
    Vector<T> w{0.0, 0.0};
    Vector<T> target{0.0, 0.0};
    T pp{0.0};
    T ww{0.0};
    T tt{0.0};
    Vector<T> wp{0.0, 0.0};  ///< conj(w) p
    Vector<T> wt{0.0, 0.0};  ///< conj(w) target
    Vector<T> pt{0.0, 0.0};  ///< conj(p) target
    Vector<T> wf{0.0, 0.0};  ///< conj(w) facing
};

/// conj(a) b
template <class T>
Vector<T> conjugate_product(const Vector<T>& a, const Vector<T>& b) {
    return {dot(a, b), cross(a, b)};
}

template <class T>
T square(const Vector<T>& a) {
    return dot(a, a);
}

/// The moments about the means, as far as the origin is free.
template <class T>
PathMoments<T> about_means(const PathMoments<T>& m, const PathFreedom& free) {
    if (!free.origin) return m;
    PathMoments<T> c = m;
    const T per = T(1.0) / m.weight;
    c.pp -= square(m.p) * per;
    c.ww -= square(m.w) * per;
    c.tt -= square(m.target) * per;
    c.wp = m.wp - per * conjugate_product(m.w, m.p);
    c.wt = m.wt - per * conjugate_product(m.w, m.target);
    c.pt = m.pt - per * conjugate_product(m.p, m.target);
    return c;
}

template <class T>
struct ScoreAndSize {
    T score;
    T size;
};

template <class T>
ScoreAndSize<T> eliminated(const PathMoments<T>& moments, const PathFreedom& free) {
    using std::sqrt;
    const PathMoments<T> m = about_means(moments, free);
    const T none(0.0);
    const T tiny(1e-300);
    // The guided point takes what lies along w.
    const T per_w = select(m.ww > tiny, T(T(1.0) / m.ww), none);
    const T pp = m.pp - square(m.wp) * per_w;
    const T tt = m.tt - square(m.wt) * per_w;
    const Vector<T> pt = m.pt - per_w * conjugate_product(m.wp, m.wt);
    const T per_p = select(pp > tiny, T(T(1.0) / pp), none);
    // Size and tilt take what lies along p, as far as they are free.
    const Vector<T> axis{T(free.tilted.x), T(free.tilted.y)};
    const T along = free.tilt ? sqrt(square(pt)) : dot(axis, pt);
    const T size = free.size ? T(along * per_p) : T(1.0);
    // A guided body faces as well as it can on average: |f - D w|^2 = 2 - 2 |sum conj(w) f| for the best |D| = 1.
    const T length_square(free.body_length * free.body_length);
    const T turned = length_square * T(2.0) * (m.weight - sqrt(square(m.wf)));
    const T score = (tt - (size + size) * along + size * size * pp + turned) / m.tt;
    return {select(size > none, score, T(1.0)), size};
}

/// The screening of a mechanism whose guiding link starts at the crank pin, as many candidates at a time as T has
/// lanes. `Guide` has `static constexpr std::size_t lengths` and `template <class T> static auto direction(std::size_t
/// assembly, const std::array<T, lengths>&, const HalfTurn<T>&)`, which gives `pin`, `link` and `margin`, < 0 where the
/// mechanism does not assemble.
template <class Guide, class T>
Screened screened(std::size_t assembly, std::span<const Group> lengths, std::span<const ScreenedPoint> points,
                  const PathFreedom& free) {
    Screened out;
    for (std::size_t first = 0; first < out.score.size(); first += T::count) {
        std::array<T, Guide::lengths> links;
        for (std::size_t i = 0; i < Guide::lengths; ++i)
            links[i].read(lengths[i].data() + first);
        PathMoments<T> m;
        T margin(std::numeric_limits<double>::infinity());
        for (const ScreenedPoint& point : points) {
            const HalfTurn<T> half{T(point.half.x), T(point.half.y)};
            const T weight(point.weight);
            const Vector<T> target{T(point.target.x), T(point.target.y)};
            const auto guide = Guide::direction(assembly, links, half);
            margin = select(guide.margin < margin, guide.margin, margin);
            const Vector<T> p = guide.pin;
            const Vector<T> w = guide.link;
            m.weight += weight;
            m.p = m.p + weight * p;
            m.w = m.w + weight * w;
            m.target = m.target + weight * target;
            m.pp += weight * square(p);
            m.ww += weight * square(w);
            m.tt += weight * square(target);
            m.wp = m.wp + weight * conjugate_product(w, p);
            m.wt = m.wt + weight * conjugate_product(w, target);
            m.pt = m.pt + weight * conjugate_product(p, target);
            const Vector<T> facing{T(point.facing.x), T(point.facing.y)};
            m.wf = m.wf + weight * conjugate_product(w, facing);
        }
        const ScoreAndSize<T> s = eliminated(m, free);
        const T score = select(margin < T(0.0), T(std::numeric_limits<double>::infinity()), s.score);
        score.write(out.score.data() + first);
        s.size.write(out.size.data() + first);
    }
    return out;
}

}  // namespace mechwright
