#pragma once
/// \file
/// Follows the solutions of polynomial systems along a straight line in the space of their parameters, many at once,
/// each in a lane of its own.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "synthesis/exact/homotopy/linear_system.h"
#include "synthesis/program/run_end.h"

namespace mechwright::homotopy {

struct TrackingOptions {
    double prediction_error = 1e-5;  ///< that a step aims at, relative to the solution
    double correction_error = 1e-6;  ///< of the last correction of a step, at most
    double least_step = 1e-8;
    int most_steps = 5000;
};

enum class PathEnd : std::uint8_t {
    reached,   ///< the other end, with a converging Newton correction there
    diverged,  ///< grew beyond all bounds
    too_slow,  ///< needed steps too small, or too many
};

/// How a path ended: where, and what it took.
template <class System>
struct TrackedPath {
    std::array<Complex<double>, System::size> point;
    PathEnd end = PathEnd::too_slow;
    double reached = 0;          ///< how far along the line, 0 to 1
    double last_correction = 0;  ///< relative, at the end
    int steps = 0;
};

/// The work of one group of N lanes of T. What becomes of a path depends neither on its lane nor on the other paths.
template <class System, class T, std::size_t N>
class Tracker {
public:
    using Values = std::array<Complex<double>, System::size>;
    using ParameterValues = std::array<Complex<double>, System::parameters>;

    Tracker(const System& system, const ParameterValues& from, const ParameterValues& to,
            const TrackingOptions& options)
        : system_(system), options_(options) {
        for (std::size_t i = 0; i < System::parameters; ++i) {
            from_[i] = {T(from[i].re), T(from[i].im)};
            along_[i] = {T(to[i].re - from[i].re), T(to[i].im - from[i].im)};
            to_[i] = {T(to[i].re), T(to[i].im)};
        }
    }

    /// `take` gives the number of another path, or a negative one if there is none. Paths begin at `starts[i].point`,
    /// where their parameters are so far along the line as `starts[i].reached` says. Paths that are not over when the
    /// run ends are left as they are in `out`.
    template <class Take>
    void run(const std::vector<TrackedPath<System>>& starts, const Take& take, const RunEnd& end,
             std::vector<TrackedPath<System>>& out) {
        lanes_.fill(Lane{});
        for (std::size_t i = 0; i < N; ++i)
            load(i, take(), starts);
        while (busy() && !end.reached()) {
            step();
            for (std::size_t i = 0; i < N; ++i) {
                if (lanes_[i].path < 0 || !ended(i)) continue;
                out[static_cast<std::size_t>(lanes_[i].path)] = result(i);
                load(i, take(), starts);
            }
        }
    }

private:
    struct Lane {
        std::ptrdiff_t path = -1;
        double t = 0;
        double step = 0;
        double last_correction = 0;
        int steps = 0;
        bool failed = false;
    };
    using Point = std::array<Complex<T>, System::size>;
    using Parameters = std::array<Complex<T>, System::parameters>;

    bool busy() const {
        for (const Lane& lane : lanes_)
            if (lane.path >= 0) return true;
        return false;
    }

    void load(std::size_t i, std::ptrdiff_t path, const std::vector<TrackedPath<System>>& starts) {
        constexpr double first_part = 0.01;
        lanes_[i] = Lane{};
        lanes_[i].path = path;
        if (path < 0) return;  // the lane goes on with what it has, to no purpose
        const TrackedPath<System>& start = starts[static_cast<std::size_t>(path)];
        lanes_[i].t = start.reached;
        lanes_[i].step = first_part * (1 - start.reached);
        for (std::size_t k = 0; k < System::size; ++k) {
            set_lane(at_[k].re, i, start.point[k].re);
            set_lane(at_[k].im, i, start.point[k].im);
        }
    }

    TrackedPath<System> result(std::size_t i) const {
        TrackedPath<System> path;
        for (std::size_t k = 0; k < System::size; ++k)
            path.point[k] = {lane_of(at_[k].re, i), lane_of(at_[k].im, i)};
        const Lane& lane = lanes_[i];
        path.reached = lane.t;
        path.steps = lane.steps;
        path.last_correction = lane.last_correction;
        path.end = lane.t >= 1 ? PathEnd::reached : PathEnd::too_slow;
        double size = 0;
        for (const Complex<double>& value : path.point)
            size = std::max(size, norm(value));
        if (lane.t < 1 && !(size < greatest_size * greatest_size)) path.end = PathEnd::diverged;
        return path;
    }

    bool ended(std::size_t i) const {
        const Lane& lane = lanes_[i];
        return lane.failed || lane.t >= 1;
    }

    Parameters parameters_at(const T& t) const {
        Parameters p;
        for (std::size_t i = 0; i < System::parameters; ++i)
            p[i] = from_[i] + t * along_[i];
        return p;
    }

    void tangent(const Point& u, const T& t, Point& out) {
        system_.linearise(u, parameters_at(t), &along_, matrix_);
        solve(matrix_);
        for (std::size_t k = 0; k < System::size; ++k)
            out[k] = matrix_[k][System::size];
    }

    /// One Newton correction; the square of its greatest part.
    T correct(Point& u, const Parameters& p) {
        system_.linearise(u, p, static_cast<const Parameters*>(nullptr), matrix_);
        solve(matrix_);
        T greatest = T(0.0);
        for (std::size_t k = 0; k < System::size; ++k) {
            u[k] = u[k] + matrix_[k][System::size];
            const T here = norm(matrix_[k][System::size]);
            greatest = select(greatest < here, here, greatest);
        }
        return greatest;
    }

    static T size_of(const Point& u) {
        T greatest = T(0.0);
        for (const Complex<T>& value : u) {
            const T here = norm(value);
            greatest = select(greatest < here, here, greatest);
        }
        return greatest;
    }

    /// The rule of order 4 of Runge and Kutta. Its stages are a loop, which has its body once: with all that it calls
    /// made part of it, it is long.
    void predict(const T& t, const T& h, Point& out) {
        constexpr std::array<double, 4> reach{0.0, 0.5, 0.5, 1.0};
        std::array<Point, 4> slope;
        slope[3] = Point{};  // none yet before the first stage
        for (std::size_t stage = 0; stage < reach.size(); ++stage) {
            const T part = T(reach[stage]) * h;
            Point moved;
            for (std::size_t k = 0; k < System::size; ++k)
                moved[k] = at_[k] + part * slope[(stage + 3) % 4][k];
            tangent(moved, t + part, slope[stage]);
        }
        const T sixth = (T(1.0) / T(6.0)) * h;
        for (std::size_t k = 0; k < System::size; ++k)
            out[k] = at_[k] + sixth * (slope[0][k] + T(2.0) * (slope[1][k] + slope[2][k]) + slope[3][k]);
    }

    /// One step of every lane: order 4 of Runge and Kutta, then Newton's corrections.
    void step() {
        T t, h;
        for (std::size_t i = 0; i < N; ++i) {
            set_lane(t, i, lanes_[i].t);
            lanes_[i].step = std::min(lanes_[i].step, 1 - lanes_[i].t);
            set_lane(h, i, lanes_[i].step);
        }
        Point there;
        predict(t, h, there);
        const Parameters p = parameters_at(t + h);
        std::array<T, 2> correction;
        for (T& greatest : correction)
            greatest = correct(there, p);
        const T size = size_of(there);
        for (std::size_t i = 0; i < N; ++i)
            conclude(i, std::sqrt(lane_of(correction[0], i)), std::sqrt(lane_of(correction[1], i)),
                     std::sqrt(lane_of(size, i)), there);
    }

    /// Takes the step of a lane, or makes it shorter.
    void conclude(std::size_t i, double first, double second, double size, const Point& there) {
        Lane& lane = lanes_[i];
        if (lane.path < 0) return;
        ++lane.steps;
        const double predicted = first / size, corrected = second / size;
        // The error of a step grows with its fifth power.
        const double wanted = 0.9 * std::pow(options_.prediction_error / std::max(predicted, 1e-16), 0.2);
        const bool good = corrected < options_.correction_error && predicted < 30 * options_.prediction_error;
        if (good) {
            const bool last = lane.step >= 1 - lane.t;
            lane.t = last ? 1 : lane.t + lane.step;
            lane.last_correction = corrected;
            for (std::size_t k = 0; k < System::size; ++k) {
                copy_lane(at_[k].re, there[k].re, i);
                copy_lane(at_[k].im, there[k].im, i);
            }
            lane.step *= std::min(wanted, 3.0);
        } else {
            lane.step *= std::isfinite(predicted) ? std::clamp(wanted, 0.1, 0.5) : 0.25;
        }
        const bool too_slow = lane.step < options_.least_step || lane.steps >= options_.most_steps;
        lane.failed = lane.t < 1 && (too_slow || (good && !(size < greatest_size)));
    }

    static constexpr double greatest_size = 1e8;

    System system_;
    TrackingOptions options_;
    Parameters from_, along_, to_;
    std::array<Lane, N> lanes_{};
    Point at_{};
    Augmented<T, System::size> matrix_;
};

}  // namespace mechwright::homotopy
